// The knobs, and what each is judged by.
#include "app/study/study_knobs.h"
#include "render/graph/pass.h"

namespace isolux::app {

namespace pass = render::pass;

const std::array<Panel, 2>& panelsOf(const Knob& knob) {
  static const std::array<Panel, 2> hits{Panel{"depth_rms_voxels",
                                               "depth error, RMS, voxels",
                                               {pass::cast, pass::refine},
                                               [](const Errors& errors) { return errors.depthVoxels.rms; }},
                                         Panel{"missed_ppm",
                                               "missed pixels, ppm of the picture",
                                               {pass::cast, pass::refine},
                                               [](const Errors& errors) { return errors.missedPpm(); }}};
  static const std::array<Panel, 2> shape{
      Panel{"normal_rms_degrees",
            "normal error, RMS, degrees",
            {pass::gradient},
            [](const Errors& errors) { return errors.normalDegrees.rms; }},
      Panel{"curvature_median_relative",
            "relative curvature error, median",
            {pass::hessian},
            [](const Errors& errors) { return errors.curvature.median; }}};
  static const std::array<Panel, 2> scale{
      Panel{"noise_curvature_median_relative",
            "relative curvature error by noise and scale, median",
            {pass::hessian},
            [](const Errors& errors) { return errors.noise.curvature.median; }},
      Panel{"noise_normal_rms_degrees",
            "normal error by noise and scale, RMS, degrees",
            {pass::hessian},
            [](const Errors& errors) { return errors.noise.normalDegrees.rms; }}};
  static const std::array<Panel, 2> light{
      Panel{"irradiance_rmse_relative",
            "relative error of irradiance, RMSE",
            {pass::irradiance},
            [](const Errors& errors) { return errors.light.relative(errors.light.rmse); }},
      Panel{"irradiance_99_relative",
            "relative error of irradiance, 99 %",
            {pass::irradiance},
            [](const Errors& errors) { return errors.light.relative(errors.light.most99); }}};
  switch (knob.measure) {
    case Measure::hits:
      return hits;
    case Measure::shape:
      return shape;
    case Measure::scale:
      return scale;
    case Measure::light:
      break;
  }
  return light;
}

namespace {

const std::vector<const char*> kFields{"trilinear", "cubic", "cubic_interpolating"};

const std::vector<Knob>& surfaceKnobs() {
  static const std::vector<Knob> list{
      {"rate",
       "hit.rate",
       "rate, samples per voxel",
       Measure::hits,
       false,
       true,
       {"0.5", "1", "2", "4", "8", "16"}},
      {"near_factor",
       "hit.near_factor",
       "near factor r1/r0",
       Measure::hits,
       false,
       true,
       {"1", "2", "4", "8", "16"}},
      {"near_threshold",
       "hit.near_threshold",
       "near threshold, times automatic",
       Measure::hits,
       false,
       true,
       {"0", "0.25", "0.5", "1", "2", "4", "8"}},
      {"refinements",
       "hit.refinements",
       "refinement steps",
       Measure::hits,
       false,
       true,
       {"0", "1", "2", "3", "4", "5", "6", "7", "8"}},
      {"method", "hit.method", "hit method", Measure::hits, false, false, {"sampled", "exact"}},
      {"hit_field", "hit.field", "field that is hit", Measure::hits, true, false, kFields},
      {"derivatives_field", "derivatives.field", "field of the derivatives", Measure::shape, true, false,
       kFields},
      {"fetch",
       "derivatives.fetch",
       "fetches of the derivatives",
       Measure::shape,
       false,
       false,
       {"fast", "exact"}},
      {"derivatives_scale",
       "derivatives.scale",
       "scale, times the mean spacing",
       Measure::scale,
       false,
       false,
       {"0", "0.5", "0.7", "1", "1.4", "2", "2.8", "4", "auto"}},
  };
  return list;
}

// Knobs that share a bake follow one another, and what reads the most texels of it is the last of them.
const std::vector<Knob>& lightKnobs() {
  constexpr Measure light = Measure::light;
  static const std::vector<Knob> list{
      {"samples",
       "gi.samples",
       "paths per texel",
       light,
       false,
       false,
       {"4", "16", "64", "100", "256"},
       Cost::bakeSeconds,
       true},
      {"sequence",
       "gi.sequence",
       "directions",
       light,
       false,
       false,
       {"random", "r2", "sobol_owen"},
       Cost::bakeSeconds},
      {"environment_share",
       "gi.environment_share",
       "part of directions from the environment",
       light,
       false,
       false,
       {"0", "0.25", "0.5", "auto", "0.9"},
       Cost::bakeSeconds},
      {"bounces",
       "gi.bounces",
       "bounces",
       light,
       false,
       false,
       {"0", "1", "2", "4", "8"},
       Cost::bakeSeconds,
       true},
      {"lattice_scale",
       "gi.lattice_scale",
       "texels per voxel and axis",
       light,
       false,
       false,
       {"0.25", "0.5", "1", "2"},
       Cost::bakeSeconds,
       true},
      {"texels",
       "gi.texels",
       "where texels are lit",
       light,
       false,
       false,
       {"own", "auto"},
       Cost::bakeSeconds},
      {"precision",
       "gi.precision",
       "numbers on the graphics card",
       light,
       false,
       false,
       {"r11g11b10", "half"},
       Cost::gpuMegabytes},
      {"interpolation",
       "gi.interpolation",
       "interpolation between texels",
       light,
       false,
       false,
       {"nearest", "closest_isovalue", "trilinear", "weighted", "tricubic"},
       Cost::lookupMilliseconds},
      {"sh_order",
       "gi.sh_order",
       "bands of spherical harmonics",
       light,
       false,
       false,
       {"1", "2", "3", "4", "5", "6", "8"},
       Cost::bakeSeconds,
       true,
       true},
      {"sh_window",
       "gi.sh_window",
       "window of spherical harmonics",
       light,
       false,
       false,
       {"0", "0.25", "0.5", "0.75", "1"},
       Cost::lookupMilliseconds,
       false,
       true},
      {"components",
       "gi.components",
       "components of compressed transfer",
       light,
       false,
       false,
       {"4", "8", "12", "16", "24", "32", "48", "75"},
       Cost::gpuMegabytes,
       true,
       true},
      {"component_bits",
       "gi.component_bits",
       "bits per component, on average",
       light,
       false,
       false,
       {"2", "3", "4", "6", "8"},
       Cost::gpuMegabytes,
       false,
       true},
  };
  return list;
}

std::vector<Knob> allKnobs() {
  std::vector<Knob> list = surfaceKnobs();
  list.insert(list.end(), lightKnobs().begin(), lightKnobs().end());
  return list;
}

}  // namespace

const std::vector<Knob>& knobs() {
  static const std::vector<Knob> list = allKnobs();
  return list;
}

}  // namespace isolux::app
