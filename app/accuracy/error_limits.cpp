#include "app/accuracy/error_limits.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "base/error.h"
#include "base/number_text.h"
#include "base/words.h"

namespace isolux::app {

namespace {

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

[[noreturn]] void refuse(const std::string& reason) {
  base::throwUsage("", "--error", reason);
}

// The number at the text's beginning, and the rest, its unit; nothing where there is no number.
std::optional<std::pair<double, std::string>> numberWithUnit(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || !std::isfinite(number)) return std::nullopt;
  return std::pair(number, std::string(rest, end));
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
  refuse("unknown error \"" + name + '"' +
         base::didYouMean(name, known, "; there are " + base::joined(known, " ")));
}

const UnitOfError& unitNamed(const std::string& quantity, const std::string& unit, const std::string& word) {
  std::string known;
  for (const UnitOfError& each : kUnits) {
    if (quantity != each.quantity) continue;
    if (unit == each.unit) return each;
    known += (known.empty() ? "" : " or ") + (*each.unit ? std::string(each.unit) : "no unit");
  }
  refuse('"' + word + "\": " + quantity + " is stated in " + known +
         (unit.empty() ? "" : ", not in \"" + unit + '"'));
}

Limit limitOf(const std::string& word) {
  const std::size_t equals = word.find('=');
  const std::string name = word.substr(0, equals);
  requireQuantity(name);
  if (equals == std::string::npos) refuse('"' + word + "\" is not QUANTITY=VALUE");
  const auto number = numberWithUnit(word.substr(equals + 1));
  if (!number) refuse('"' + word + "\" has no number behind its '='");
  const UnitOfError& known = unitNamed(name, number->second, word);
  const Limit limit{known.measured, known.scale * number->first};
  if (limit.quantity == Quantity::missed) {
    if (limit.most < 0.0 || limit.most > 1.0) refuse('"' + word + "\" is not between 0 and 100 %");
  } else if (!(limit.most > 0.0)) {
    refuse('"' + word + "\" is not above 0");
  }
  return limit;
}

const UnitOfError& unitOf(Quantity quantity) {
  return *std::ranges::find(kUnits, quantity, &UnitOfError::measured);
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
        refuse(std::string(nameOf(limit.quantity)) + " is given twice");
    limits.push_back(limit);
  }
  if (limits.empty()) refuse("contains no error; for example depth=0.01mm");
  return limits;
}

double parseTimeTarget(const std::string& text) {
  const auto number = numberWithUnit(text);
  const std::string unit = number ? number->second : "";
  const double scale = unit == "ms" ? 1.0 : unit == "s" ? 1000.0 : 0.0;
  if (scale == 0.0 || !(number->first > 0.0))
    base::throwUsage("", "--time", '"' + text + "\" is not a time such as 100ms or 0.1s");
  return scale * number->first;
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
