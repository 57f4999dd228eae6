// Provides the diffuse reflectance (albedo) of the surface of any isovalue, for global illumination and
// looks.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// Linear RGB in [0, 1]. A value type; copies are cheap enough to keep one per thread.
class AlbedoOfIsovalue {
 public:
  // Requires a resolved `scene`. Uses the colour map over the isovalue; without one, an isovalue has the
  // reflectance of the nearest shown isosurface.
  explicit AlbedoOfIsovalue(const Scene& scene);

  glm::vec3 at(double isovalue) const;  // data units
  // Returns whether the reflectance is the same for all isovalues.
  bool isConstant() const { return samples_.size() == 1; }

 private:
  std::vector<double> borders_;     // between isosurfaces, ascending; empty for a colour map
  std::vector<glm::vec3> samples_;  // of the map, or of the isosurfaces in the order of their isovalues
  double low_ = 0.0, high_ = 0.0;   // ends of the map
};

}  // namespace isolux::scene
