#include "scene/opacity.h"

#include <algorithm>

namespace isolux::scene {

bool variesByAngle(const Scene& scene) {
  return variesByAngle(scene.isosurface) ||
         std::any_of(scene.extraIsosurfaces.begin(), scene.extraIsosurfaces.end(),
                     [](const ExtraIsosurface& extra) { return extra.shown && variesByAngle(extra); });
}

}  // namespace isolux::scene
