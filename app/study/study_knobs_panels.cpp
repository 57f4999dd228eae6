// What each kind of knob is judged by.
#include "app/study/study_knobs.h"
#include "render/graph/pass.h"

namespace isolux::app {

namespace pass = render::pass;

const std::array<Panel, 2>& panelsOf(const Knob& knob) {
  static const std::array<Panel, 2> hits{Panel{"depth_rms_voxels",
                                               "depth error, RMS, voxels",
                                               {pass::cast, pass::refine},
                                               [](const Errors& errors) { return errors.depthVoxels.rms; },
                                               "depth error",
                                               " voxels"},
                                         Panel{"missed_ppm",
                                               "missed pixels, ppm of the image",
                                               {pass::cast, pass::refine},
                                               [](const Errors& errors) { return errors.missedPpm(); },
                                               "share of missed pixels",
                                               " ppm"}};
  static const std::array<Panel, 2> shape{Panel{"normal_rms_degrees",
                                                "normal error, RMS, degrees",
                                                {pass::gradient},
                                                [](const Errors& errors) { return errors.normalDegrees.rms; },
                                                "normal error",
                                                "°"},
                                          Panel{"curvature_median_relative",
                                                "relative curvature error, median",
                                                {pass::hessian},
                                                [](const Errors& errors) { return errors.curvature.median; },
                                                "curvature error",
                                                " %",
                                                100.0}};
  static const std::array<Panel, 2> scale{
      Panel{"noise_curvature_median_relative",
            "relative curvature error by noise and scale, median",
            {pass::hessian},
            [](const Errors& errors) { return errors.noise.curvature.median; },
            "curvature error",
            " %",
            100.0},
      Panel{"noise_normal_rms_degrees",
            "normal error by noise and scale, RMS, degrees",
            {pass::hessian},
            [](const Errors& errors) { return errors.noise.normalDegrees.rms; },
            "normal error",
            "°"}};
  static const std::array<Panel, 2> light{
      Panel{"irradiance_rmse_relative",
            "relative error of irradiance, RMSE",
            {pass::irradiance},
            [](const Errors& errors) { return errors.light.relative(errors.light.rmse); },
            "error of the light",
            " %",
            100.0},
      Panel{"irradiance_99_relative",
            "relative error of irradiance, 99th percentile",
            {pass::irradiance},
            [](const Errors& errors) { return errors.light.relative(errors.light.most99); },
            "error of the light",
            " %",
            100.0}};
  static const std::array<Panel, 2> edges{Panel{"edge_rms",
                                                "colour error of edges, RMS, fraction of the range",
                                                {},
                                                [](const Errors& errors) { return errors.picture.edgeRms; },
                                                "error of edges",
                                                " % of the range",
                                                100.0},
                                          Panel{"flip",
                                                "mean FLIP of the image",
                                                {},
                                                [](const Errors& errors) { return errors.picture.flip; },
                                                "mean FLIP",
                                                ""}};
  static const std::array<Panel, 2> shadow{Panel{"flip",
                                                 "mean FLIP against the image with shadow",
                                                 {},
                                                 [](const Errors& errors) { return errors.picture.flip; },
                                                 "mean FLIP",
                                                 ""},
                                           Panel{"picture_rms",
                                                 "colour difference to it, RMS, fraction of the range",
                                                 {},
                                                 [](const Errors& errors) { return errors.picture.rms; },
                                                 "difference",
                                                 " % of the range",
                                                 100.0}};
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
