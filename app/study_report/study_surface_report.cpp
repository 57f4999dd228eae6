#include "app/study_report/study_surface_report.h"

#include <ostream>

#include "app/study_report/study_table.h"

namespace isolux::app {

namespace {

std::string passNames(const Panel& panel) {
  std::string names;
  for (const char* const pass : panel.passes) names += (names.empty() ? "" : " + ") + std::string(pass);
  return names;
}

std::vector<TableColumn> errorColumns(Measure measure, const Errors& (*errorsIn)(const StudySetting&)) {
  std::vector<TableColumn> columns;
  const auto add = [&](const char* head, auto number) {
    columns.push_back(
        {head, [=](const StudySetting& setting) { return tableNumber(number(errorsIn(setting))); }});
  };
  if (measure == Measure::hits) {
    columns.push_back({"missed pixels", [=](const StudySetting& setting) {
                         return std::to_string(errorsIn(setting).missed);
                       }});
    add("depth RMS, voxels", [](const Errors& e) { return e.depthVoxels.rms; });
    add("largest", [](const Errors& e) { return e.depthVoxels.maximum; });
  } else {
    add("normal RMS, °", [](const Errors& e) { return e.normalDegrees.rms; });
    add("curvature median, %", [](const Errors& e) { return 100.0 * e.curvature.median; });
  }
  return columns;
}

const Errors& ownErrors(const StudySetting& setting) {
  return setting.errors;
}

void append(std::vector<TableColumn>& columns, const std::vector<TableColumn>& more) {
  columns.insert(columns.end(), more.begin(), more.end());
}

std::vector<TableColumn> surfaceColumns(const KnobStudy& study) {
  const Knob& knob = study.knob;
  const auto& panels = panelsOf(knob);
  std::vector<TableColumn> columns{
      {"frame, ms", [](const StudySetting& setting) { return tableNumber(setting.frameMilliseconds); }}};
  const auto addTime = [&](const Panel& panel) {
    columns.push_back({passNames(panel) + ", ms (quartiles)", [&knob, &panel](const StudySetting& setting) {
                         return tableTime(costSpread(knob, setting, panel));
                       }});
  };
  append(columns, processorColumn(study));
  addTime(panels[0]);
  if (panels[0].passes != panels[1].passes) addTime(panels[1]);
  append(columns, errorColumns(knob.measure, ownErrors));
  append(columns, pictureColumns(study));
  return columns;
}

// Of a knob that is judged by the picture alone.
std::vector<TableColumn> wholePictureColumns(const KnobStudy& study) {
  const Knob& knob = study.knob;
  std::vector<TableColumn> columns{{"frame, ms (quartiles)", [&knob](const StudySetting& setting) {
                                      return tableTime(costSpread(knob, setting, panelsOf(knob)[0]));
                                    }}};
  append(columns, processorColumn(study));
  if (knob.measure == Measure::shadow)
    columns.push_back({"shadow, ms (quartiles)", [](const StudySetting& setting) {
                         const auto found = setting.passTimes.find("shadow");
                         return found == setting.passTimes.end() ? "–"
                                                                 : tableTime(spreadOfTimes(found->second));
                       }});
  else
    columns.push_back({"edges RMS, of 255", [](const StudySetting& setting) {
                         return tableNumber(255.0 * setting.errors.picture.edgeRms);
                       }});
  append(columns, pictureColumns(study));
  return columns;
}

void fieldTable(std::ostream& out, const KnobStudy& study) {
  out << "\nAgainst `cubic_interpolating` in double precision, the field that passes through every "
         "sample:\n\n";
  writeTable(out, study, errorColumns(study.knob.measure, judged));
}

}  // namespace

void writeSurfaceTables(std::ostream& out, const KnobStudy& study) {
  if (study.normalScaleMm > 0.0 || study.curvatureScaleMm > 0.0)
    out << "At the scales of the scene: normals " << tableNumber(study.normalScaleMm) << " mm, curvature "
        << tableNumber(study.curvatureScaleMm) << " mm.\n\n";
  writeTable(out, study, surfaceColumns(study));
  if (study.knob.field) fieldTable(out, study);
}

void writePictureTable(std::ostream& out, const KnobStudy& study) {
  writeTable(out, study, wholePictureColumns(study));
}

}  // namespace isolux::app
