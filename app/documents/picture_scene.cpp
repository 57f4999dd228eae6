#include "app/documents/picture_scene.h"

namespace isolux::app {

scene::Scene carriedScene(scene::Scene given, const scene::Scene& resolved, std::optional<double> exposure) {
  given.camera = resolved.camera;
  for (std::size_t i = 0; i < given.surfaces.size(); ++i)
    if (i == 0 || given.surfaces[i].shown) given.surfaces[i].value = resolved.surfaces[i].value;
  if (exposure) given.picture.exposure = exposure;
  return given;
}

}  // namespace isolux::app
