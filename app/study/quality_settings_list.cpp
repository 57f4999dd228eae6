// The quality settings.
#include <sstream>

#include "app/study/quality_settings.h"

namespace isolux::app {

namespace {

constexpr unsigned kSampled = 1, kField = 2, kOrdered = 4, kTransfer = 8;

struct QualityRow {
  const char *name, *setting, *label;
  Measure measure;
  const char *values, *reference;
  Cost cost = Cost::passes;
  unsigned traits = 0;
};

constexpr const char *kFields = "trilinear cubic cubic_interpolating", *kSpline = "cubic_interpolating";

// Quality settings of light that share a bake follow one another, and what reads the most texels of it is the
// last of them.
constexpr QualityRow kRows[] = {
    {"rate", "hit.rate", "sampling rate, samples per voxel", Measure::hits, "0.5 1 2 4 8 16", kExactHits,
     Cost::passes, kSampled},
    {"near_factor", "hit.near_factor", "near factor r1/r0", Measure::hits, "1 2 4 8 16", kExactHits,
     Cost::passes, kSampled},
    {"near_threshold", "hit.near_threshold", "near threshold, multiples of automatic", Measure::hits,
     "0 0.25 0.5 1 2 4 8", kExactHits, Cost::passes, kSampled},
    {"refinements", "hit.refinements", "refinement steps", Measure::hits, "0 1 2 3 4 5 6 7 8", kExactHits,
     Cost::passes, kSampled},
    {"method", "hit.method", "hit method", Measure::hits, "sampled exact", "exact"},
    {"hit_field", "hit.field", "interpolant of hits", Measure::hits, kFields, kSpline, Cost::passes, kField},
    {"derivatives_field", "derivatives.field", "interpolant of derivatives", Measure::shape, kFields, kSpline,
     Cost::passes, kField},
    {"fetch", "derivatives.fetch", "voxel access of derivatives", Measure::shape, "fast exact", "exact"},
    {"derivatives_scale", "derivatives.scale", "scale σ, multiples of the mean spacing", Measure::scale,
     "0 0.5 0.7 1 1.4 2 2.8 4 auto", "auto"},
    {"supersampling", "picture.supersampling", "rays per pixel and axis", Measure::edges, "1 2 3 4", "",
     Cost::frameMilliseconds, kOrdered},
    {"shadow", "look.shadow", "strength of the key light's shadow", Measure::shadow, "0 1", "1",
     Cost::frameMilliseconds},
    {"samples", "gi.samples", "paths per texel", Measure::light, "4 16 64 100 256", "256", Cost::bakeSeconds,
     kOrdered},
    {"sequence", "gi.sequence", "directions", Measure::light, "random r2 sobol_owen", "sobol_owen",
     Cost::bakeSeconds},
    {"environment_share", "gi.environment_share", "fraction of directions from the environment",
     Measure::light, "0 0.25 0.5 auto 0.9", "auto", Cost::bakeSeconds},
    {"bounces", "gi.bounces", "bounces", Measure::light, "0 1 2 4 8", "8", Cost::bakeSeconds, kOrdered},
    {"lattice_scale", "gi.lattice_scale", "texels per voxel and axis", Measure::light, "0.25 0.5 1 2", "2",
     Cost::bakeSeconds, kOrdered},
    {"texels", "gi.texels", "where texels are lit", Measure::light, "own auto", "auto", Cost::bakeSeconds},
    {"precision", "gi.precision", "number format on the graphics card", Measure::light, "r11g11b10 half",
     "half", Cost::gpuMegabytes},
    {"interpolation", "gi.interpolation", "interpolation between texels", Measure::light,
     "nearest closest_isovalue trilinear weighted tricubic", "weighted", Cost::lookupMilliseconds},
    {"sh_order", "gi.sh_order", "bands of spherical harmonics", Measure::light, "1 2 3 4 5 6 8", "8",
     Cost::bakeSeconds, kOrdered | kTransfer},
    {"sh_window", "gi.sh_window", "window of spherical harmonics", Measure::light, "0 0.25 0.5 0.75 1", "0",
     Cost::lookupMilliseconds, kTransfer},
    {"components", "gi.components", "components of compressed transfer", Measure::light,
     "4 8 12 16 24 32 48 75", "75", Cost::gpuMegabytes, kOrdered | kTransfer},
    {"component_bits", "gi.component_bits", "bits per component, on average", Measure::light, "2 3 4 6 8",
     "8", Cost::gpuMegabytes, kTransfer},
};

QualitySetting qualitySettingOf(const QualityRow& row) {
  QualitySetting quality{row.name, row.setting, row.label, row.measure, {}, row.reference, row.cost};
  quality.field = (row.traits & kField) != 0;
  quality.sampled = (row.traits & kSampled) != 0;
  quality.ordered = (row.traits & kOrdered) != 0;
  quality.transfer = (row.traits & kTransfer) != 0;
  std::istringstream words(row.values);
  for (std::string word; words >> word;) quality.values.push_back(word);
  return quality;
}

}  // namespace

const std::vector<QualitySetting>& qualitySettings() {
  static const std::vector<QualitySetting> list = [] {
    std::vector<QualitySetting> all;
    for (const QualityRow& row : kRows) all.push_back(qualitySettingOf(row));
    return all;
  }();
  return list;
}

}  // namespace isolux::app
