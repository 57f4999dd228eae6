#include "app/report/measure_marks.h"

#include <sstream>

#include <nlohmann/json.hpp>

#include "app/marks/mark_evaluator.h"
#include "app/marks/markups_file.h"
#include "base/printable.h"

namespace isolux::app {

WantedMarks marksToMeasure(const std::string& file, const scene::Scene& scene) {
  if (file.empty()) return {scene.marks, {}};
  ReadMarks read = readMarkups(file);
  for (std::string& note : read.notes) note.insert(0, file + ": ");
  return {std::move(read.marks), std::move(read.notes)};
}

MeasuredMarks measuredMarks(std::vector<scene::Mark> marks,
                            const std::shared_ptr<const volume::PreparedVolume>& volume,
                            const scene::Scene& resolved, bool anyway, base::Progress& progress) {
  MeasuredMarks measured{std::move(marks), {}};
  MarkEvaluator evaluator(volume, resolved, anyway);
  for (const scene::Mark& mark : measured.marks)
    measured.reports.push_back(evaluator.evaluate(mark, progress));
  return measured;
}

nlohmann::ordered_json marksJson(const MeasuredMarks& measured) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < measured.marks.size(); ++i)
    list.push_back(markJson(measured.marks[i], measured.reports[i]));
  return list;
}

void printMarks(const MeasuredMarks& measured, std::ostream& out) {
  for (std::size_t i = 0; i < measured.marks.size(); ++i) {
    std::istringstream lines(fullText(measured.marks[i], measured.reports[i]));
    for (std::string line; std::getline(lines, line);) out << base::printable(line) << '\n';
  }
}

}  // namespace isolux::app
