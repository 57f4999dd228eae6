// Determines why an image shows no surface, and which change would show one, for the window and for commands.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::render {

struct EmptyPicture {
  enum class Remedy { none, isovalue, view, opacity, pieces, cuts };  // the setting to change
  std::string reason;                                                 // a sentence without its full stop
  Remedy remedy = Remedy::none;
};

// Returns nullopt if some surface is visible. `crossed`: some cell contains a shown isovalue; `seen`: some
// ray hit a surface. Requires a resolved `scene`. `aspect`: width / height.
std::optional<EmptyPicture> whyEmpty(const scene::Scene& scene, const volume::PreparedVolume& volume,
                                     double aspect, bool crossed, bool seen);

}  // namespace isolux::render
