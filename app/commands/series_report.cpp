#include "app/commands/series_report.h"

#include <algorithm>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/browser/index_job.h"
#include "app/browser/series_text.h"
#include "app/commands/command.h"
#include "app/documents/anonymous.h"
#include "app/runtime/progress_bar.h"
#include "base/printable.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;
using volume::DicomSeries;

struct Listed {
  std::vector<DicomSeries> series;  // by patient, study and number
  volume::DicomIndexEnd end;
};

Listed listedSeries(const std::string& folder, base::Progress& progress) {
  progress.report(0.0, "looking for series");
  const ProgressBar bar(progress);
  Listed listed;
  listed.end = volume::indexDicom(
      folder, [&](DicomSeries one) { addSeries(listed.series, std::move(one)); }, progress);
  const auto key = [](const DicomSeries& s) {
    const bool numbered = !s.number.empty() && s.number.size() < 9 &&
                          std::ranges::all_of(s.number, [](char c) { return c >= '0' && c <= '9'; });
    return std::tuple(s.patient.name, s.patient.id, s.patient.birthDate, s.studyDate, s.study,
                      numbered ? std::stoi(s.number) : -1, s.series);
  };
  std::ranges::sort(listed.series,
                    [&](const DicomSeries& a, const DicomSeries& b) { return key(a) < key(b); });
  return listed;
}

// Numbers patients in the order in which they stand.
void hidePatients(std::vector<DicomSeries>& all) {
  std::vector<volume::Patient> known;
  for (DicomSeries& series : all) {
    const volume::Patient patient = series.patient;
    auto at = std::ranges::find(known, patient);
    if (at == known.end()) at = known.insert(known.end(), patient);
    series.patient = {kAnonymous + std::string(" ") + std::to_string(at - known.begin() + 1), {}, {}};
    for (std::string* text : {&series.description, &series.studyDescription, &series.problem})
      *text = withoutPatient(*text, patient);
    for (std::string& warning : series.warnings) warning = withoutPatient(warning, patient);
  }
}

ordered_json seriesJson(const DicomSeries& s, bool hidden) {
  ordered_json json;
  json["patient"] = personText(s.patient.name);
  if (!hidden) {
    json["patient_id"] = s.patient.id;
    json["birth_date"] = dateText(s.patient.birthDate);
  }
  json["study"] = s.study;
  json["study_description"] = s.studyDescription;
  json["study_date"] = dateText(s.studyDate);
  json["series"] = s.series;
  json["number"] = s.number;
  json["description"] = s.description;
  json["modality"] = s.modality;
  json["date"] = dateText(s.date);
  json["kernel"] = s.kernel;
  json["slices"] = s.slices;
  json["time_steps"] = s.timeSteps;
  json["size"] = {s.columns, s.rows};
  json["spacing_mm"] = s.spacingMm;
  if (!hidden) json["folder"] = s.folder;
  json["problem"] = s.problem.empty() ? ordered_json(nullptr) : ordered_json(s.problem);
  json["warnings"] = s.warnings;
  return json;
}

// The fields that are known, with a comma between.
std::string factsOf(const DicomSeries& s) {
  std::string text;
  for (const std::string& part : {s.modality, dateText(s.date), slicesText(s) + " slices", sizeText(s),
                                  spacingText(s), s.kernel.empty() ? s.kernel : "kernel " + s.kernel})
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  return text;
}

void printText(const Listed& listed, bool hidden, std::ostream& out) {
  const auto line = [&](int indent, const std::string& text) {
    out << std::string(static_cast<std::size_t>(indent), ' ') << base::printable(text) << '\n';
  };
  const DicomSeries* before = nullptr;
  for (const DicomSeries& s : listed.series) {
    const bool samePatient = before && before->patient == s.patient;
    if (!samePatient) {
      std::string who = s.patient.name.empty() ? "no name" : personText(s.patient.name);
      if (!s.patient.id.empty()) who += ", id " + s.patient.id;
      if (!s.patient.birthDate.empty()) who += ", born " + dateText(s.patient.birthDate);
      line(0, who);
    }
    if (!samePatient || before->study != s.study)
      line(2, (s.studyDescription.empty() ? "study" : s.studyDescription) + ' ' + dateText(s.studyDate));
    line(4, titleOf(s) + ": " + factsOf(s));
    line(6, s.series);
    if (!hidden) line(6, s.folder);
    if (!s.problem.empty()) line(6, "cannot be opened: " + s.problem);
    for (const std::string& warning : s.warnings) line(6, "warning: " + warning);
    before = &s;
  }
}

}  // namespace

void printSeries(const std::string& folder, bool json, bool hidden, base::Progress& progress,
                 std::ostream& out) {
  Listed listed = listedSeries(folder, progress);
  if (listed.series.empty())
    base::throwInput(folder, "",
                     listed.end.unreadable > 0 ? "no usable DICOM image; " + listed.end.firstReason
                                               : "has no DICOM images");
  if (hidden) hidePatients(listed.series);
  if (json) {
    ordered_json list = ordered_json::array();
    for (const DicomSeries& series : listed.series) list.push_back(seriesJson(series, hidden));
    out << jsonText({{"files", listed.end.files}, {"unreadable", listed.end.unreadable}, {"series", list}});
  } else {
    printText(listed, hidden, out);
  }
  if (listed.end.unreadable > 0)
    printNote(std::to_string(listed.end.unreadable) + " DICOM files are unreadable and left out" +
              (hidden ? "" : "; the first: " + listed.end.firstReason));
}

}  // namespace isolux::app
