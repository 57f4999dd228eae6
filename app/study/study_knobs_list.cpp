// The knobs.
#include <map>

#include "app/study/study_knobs.h"

namespace isolux::app {

namespace {

const std::vector<const char*> kFields{"trilinear", "cubic", "cubic_interpolating"};

const std::vector<Knob>& surfaceKnobs() {
  static const std::vector<Knob> list{
      {"rate",
       "hit.rate",
       "sampling rate, samples per voxel",
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
       "near threshold, multiples of automatic",
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
      {"hit_field", "hit.field", "interpolant of hits", Measure::hits, true, false, kFields},
      {"derivatives_field", "derivatives.field", "interpolant of derivatives", Measure::shape, true, false,
       kFields},
      {"fetch",
       "derivatives.fetch",
       "voxel access of derivatives",
       Measure::shape,
       false,
       false,
       {"fast", "exact"}},
      {"derivatives_scale",
       "derivatives.scale",
       "scale σ, multiples of the mean spacing",
       Measure::scale,
       false,
       false,
       {"0", "0.5", "0.7", "1", "1.4", "2", "2.8", "4", "auto"}},
      {"supersampling",
       "picture.supersampling",
       "rays per pixel and axis",
       Measure::edges,
       false,
       false,
       {"1", "2", "3", "4"},
       Cost::frameMilliseconds,
       true},
      {"shadow",
       "look.shadow",
       "strength of the key light's shadow",
       Measure::shadow,
       false,
       false,
       {"0", "1"},
       Cost::frameMilliseconds},
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
       "fraction of directions from the environment",
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
       "number format on the graphics card",
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

std::string pictureReference(const Knob& knob) {
  if (knob.sampled) return kExactHits;
  if (knob.field) return "cubic_interpolating";
  static const std::map<std::string, std::string> references{{"method", "exact"},
                                                             {"fetch", "exact"},
                                                             {"derivatives_scale", "auto"},
                                                             {"shadow", "1"},
                                                             {"samples", "256"},
                                                             {"sequence", "sobol_owen"},
                                                             {"environment_share", "auto"},
                                                             {"bounces", "8"},
                                                             {"lattice_scale", "2"},
                                                             {"texels", "auto"},
                                                             {"precision", "half"},
                                                             {"interpolation", "weighted"},
                                                             {"sh_order", "8"},
                                                             {"sh_window", "0"},
                                                             {"components", "75"},
                                                             {"component_bits", "8"}};
  const auto found = references.find(knob.name);
  return found == references.end() ? std::string() : found->second;
}

const std::vector<Knob>& knobs() {
  static const std::vector<Knob> list = allKnobs();
  return list;
}

}  // namespace isolux::app
