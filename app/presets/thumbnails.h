// What small pictures show: a scene under each preset and each look, as far as it changes a picture.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/presets/preset.h"

namespace isolux::app {

struct Thumbnail {
  enum class Kind { preset, look };
  Kind kind = Kind::preset;
  std::string name, title, meaning;  // a preset's title, a look's name
  std::string why;                   // it does not apply, a clause; empty: it does
  scene::Scene scene;                // what a click makes of it
};

// Presets in their order, then the looks. Those that do not apply have the scene as it is.
std::vector<Thumbnail> thumbnailsOf(const scene::Scene& scene, std::span<const Preset> presets,
                                    const volume::PreparedVolume& volume);

// The resolved scene that the small picture is drawn of: without what does not enter it, so that equal
// scenes mean equal pictures.
scene::Scene drawnThumbnail(const Thumbnail& thumbnail, const volume::PreparedVolume& volume);

}  // namespace isolux::app
