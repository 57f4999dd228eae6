// Why there is nothing to be seen in a picture, and what would show something: for the window and for
// commands.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::render {

struct EmptyPicture {
  enum class Remedy { none, isovalue, view, opacity, pieces, cuts };  // what to change
  std::string reason;                                                 // a sentence without its full stop
  Remedy remedy = Remedy::none;
};

// Nothing where some surface is seen. `crossed`: some cell holds a value of a surface that is shown; `seen`:
// some ray hit one. `scene` must be resolved; `aspect`: width by height.
std::optional<EmptyPicture> whyEmpty(const scene::Scene& scene, const volume::PreparedVolume& volume,
                                     double aspect, bool crossed, bool seen);

}  // namespace isolux::render
