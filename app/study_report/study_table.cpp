#include "app/study_report/study_table.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "base/number_text.h"

namespace isolux::app {

std::string tableNumber(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  if (std::abs(value) >= 1000.0 && std::abs(value) < 1e6) return std::to_string(std::lround(value));
  return base::shortText(value, digits);
}

std::string tableTime(const TimeSpread& spread) {
  if (!std::isfinite(spread.median)) return "–";
  return tableNumber(spread.median) + " (" + tableNumber(spread.low) + "–" + tableNumber(spread.high) + ')';
}

std::string markedValue(const StudySetting& setting) {
  if (setting.isDefault) return "**" + setting.value + "** (default)";
  return setting.settingDefault ? setting.value + " (default where sampled)" : setting.value;
}

std::string costText(const Knob& knob, double cost) {
  const char* unit = " ms";
  if (knob.cost == Cost::bakeSeconds) unit = " s";
  if (knob.cost == Cost::gpuMegabytes) unit = " MiB";
  return tableNumber(cost) + unit;
}

std::string errorText(const Panel& panel, double error) {
  return tableNumber(panel.shown * error) + panel.unit;
}

std::vector<TableColumn> processorColumn(const KnobStudy& study) {
  if (study.settings.empty() || study.settings.front().processorTimes.empty()) return {};
  return {{"processor, ms (quartiles)",
           [](const StudySetting& setting) { return tableTime(spreadOfTimes(setting.processorTimes)); }}};
}

void writeTable(std::ostream& out, const KnobStudy& study, const std::vector<TableColumn>& columns) {
  out << "| " << study.knob.label;
  for (const TableColumn& column : columns) out << " | " << column.head;
  out << " |\n|---|";
  for (std::size_t i = 0; i < columns.size(); ++i) out << "---:|";
  out << '\n';
  for (const StudySetting& setting : study.settings) {
    out << "| " << markedValue(setting);
    for (const TableColumn& column : columns) out << " | " << column.cell(setting);
    out << " |\n";
  }
}

std::vector<TableColumn> pictureColumns(const KnobStudy& study) {
  // A look that does not show what the knob changes has one picture, and no columns.
  if (std::all_of(study.settings.begin(), study.settings.end(),
                  [](const StudySetting& setting) { return setting.errors.picture.rms == 0.0; }))
    return {};
  const std::string reference = pictureReference(study.knob);
  const std::string against = reference.empty() ? "256 rays" : '`' + reference + '`';
  return {{"FLIP to " + against,
           [](const StudySetting& setting) { return tableNumber(setting.errors.picture.flip, 2); }},
          {"RMS, of 255",
           [](const StudySetting& setting) { return tableNumber(255.0 * setting.errors.picture.rms, 2); }}};
}

}  // namespace isolux::app
