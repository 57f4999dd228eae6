#include "scene/rules/ghosts.h"

#include <algorithm>

#include "scene/settings/scene_list.h"
#include "scene/shown_surfaces.h"

namespace isolux::scene {

namespace {

std::size_t freePlaces(const Scene& scene) {
  const auto isFree = [](const Surface& surface) { return !surface.shown; };
  return kSurfaces - scene.surfaces.size() +
         static_cast<std::size_t>(
             std::ranges::count_if(scene.surfaces.begin() + 1, scene.surfaces.end(), isFree));
}

bool hasGhosts(const Surface& surface) {
  return surface.shown && surface.ghost > 0.0;
}

// The first place whose surface is not shown, at the end if there is none.
Surface& freePlace(Scene& scene) {
  for (std::size_t i = 1; i < scene.surfaces.size(); ++i)
    if (!scene.surfaces[i].shown) return scene.surfaces[i] = newSurface(i);
  return scene.surfaces.emplace_back(newSurface(scene.surfaces.size()));
}

}  // namespace

void addGhosts(Scene& scene) {
  const double noise = scene.derivatives.noise.value_or(0.0);
  const std::vector<Surface> shown = scene.surfaces;
  for (const Surface& of : shown) {
    if (!hasGhosts(of) || !of.value || !(noise > 0.0)) continue;
    for (const double side : {1.0, -1.0}) {
      if (freePlaces(scene) == 0) return;
      Surface& ghost = freePlace(scene);
      ghost.value = *of.value + side * of.ghost * noise;
      ghost.opacity = scene.isosurface.ghostOpacity;
      ghost.clipped = of.clipped;
    }
  }
}

int ghostsWithoutRoom(const Scene& scene) {
  const auto wanted = 2 * std::ranges::count_if(scene.surfaces, hasGhosts);
  return std::max(0, static_cast<int>(wanted) - static_cast<int>(freePlaces(scene)));
}

std::vector<double> seenIsovalues(Scene scene) {
  addGhosts(scene);
  std::vector<double> values;
  for (const Surface& surface : visibleSurfaces(scene)) values.push_back(surface.value.value());
  return values;
}

}  // namespace isolux::scene
