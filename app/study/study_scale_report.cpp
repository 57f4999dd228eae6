#include "app/study/study_scale_report.h"

#include <ostream>

#include <nlohmann/json.hpp>

#include "app/study/scale_study.h"
#include "app/study/study_table.h"
#include "render/graph/pass.h"

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
    out << "Errors are those against the phantom without noise at scale 0: what noise adds and what "
           "smoothing takes.";
  else
    out << "The volume's own noise has that deviation. Its truth is not known: errors are what the addition "
           "changes at "
           "the same scale, as far as another scan of the same would differ. What smoothing takes from the "
           "shape is not among "
           "them.";
  out << "\n\n| " << study.knob.label
      << " | scale, mm | field, s | hessian, ms | frame, ms | curvature median, % | 99 % | normal RMS, ° | "
         "99 % | no confidence, % |\n"
         "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
  for (const StudySetting& setting : study.settings) {
    const ScaleCost& cost = setting.scale.value();
    const NoiseErrors& errors = setting.errors.noise;
    const auto hessian = setting.passMilliseconds.find(render::pass::hessian);
    out << "| " << markedValue(setting) << " | " << tableNumber(cost.scaleMm) << " | "
        << tableNumber(cost.buildSeconds) << " | "
        << (hessian == setting.passMilliseconds.end() ? "–" : tableNumber(hessian->second)) << " | "
        << tableNumber(setting.frameMilliseconds) << " | " << tableNumber(100.0 * errors.curvature.median)
        << " | " << tableNumber(100.0 * errors.curvature.most99) << " | "
        << tableNumber(errors.normalDegrees.rms) << " | " << tableNumber(errors.normalDegrees.most99) << " | "
        << tableNumber(100.0 * cost.unknown) << " |\n";
  }
}

}  // namespace isolux::app
