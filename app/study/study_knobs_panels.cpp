// What each kind of knob is judged by.
#include "app/study/study_knobs.h"
#include "render/graph/pass.h"

namespace isolux::app {

namespace pass = render::pass;

const std::array<Panel, 2>& panelsOf(const Knob& knob) {
  using Passes = std::vector<const char*>;
  using E = const Errors&;
  static const Passes ofHits{pass::cast, pass::refine}, ofGradient{pass::gradient}, ofHessian{pass::hessian},
      ofLight{pass::irradiance}, none;
  static const std::array<Panel, 2> hits{
      Panel{"depth_rms_voxels", "depth error, RMS, voxels", ofHits, "depth error", " voxels", 1.0,
            [](E e) { return e.depthVoxels.rms; }},
      Panel{"missed_ppm", "missed pixels, ppm of the image", ofHits, "share of missed pixels", " ppm", 1.0,
            [](E e) { return e.missedPpm(); }}};
  static const std::array<Panel, 2> shape{
      Panel{"normal_rms_degrees", "normal error, RMS, degrees", ofGradient, "normal error", "°", 1.0,
            [](E e) { return e.normalDegrees.rms; }},
      Panel{"curvature_median_relative", "relative curvature error, median", ofHessian, "curvature error",
            " %", 100.0, [](E e) { return e.curvature.median; }}};
  static const std::array<Panel, 2> scale{
      Panel{"noise_curvature_median_relative", "relative curvature error by noise and scale, median",
            ofHessian, "curvature error", " %", 100.0, [](E e) { return e.noise.curvature.median; }},
      Panel{"noise_normal_rms_degrees", "normal error by noise and scale, RMS, degrees", ofHessian,
            "normal error", "°", 1.0, [](E e) { return e.noise.normalDegrees.rms; }}};
  static const std::array<Panel, 2> light{
      Panel{"irradiance_rmse_relative", "relative error of irradiance, RMSE", ofLight, "error of the light",
            " %", 100.0, [](E e) { return e.light.relative(e.light.rmse); }},
      Panel{"irradiance_99_relative", "relative error of irradiance, 99th percentile", ofLight,
            "error of the light", " %", 100.0, [](E e) { return e.light.relative(e.light.most99); }}};
  static const std::array<Panel, 2> edges{
      Panel{"edge_rms", "colour error of edges, RMS, fraction of the range", none, "error of edges",
            " % of the range", 100.0, [](E e) { return e.picture.edgeRms; }},
      Panel{"flip", "mean FLIP of the image", none, "mean FLIP", "", 1.0,
            [](E e) { return e.picture.flip; }}};
  static const std::array<Panel, 2> shadow{
      Panel{"flip", "mean FLIP against the image with shadow", none, "mean FLIP", "", 1.0,
            [](E e) { return e.picture.flip; }},
      Panel{"picture_rms", "colour difference to it, RMS, fraction of the range", none, "difference",
            " % of the range", 100.0, [](E e) { return e.picture.rms; }}};
  switch (knob.measure) {
    case Measure::hits:
      return hits;
    case Measure::shape:
      return shape;
    case Measure::scale:
      return scale;
    case Measure::edges:
      return edges;
    case Measure::shadow:
      return shadow;
    case Measure::light:
      break;
  }
  return light;
}

}  // namespace isolux::app
