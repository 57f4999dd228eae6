// What each kind of quality setting is judged by.
#include "app/study/quality_settings.h"
#include "render/graph/pass.h"

namespace isolux::app {

namespace pass = render::pass;

const std::array<Panel, 2>& panelsOf(const QualitySetting& quality) {
  using Passes = std::vector<const char*>;
  using E = const Errors&;
  static const Passes ofHits{pass::cast, pass::refine}, ofGradient{pass::gradient}, ofHessian{pass::hessian},
      ofLight{pass::irradiance}, none;
  // In the order of Measure.
  static const std::array<std::array<Panel, 2>, 6> panels{
      std::array{Panel{"depth_rms_voxels", "depth error, RMS, voxels", ofHits, "depth error", " voxels", 1.0,
                       [](E e) { return e.depthVoxels.rms; }},
                 Panel{"missed_ppm", "missed pixels, ppm of the image", ofHits, "share of missed pixels",
                       " ppm", 1.0, [](E e) { return e.missedPpm(); }}},
      std::array{Panel{"normal_rms_degrees", "normal error, RMS, degrees", ofGradient, "normal error", "°",
                       1.0, [](E e) { return e.normalDegrees.rms; }},
                 Panel{"curvature_median_relative", "relative curvature error, median", ofHessian,
                       "curvature error", " %", 100.0, [](E e) { return e.curvature.median; }}},
      std::array{
          Panel{"noise_curvature_median_relative", "relative curvature error by noise and scale, median",
                ofHessian, "curvature error", " %", 100.0, [](E e) { return e.noise.curvature.median; }},
          Panel{"noise_normal_rms_degrees", "normal error by noise and scale, RMS, degrees", ofHessian,
                "normal error", "°", 1.0, [](E e) { return e.noise.normalDegrees.rms; }}},
      std::array{
          Panel{"irradiance_rmse_relative", "relative error of irradiance, RMSE", ofLight,
                "error of the light", " %", 100.0, [](E e) { return e.light.relative(e.light.rmse); }},
          Panel{"irradiance_99_relative", "relative error of irradiance, 99th percentile", ofLight,
                "error of the light", " %", 100.0, [](E e) { return e.light.relative(e.light.most99); }}},
      std::array{Panel{"edge_rms", "colour error of edges, RMS, fraction of the range", none,
                       "error of edges", " % of the range", 100.0, [](E e) { return e.picture.edgeRms; }},
                 Panel{"flip", "mean FLIP of the image", none, "mean FLIP", "", 1.0,
                       [](E e) { return e.picture.flip; }}},
      std::array{Panel{"flip", "mean FLIP against the image with shadow", none, "mean FLIP", "", 1.0,
                       [](E e) { return e.picture.flip; }},
                 Panel{"picture_rms", "colour difference to it, RMS, fraction of the range", none,
                       "difference", " % of the range", 100.0, [](E e) { return e.picture.rms; }}}};
  return panels[static_cast<std::size_t>(quality.measure)];
}

}  // namespace isolux::app
