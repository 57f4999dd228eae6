#include "app/error_budget/target_report.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "base/words.h"

namespace isolux::app {

using nlohmann::ordered_json;

namespace {

// Two digits and no exponent: "1200", "0.57".
std::string roundText(double milliseconds) {
  return base::shortText(milliseconds < 100.0 ? milliseconds : 10.0 * std::round(milliseconds / 10.0),
                         milliseconds < 100.0 ? 2 : 12);
}

ordered_json errorsJson(const TargetErrors& errors) {
  ordered_json json = ordered_json::object();
  for (const Quantity quantity : kAllQuantities) {
    const ErrorBound& error = errors[indexOf(quantity)];
    if (!std::isnan(error.value))
      json[keyOf(quantity)] = {{"measured", error.value}, {"at_most", error.bound}};
  }
  return json;
}

ordered_json settingsJson(const Candidate& candidate) {
  ordered_json json = ordered_json::object();
  for (const std::string& assignment : candidate.assignments) {
    const std::size_t equals = assignment.find('=');
    json[assignment.substr(0, equals)] = assignment.substr(equals + 1);
  }
  return json;
}

std::string settingsText(const Candidate& candidate) {
  const std::string text = base::joined(candidate.assignments, " ");
  return text.empty() ? "the settings as they are" : text;
}

std::string lineOf(const TargetAnswer& answer, std::size_t index) {
  const MeasuredCandidate& one = answer.measured[index];
  std::string text = index == answer.chosen ? "* " : "  ";
  text += "work " + base::shortText(one.candidate.cost, 3);
  if (!std::isnan(one.milliseconds)) text += ", " + roundText(one.milliseconds) + " ms";
  for (const Limit& limit : answer.limits) {
    const ErrorBound& error = one.errors[indexOf(limit.quantity)];
    if (!std::isnan(error.bound))
      text += std::string(", ") + nameOf(limit.quantity) + ' ' + errorText(limit.quantity, error.bound);
  }
  return text + ": " + settingsText(one.candidate);
}

}  // namespace

ordered_json targetJson(const TargetAnswer& answer) {
  ordered_json json;
  ordered_json limits = ordered_json::array();
  for (std::size_t i = 0; i < answer.limits.size(); ++i)
    limits.push_back({{"quantity", keyOf(answer.limits[i].quantity)},
                      {"at_most", answer.limits[i].most},
                      {"asked", i < answer.asked}});
  json["limits"] = limits;
  json["ignored"] = answer.notes;
  if (answer.measured.empty()) return json;
  const MeasuredCandidate& chosen = answer.measured[answer.chosen];
  json["chosen"] = {{"settings", settingsJson(chosen.candidate)}, {"reason", answer.reason}};
  json["expected_error"] = errorsJson(chosen.errors);
  json["expected_milliseconds"] = answer.expectedMilliseconds;
  ordered_json alternatives = ordered_json::array();
  for (const MeasuredCandidate& one : answer.measured)
    alternatives.push_back({{"settings", settingsJson(one.candidate)},
                            {"work", one.candidate.cost},
                            {"errors", errorsJson(one.errors)},
                            {"milliseconds", one.milliseconds}});
  json["alternatives"] = alternatives;
  return json;
}

std::vector<std::string> targetLines(const TargetAnswer& answer) {
  if (answer.measured.empty()) return {};
  const MeasuredCandidate& chosen = answer.measured[answer.chosen];
  std::vector<std::string> lines{"settings: " + settingsText(chosen.candidate) + ", chosen because " +
                                 answer.reason + "; a frame takes about " +
                                 roundText(answer.expectedMilliseconds) + " ms"};
  for (std::size_t i = 0; i < answer.measured.size(); ++i) lines.push_back(lineOf(answer, i));
  return lines;
}

}  // namespace isolux::app
