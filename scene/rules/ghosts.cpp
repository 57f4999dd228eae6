#include "scene/rules/ghosts.h"

#include <algorithm>

#include "scene/shown_surfaces.h"

namespace isolux::scene {

void addGhosts(Scene& scene) {
  const double apart = scene.isosurface.ghost * scene.derivatives.noise.value_or(0.0);
  if (!(apart > 0.0) || !scene.isosurface.value) return;
  double offset = apart;
  int made = 0;
  for (ExtraIsosurface& extra : scene.extraIsosurfaces) {
    if (extra.shown || made == 2) continue;
    extra.shown = true;
    extra.value = *scene.isosurface.value + offset;
    extra.opacity = scene.isosurface.ghostOpacity;
    extra.facingOpacity = 1.0;
    extra.clipped = scene.isosurface.clipped;
    offset = -apart;
    ++made;
  }
}

int ghostsWithoutRoom(const Scene& scene) {
  if (!(scene.isosurface.ghost > 0.0)) return 0;
  const auto isFree = [](const ExtraIsosurface& extra) { return !extra.shown; };
  const auto free = std::ranges::count_if(scene.extraIsosurfaces, isFree);
  return std::max(0, 2 - static_cast<int>(free));
}

std::vector<double> seenIsovalues(Scene scene) {
  addGhosts(scene);
  std::vector<double> values;
  for (const ShownSurface& surface : visibleSurfaces(scene)) values.push_back(surface.value.value());
  return values;
}

}  // namespace isolux::scene
