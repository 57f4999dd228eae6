// Gives tests a light source of a scene by its position.
#pragma once

#include <cstddef>

#include "scene/settings/scene_list.h"

namespace isolux::test {

// Returns the light source at a position, from 0. Those that are not there are made, switched off.
inline scene::Lamp& lampAt(scene::Scene& scene, std::size_t position) {
  while (scene.lamps.size() <= position) {
    const std::string id = scene::newId(*scene::listOfPath("lamps.order"), scene);
    scene::Lamp& lamp = scene.lamps.emplace_back();
    lamp.id = id;
    lamp.shown = false;
  }
  return scene.lamps[position];
}

inline const scene::Lamp& lampAt(const scene::Scene& scene, std::size_t position) {
  return scene.lamps.at(position);
}

}  // namespace isolux::test
