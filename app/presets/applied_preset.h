// Which preset a scene shows, and by how much its isovalues are shifted: told from the scene alone, so that
// undo, sessions and settings changed by hand need no memory of what was applied.
#pragma once

#include <optional>
#include <span>

#include "app/presets/preset.h"

namespace isolux::app {

struct AppliedPreset {
  std::size_t index = 0;  // of the presets given
  double shift = 0.0;     // data units: withPreset()
};
// Only presets that apply to the volume count. They may differ in nothing but their isovalues: one that is
// not shifted goes first, then `last`, the one that was told before, then that of the smallest shift.
// None: settings that presets are made of have been changed since, or no preset was applied.
std::optional<AppliedPreset> appliedPreset(const scene::Scene& scene, std::span<const Preset> presets,
                                           const volume::PreparedVolume& volume,
                                           std::optional<std::size_t> last = {});

// How far isovalues of presets can be shifted each way in the window, data units: 500 HU, or a quarter of
// the range of values.
double shiftReach(const volume::PreparedVolume& volume);

}  // namespace isolux::app
