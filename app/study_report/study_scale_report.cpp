#include "app/study_report/study_scale_report.h"

#include <ostream>

#include <nlohmann/json.hpp>

#include "app/study/scale_study.h"
#include "app/study_report/study_table.h"

namespace isolux::app {

nlohmann::ordered_json scaleJson(const StudySetting& setting) {
  const ScaleCost& cost = setting.scale.value();
  const NoiseErrors& errors = setting.errors.noise;
  return {{"scale_mm", cost.scaleMm},
          {"build_seconds", cost.buildSeconds},
          {"unknown_share", cost.unknown},
          {"points", errors.curvature.pixels / kNoiseSeeds},
          {"seeds", kNoiseSeeds},
          {"curvature_median_relative", errors.curvature.median},
          {"curvature_99_relative", errors.curvature.most99},
          {"normal_rms_degrees", errors.normalDegrees.rms},
          {"normal_99_degrees", errors.normalDegrees.most99}};
}

void writeScaleTable(std::ostream& out, const KnobStudy& study) {
  out << "Noise of deviation " << tableNumber(study.addedNoise) << " data units is added, " << kNoiseSeeds
      << " times. ";
  if (study.knowsTruth)
    out << "Errors are relative to the phantom without noise at scale 0: the effects of noise and of "
           "smoothing.";
  else
    out << "The volume's own noise has that deviation, and its reference is unknown. Errors are the change "
           "due to added noise at the same scale, as between two scans of one object. They exclude the "
           "effect of smoothing on the shape.";
  out << "\n\n";
  const Panel& panel = panelsOf(study.knob)[0];
  std::vector<TableColumn> columns{
      {"scale, mm", [](const StudySetting& s) { return tableNumber(s.scale.value().scaleMm); }},
      {"field, s", [](const StudySetting& s) { return tableNumber(s.scale.value().buildSeconds); }},
      {"hessian, ms (quartiles)",
       [&](const StudySetting& s) { return tableTime(costSpread(study.knob, s, panel)); }},
      {"curvature median, %",
       [](const StudySetting& s) { return tableNumber(100.0 * s.errors.noise.curvature.median); }},
      {"normal RMS, °", [](const StudySetting& s) { return tableNumber(s.errors.noise.normalDegrees.rms); }},
      {"no confidence, %",
       [](const StudySetting& s) { return tableNumber(100.0 * s.scale.value().unknown); }}};
  const std::vector<TableColumn> picture = pictureColumns(study);
  columns.insert(columns.end(), picture.begin(), picture.end());
  writeTable(out, study, columns);
}

}  // namespace isolux::app
