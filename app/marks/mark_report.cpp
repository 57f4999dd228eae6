#include "app/marks/mark_report.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/files/csv_field.h"
#include "app/files/json_text.h"
#include "app/marks/mark_kinds.h"
#include "base/decimal_text.h"
#include "base/number_text.h"
#include "base/printable.h"
#include "base/words.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

std::string positionsText(const std::vector<glm::dvec3>& points) {
  return base::joined(points, "; ", [](const glm::dvec3& p) {
    return base::shortestText(p.x) + ' ' + base::shortestText(p.y) + ' ' + base::shortestText(p.z);
  });
}

std::string spaced(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

}  // namespace

std::string quantityText(const MarkQuantity& quantity) {
  const std::string unit =
      quantity.unit.empty() || quantity.unit == "°" ? quantity.unit : ' ' + quantity.unit;
  const double error = quantity.error.value_or(0.0), size = std::abs(quantity.value);
  if (!quantity.error) return base::shortText(quantity.value, 4) + unit;
  if (!(error > 0.0) || !(size < 1e9) || error < 1e-6 || error >= 1e9)
    return base::shortText(quantity.value) + (error > 0.0 ? " ± " + base::shortText(error, 2) : "") + unit;
  // Two digits of the error.
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(error))));
  return base::fixedText(quantity.value, decimals) + " ± " + base::fixedText(error, decimals) + unit;
}

std::string summaryText(const MarkReport& report) {
  if (report.pending) return report.quantities.empty() ? "…" : quantityText(report.quantities.front()) + " …";
  if (!report.problem.empty()) return report.problem;
  return report.quantities.empty() ? std::string() : quantityText(report.quantities.front());
}

std::string fullText(const scene::Mark& mark, const MarkReport& report) {
  std::string text = base::printable(mark.name) + " (" + markKind(mark.kind).name + ")\n";
  if (!report.place.empty()) text += "  " + report.place + '\n';
  for (const MarkQuantity& quantity : report.quantities)
    text += "  " + spaced(quantity.name) + ": " + quantityText(quantity) + '\n';
  if (!report.problem.empty()) text += "  not measured: " + report.problem + '\n';
  for (const std::string& note : report.notes) text += "  note: " + note + '\n';
  return text;
}

ordered_json markJson(const scene::Mark& mark, const MarkReport& report) {
  ordered_json json{{"name", mark.name}, {"kind", markKind(mark.kind).name}, {"points_mm", mark.points}};
  if (!report.place.empty()) json["place"] = report.place;
  ordered_json& quantities = json["quantities"] = ordered_json::object();
  for (const MarkQuantity& quantity : report.quantities)
    quantities[quantity.name] = {
        {"value", quantity.value}, {"error", quantity.error}, {"unit", quantity.unit}};
  if (report.centre) json["centre_mm"] = *report.centre;
  if (!report.line.empty()) json["path_mm"] = report.line;
  json["notes"] = report.notes;
  json["problem"] = report.problem.empty() ? ordered_json() : ordered_json(report.problem);
  return json;
}

std::string marksCsv(std::span<const scene::Mark> marks, std::span<const MarkReport> reports) {
  std::string text = "mark,kind,points_mm,quantity,value,error,unit,notes\n";
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const std::string first = csvWords(marks[i].name) + ',' + markKind(marks[i].kind).name + ',' +
                              csvField(positionsText(marks[i].points)) + ',';
    const MarkReport& report = reports[i];
    std::vector<std::string> notes{report.problem};
    notes.insert(notes.end(), report.notes.begin(), report.notes.end());
    const std::string last = ',' + csvField(base::joined(notes, "; ")) + '\n';
    const auto addLine = [&](const std::string& middle) { text.append(first).append(middle).append(last); };
    if (report.quantities.empty()) addLine(",,,");
    for (const MarkQuantity& quantity : report.quantities)
      addLine(quantity.name + ',' + base::shortestText(quantity.value) + ',' +
              (quantity.error ? base::shortestText(*quantity.error) : "") + ',' + csvWords(quantity.unit));
  }
  return text;
}

}  // namespace isolux::app
