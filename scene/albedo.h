// The diffuse reflectance of the surface of any isovalue: what global illumination reflects and looks show.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// Linear RGB in [0, 1]. A value; copies are cheap enough to keep one per thread.
class AlbedoOfIsovalue {
 public:
  // `scene` must be resolved. From the colour map over the isovalue; else an isovalue has the reflectance of
  // the nearest isosurface that is shown.
  explicit AlbedoOfIsovalue(const Scene& scene);

  glm::vec3 at(double isovalue) const;  // data units
  // The same reflectance whatever the isovalue.
  bool isConstant() const { return samples_.size() == 1; }

 private:
  std::vector<double> borders_;     // between isosurfaces, ascending; empty for a colour map
  std::vector<glm::vec3> samples_;  // of the map, or of the isosurfaces in the order of their isovalues
  double low_ = 0.0, high_ = 0.0;   // ends of the map
};

}  // namespace isolux::scene
