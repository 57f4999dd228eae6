#include "scene/rules/ghosts.h"

#include <algorithm>

#include "scene/settings/scene_list.h"
#include "scene/shown_surfaces.h"

namespace isolux::scene {

void addGhosts(Scene& scene) {
  const double noise = scene.derivatives.noise.value_or(0.0);
  const std::vector<Surface> surfaces = scene.surfaces;
  for (const Surface& of : surfaces) {
    if (!of.shown || !(of.ghost > 0.0) || !of.value || !(noise > 0.0)) continue;
    for (const double side : {1.0, -1.0}) {
      Surface& ghost = scene.surfaces.emplace_back(newSurface(scene.surfaces.size()));
      ghost.value = *of.value + side * of.ghost * noise;
      ghost.opacity = scene.isosurface.ghostOpacity;
      ghost.clipped = of.clipped;
    }
  }
}

std::vector<double> seenIsovalues(Scene scene) {
  addGhosts(scene);
  std::vector<double> values;
  for (const Surface& surface : visibleSurfaces(scene)) values.push_back(surface.value.value());
  return values;
}

}  // namespace isolux::scene
