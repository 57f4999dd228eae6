// The quality settings.
#include <iterator>
#include <sstream>

#include "app/study/quality_settings.h"

namespace isolux::app {

namespace {

std::vector<std::string> words(const char* text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

constexpr const char *kFields = "trilinear cubic cubic_interpolating", *kSpline = "cubic_interpolating";

}  // namespace

// Those of light that share a bake follow one another, and what reads the most texels of it is the last of
// them.
const std::vector<QualitySetting>& qualitySettings() {
  static const std::vector<QualitySetting> list{
      {"rate", "hit.rate", "sampling rate, samples per voxel", Measure::hits, words("0.5 1 2 4 8 16"),
       kExactHits, Cost::passes, kSampled},
      {"near_factor", "hit.near_factor", "near factor r1/r0", Measure::hits, words("1 2 4 8 16"), kExactHits,
       Cost::passes, kSampled},
      {"near_threshold", "hit.near_threshold", "near threshold, multiples of automatic", Measure::hits,
       words("0 0.25 0.5 1 2 4 8"), kExactHits, Cost::passes, kSampled},
      {"refinements", "hit.refinements", "refinement steps", Measure::hits, words("0 1 2 3 4 5 6 7 8"),
       kExactHits, Cost::passes, kSampled},
      {"method", "hit.method", "hit method", Measure::hits, words("sampled exact"), "exact"},
      {"hit_field", "hit.field", "interpolant of hits", Measure::hits, words(kFields), kSpline, Cost::passes,
       kField},
      {"derivatives_field", "derivatives.field", "interpolant of derivatives", Measure::shape, words(kFields),
       kSpline, Cost::passes, kField},
      {"fetch", "derivatives.fetch", "voxel access of derivatives", Measure::shape, words("fast exact"),
       "exact"},
      {"derivatives_scale", "derivatives.scale", "scale σ, multiples of the mean spacing", Measure::scale,
       words("0 0.5 0.7 1 1.4 2 2.8 4 auto"), "auto"},
      {"supersampling", "picture.supersampling", "rays per pixel and axis", Measure::edges, words("1 2 3 4"),
       "", Cost::frameMilliseconds, kOrdered},
      {"shadow", "look.shadow", "strength of the key light's shadow", Measure::shadow, words("0 1"), "1",
       Cost::frameMilliseconds},
      {"samples", "gi.samples", "paths per texel", Measure::light, words("4 16 64 100 256"), "256",
       Cost::bakeSeconds, kOrdered},
      {"sequence", "gi.sequence", "directions", Measure::light, words("random r2 sobol_owen"), "sobol_owen",
       Cost::bakeSeconds},
      {"environment_share", "gi.environment_share", "fraction of directions from the environment",
       Measure::light, words("0 0.25 0.5 auto 0.9"), "auto", Cost::bakeSeconds},
      {"bounces", "gi.bounces", "bounces", Measure::light, words("0 1 2 4 8"), "8", Cost::bakeSeconds,
       kOrdered},
      {"lattice_scale", "gi.lattice_scale", "texels per voxel and axis", Measure::light,
       words("0.25 0.5 1 2"), "2", Cost::bakeSeconds, kOrdered},
      {"texels", "gi.texels", "where texels are lit", Measure::light, words("own auto"), "auto",
       Cost::bakeSeconds},
      {"precision", "gi.precision", "number format on the graphics card", Measure::light,
       words("r11g11b10 half"), "half", Cost::gpuMegabytes},
      {"interpolation", "gi.interpolation", "interpolation between texels", Measure::light,
       words("nearest closest_isovalue trilinear weighted tricubic"), "weighted", Cost::lookupMilliseconds},
      {"sh_order", "gi.sh_order", "bands of spherical harmonics", Measure::light, words("1 2 3 4 5 6 8"), "8",
       Cost::bakeSeconds, kOrdered | kTransfer},
      {"sh_window", "gi.sh_window", "window of spherical harmonics", Measure::light,
       words("0 0.25 0.5 0.75 1"), "0", Cost::lookupMilliseconds, kTransfer},
      {"components", "gi.components", "components of compressed transfer", Measure::light,
       words("4 8 12 16 24 32 48 75"), "75", Cost::gpuMegabytes, kOrdered | kTransfer},
      {"component_bits", "gi.component_bits", "bits per component, on average", Measure::light,
       words("2 3 4 6 8"), "8", Cost::gpuMegabytes, kTransfer}};
  return list;
}

}  // namespace isolux::app
