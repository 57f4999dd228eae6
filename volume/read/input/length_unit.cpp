#include "volume/read/input/length_unit.h"

#include <algorithm>
#include <utility>

#include "volume/read/input/spacing_reliability.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

std::optional<double> millimetresIn(std::string_view unit) {
  static const std::pair<const char*, double> units[] = {
      {"femtometer", 1e-12}, {"fm", 1e-12},       {"picometer", 1e-9},
      {"pm", 1e-9},          {"angstrom", 1e-7},  {"\u00c5", 1e-7},
      {"\u212b", 1e-7},      {"nanometer", 1e-6}, {"nm", 1e-6},
      {"micrometer", 1e-3},  {"micron", 1e-3},    {"um", 1e-3},
      {"\u00b5m", 1e-3},     {"\u03bcm", 1e-3},   {"\\u00b5m", 1e-3},  // as ImageJ escapes it
      {"&#181;m", 1e-3},                                               // as XML may
      {"&#xb5;m", 1e-3},     {"millimeter", 1.0}, {"mm", 1.0},
      {"centimeter", 10.0},  {"cm", 10.0},        {"decimeter", 100.0},
      {"dm", 100.0},         {"meter", 1e3},      {"m", 1e3},
      {"kilometer", 1e6},    {"km", 1e6},         {"inch", 25.4},
      {"in", 25.4},          {"foot", 304.8},     {"ft", 304.8},
      {"yard", 914.4}};
  std::string name = lowered(trimmed(unit));
  if (name == "inches") return 25.4;
  if (name.ends_with("metre") || name.ends_with("metres")) name.replace(name.rfind("metre"), 5, "meter");
  if (name.ends_with("meters") || name == "microns" || name == "angstroms") name.pop_back();
  for (const auto& [known, mm] : units)
    if (name == known) return mm;
  return std::nullopt;
}

double millimetresOr1(std::string_view unit, std::string_view statement, std::vector<std::string>& warnings) {
  if (const auto mm = millimetresIn(unit)) return *mm;
  std::string warning = "the file names no unit of length: a unit of ";
  if (!unit.empty() || !statement.empty())
    warning = "the unit of length " + inQuotes(unit) +
              (statement.empty() ? "" : " (" + std::string(statement) + ")") + " is not known: ";
  warning += kSpacingAssumed;
  if (std::ranges::find(warnings, warning) == warnings.end()) warnings.push_back(warning);
  return 1.0;
}

}  // namespace isolux::volume
