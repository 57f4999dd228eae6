// Provides the qualities of stills: settings that trade time for fewer jagged edges and less noise.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace isolux::scene {

struct Quality {
  std::string_view name;                 // on the command line
  std::string_view title, meaning;       // in the window
  std::vector<std::string> assignments;  // PATH=VALUE
};

// From the fastest to the finest.
std::span<const Quality> qualities();
// Throws base::Error{usage} for an unknown name.
const Quality& quality(std::string_view name);
Scene withQuality(Scene scene, const Quality& quality);

}  // namespace isolux::scene
