#include "scene/shown_surfaces.h"

namespace isolux::scene {

std::vector<ShownSurface> shownSurfaces(const Scene& scene) {
  std::vector<ShownSurface> list;
  const auto add = [&](const auto& s) {
    list.push_back({s.value, s.albedo, s.specular, s.roughness, s.opacity, s.facingOpacity, s.clipped});
  };
  add(scene.isosurface);
  for (const ExtraIsosurface& extra : scene.extraIsosurfaces)
    if (extra.shown) add(extra);
  return list;
}

std::vector<ShownSurface> visibleSurfaces(const Scene& scene) {
  std::vector<ShownSurface> list = shownSurfaces(scene);
  std::erase_if(list, [](const ShownSurface& surface) { return !(surface.opacity > 0.0); });
  return list;
}

}  // namespace isolux::scene
