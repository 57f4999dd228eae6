#include "scene/shown_surfaces.h"

namespace isolux::scene {

std::vector<Surface> shownSurfaces(const Scene& scene) {
  std::vector<Surface> list = scene.surfaces;
  Surface& first = list.front();
  if (!first.shown) first.opacity = 0.0;
  first.shown = true;
  std::erase_if(list, [](const Surface& surface) { return !surface.shown; });
  return list;
}

std::vector<Surface> visibleSurfaces(const Scene& scene) {
  std::vector<Surface> list = shownSurfaces(scene);
  std::erase_if(list, [](const Surface& surface) { return !(surface.opacity > 0.0); });
  return list;
}

}  // namespace isolux::scene
