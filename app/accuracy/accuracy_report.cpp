#include "app/accuracy/accuracy_report.h"

#include <cmath>

#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "volume/error/hit_error.h"

namespace isolux::app {

namespace {

nlohmann::ordered_json finiteOrNull(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json spreadJson(const BoundSpread& spread) {
  return {{"median", finiteOrNull(spread.median)}, {"most_99", finiteOrNull(spread.most99)}};
}

nlohmann::ordered_json lightJson(const Accuracy& accuracy) {
  if (std::isnan(accuracy.light.median)) return nullptr;
  return {{"level", kLightLevel},
          {"confidence", kLightConfidence},
          {"irradiance", spreadJson(accuracy.light)},
          {"relative", spreadJson(accuracy.relativeLight)},
          {"relative_within", finiteOrNull(accuracy.relativeLightWithin)}};
}

std::string figure(const std::string& what, double bound, const char* unit) {
  if (std::isnan(bound)) return "";
  return what + (std::isinf(bound) ? " not bounded" : " ± " + base::shortText(bound, 2) + unit) + ", ";
}

}  // namespace

nlohmann::ordered_json accuracyJson(const Accuracy& accuracy) {
  return {{"pixels", accuracy.pixels},
          {"seen", accuracy.seen},
          {"not_certain", accuracy.uncertain},
          {"not_certain_share", accuracy.uncertainShare()},
          {"level", volume::kErrorLevel},
          {"depth_mm", spreadJson(accuracy.depthMm)},
          {"normal_degrees", spreadJson(accuracy.normalDegrees)},
          {"kappa_per_mm", spreadJson(accuracy.curvature)},
          {"kappa_relative", spreadJson(accuracy.relativeCurvature)},
          {"light", lightJson(accuracy)},
          {"noise",
           {{"level", kNoiseLevel},
            {"depth_mm", spreadJson(accuracy.depthNoiseMm)},
            {"normal_degrees", spreadJson(accuracy.normalNoiseDegrees)},
            {"kappa_per_mm", spreadJson(accuracy.curvatureNoise)}}}};
}

std::string accuracyLine(const Accuracy& accuracy) {
  std::string line = "error bounds at the 99th percentile of visible pixels: ";
  if (accuracy.seen == accuracy.uncertain)
    line += accuracy.seen == 0 ? "nothing is visible, " : "nothing is visible for certain, ";
  else
    line += figure("depth by noise and sampling", accuracy.depthNoiseMm.most99, " mm") +
            figure("normals by noise", accuracy.normalNoiseDegrees.most99, " degrees") +
            figure("by arithmetic: depth", accuracy.depthMm.most99, " mm") +
            figure("normal", accuracy.normalDegrees.most99, " degrees") +
            figure("curvature", accuracy.curvature.most99, " 1/mm") +
            figure("light of " + base::shortText(100.0 * kLightLevel, 3) + " % of it",
                   100.0 * accuracy.relativeLightWithin, " % of its mean");
  return line + base::shortText(100.0 * accuracy.uncertainShare(), 2) + " % of pixels are not certain";
}

}  // namespace isolux::app
