// Gives tests an isosurface of a scene by its position.
#pragma once

#include <cstddef>

#include "scene/settings/scene_list.h"

namespace isolux::test {

// Returns the surface at a position, from 0. Those that are not there are made as isosurface2 was before
// there were lists: half transparent, switched off.
inline scene::Surface& surfaceAt(scene::Scene& scene, std::size_t position) {
  const scene::SceneList& list = *scene::listOfPath("surfaces.order");
  while (scene.surfaces.size() <= position) list.addFormer(scene, scene::newId(list, scene));
  return scene.surfaces[position];
}

}  // namespace isolux::test
