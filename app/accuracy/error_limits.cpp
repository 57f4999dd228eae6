#include "app/accuracy/error_limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "base/error.h"
#include "base/number_text.h"
#include "base/words.h"

namespace isolux::app {

namespace {

using base::Error;
using base::ErrorKind;

struct UnitOfError {
  const char *quantity, *unit, *key;
  Quantity measured;
  double scale;  // times the number as it is written
};
// The first unit of a quantity is the one that texts have.
constexpr UnitOfError kUnits[] = {{"depth", "mm", "depth_mm", Quantity::depthMm, 1.0},
                                  {"depth", "vox", "depth_voxels", Quantity::depthVoxels, 1.0},
                                  {"missed", "%", "missed", Quantity::missed, 0.01},
                                  {"missed", "", "missed", Quantity::missed, 1.0},
                                  {"normal", "deg", "normal_degrees", Quantity::normal, 1.0},
                                  {"curvature", "%", "curvature", Quantity::curvature, 0.01},
                                  {"light", "%", "light", Quantity::light, 0.01}};

[[noreturn]] void refuse(const char* option, const std::string& reason) {
  throw Error(ErrorKind::usage, "", option, reason);
}

// The number at the text's beginning; the rest, its unit, is left in `text`.
double takeNumber(std::string& text, const char* option, const std::string& word) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || !std::isfinite(number))
    refuse(option, '"' + word + "\" has no number behind its '='");
  text.erase(0, static_cast<std::size_t>(rest - text.data()));
  return number;
}

std::vector<std::string> namesOfQuantities() {
  std::vector<std::string> names;
  for (const UnitOfError& unit : kUnits)
    if (names.empty() || names.back() != unit.quantity) names.emplace_back(unit.quantity);
  return names;
}

void requireQuantity(const std::string& name) {
  const std::vector<std::string> known = namesOfQuantities();
  if (std::ranges::find(known, name) != known.end()) return;
  refuse("--error", "unknown error \"" + name + '"' +
                        base::didYouMean(name, known, "; there are " + base::joined(known, " ")));
}

const UnitOfError& unitNamed(const std::string& quantity, const std::string& unit, const std::string& word) {
  std::string known;
  for (const UnitOfError& each : kUnits) {
    if (quantity != each.quantity) continue;
    if (unit == each.unit) return each;
    known += (known.empty() ? "" : " or ") + (*each.unit ? std::string(each.unit) : "no unit");
  }
  refuse("--error", '"' + word + "\": " + quantity + " is stated in " + known +
                        (unit.empty() ? "" : ", not in \"" + unit + '"'));
}

Limit limitOf(const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  requireQuantity(name);
  if (equals == std::string::npos) refuse("--error", '"' + word + "\" is not QUANTITY=VALUE");
  std::string unit = word.substr(equals + 1);
  const double number = takeNumber(unit, "--error", word);
  const UnitOfError& known = unitNamed(name, unit, word);
  const Limit limit{known.measured, known.scale * number};
  if (limit.quantity == Quantity::missed) {
    if (limit.most < 0.0 || limit.most > 1.0) refuse("--error", '"' + word + "\" is not between 0 and 100 %");
  } else if (!(limit.most > 0.0)) {
    refuse("--error", '"' + word + "\" is not above 0");
  }
  return limit;
}

const UnitOfError& unitOf(Quantity quantity) {
  return *std::find_if(std::begin(kUnits), std::end(kUnits),
                       [&](const UnitOfError& unit) { return unit.measured == quantity; });
}

}  // namespace

const char* nameOf(Quantity quantity) {
  return unitOf(quantity).quantity;
}

const char* keyOf(Quantity quantity) {
  return unitOf(quantity).key;
}

std::vector<Limit> parseErrorTarget(const std::string& text) {
  std::vector<Limit> limits;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    const Limit limit = limitOf(word);
    for (const Limit& other : limits)
      if (std::string(nameOf(other.quantity)) == nameOf(limit.quantity))
        refuse("--error", std::string(nameOf(limit.quantity)) + " is given twice");
    limits.push_back(limit);
  }
  if (limits.empty()) refuse("--error", "contains no error; for example depth=0.01mm");
  return limits;
}

double parseTimeTarget(const std::string& text) {
  std::string unit = text;
  double number = 0.0;
  const char* const end = unit.data() + unit.size();
  const auto [rest, error] = std::from_chars(unit.data(), end, number);
  const std::string behind(rest, end);
  const double scale = behind == "ms" ? 1.0 : behind == "s" ? 1000.0 : 0.0;
  if (error != std::errc{} || scale == 0.0 || !std::isfinite(number) || !(number > 0.0))
    refuse("--time", '"' + text + "\" is not a time such as 100ms or 0.1s");
  return scale * number;
}

std::string errorText(Quantity quantity, double error) {
  if (std::isnan(error)) return "not measured";
  const UnitOfError& unit = unitOf(quantity);
  const std::string name = quantity == Quantity::depthVoxels ? "voxels"
                           : quantity == Quantity::normal    ? "degrees"
                                                             : unit.unit;
  return base::shortText(error / unit.scale, 3) + ' ' + name;
}

// "depth at most 0.01 mm", "missed at most 0.1 %", "normal at most 0.5 degrees", "curvature at most 5 %",
// "light at most 2 %"; the window translates them (ui/language/sentences.cpp).
std::string limitsText(std::span<const Limit> limits) {
  return base::joined(limits, ", ", [](const Limit& limit) {
    return std::string(nameOf(limit.quantity)) + " at most " + errorText(limit.quantity, limit.most);
  });
}

}  // namespace isolux::app
