#include "app/presets/applied_preset.h"

#include <algorithm>
#include <cmath>

namespace isolux::app {

namespace {

// Sums of doubles come back with their last digits changed.
bool sameValue(const std::optional<double>& a, const std::optional<double>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return std::abs(*a - *b) <= 1e-9 * std::max({std::abs(*a), std::abs(*b), 1e-300});
}

bool shows(const scene::Scene& scene, scene::Scene preset) {
  if (scene.surfaces.size() != preset.surfaces.size()) return false;
  for (std::size_t i = 0; i < preset.surfaces.size(); ++i) {
    std::optional<double>& value = preset.surfaces[i].value;
    if (!sameValue(scene.surfaces[i].value, value)) return false;
    value = scene.surfaces[i].value;
  }
  return scene == preset;
}

}  // namespace

std::optional<AppliedPreset> appliedPreset(const scene::Scene& scene, std::span<const Preset> presets,
                                           const volume::PreparedVolume& volume,
                                           std::optional<std::size_t> last) {
  const double suggested = volume.facts.suggestedIsovalue;
  const double value = scene.surfaces.front().value.value_or(suggested);
  std::optional<AppliedPreset> shifted;
  for (std::size_t i = 0; i < presets.size(); ++i) {
    if (!whyNot(presets[i], volume).empty()) continue;
    const scene::Scene plain = withPreset(scene, presets[i], volume);
    if (shows(scene, plain)) return AppliedPreset{i, 0.0};
    const double shift = value - plain.surfaces.front().value.value_or(suggested);
    if (shift == 0.0 || (shifted && shifted->index == last)) continue;
    const bool nearer = !shifted || i == last || std::abs(shift) < std::abs(shifted->shift);
    if (nearer && shows(scene, withPreset(scene, presets[i], volume, shift)))
      shifted = AppliedPreset{i, shift};
  }
  return shifted;
}

double shiftReach(const volume::PreparedVolume& volume) {
  constexpr double ofHounsfield = 500.0, ofRange = 0.25;
  if (volume.kind.kind == scene::DataKind::ct_hu) return ofHounsfield;
  return ofRange * std::max(volume.facts.maximum - volume.facts.minimum, 0.0);
}

}  // namespace isolux::app
