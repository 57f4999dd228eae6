#include "app/documents/picture_scene.h"

namespace isolux::app {

scene::Scene carriedScene(scene::Scene given, const scene::Scene& resolved, std::optional<double> exposure) {
  given.camera = resolved.camera;
  given.isosurface.value = resolved.isosurface.value;
  for (std::size_t i = 0; i < given.extraIsosurfaces.size(); ++i)
    if (given.extraIsosurfaces[i].shown) given.extraIsosurfaces[i].value = resolved.extraIsosurfaces[i].value;
  if (exposure) given.picture.exposure = exposure;
  return given;
}

}  // namespace isolux::app
