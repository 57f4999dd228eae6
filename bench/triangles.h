// The triangle mesh of an isosurface by VTK's flying edges: what a ray tracer for meshes is given.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/grid.h"

namespace isolux::bench {

struct Triangles {
  std::vector<glm::vec3> points;       // voxel coordinates
  std::vector<std::uint32_t> corners;  // three per triangle
};

struct MeshSize {
  double areaMm2 = 0.0, volumeMm3 = 0.0;
};
// Of that mesh, by VTK's mass properties; the volume is right for closed surfaces.
MeshSize massOf(const volume::Grid& grid, double isovalue);

Triangles trianglesOf(const volume::Grid& grid, double isovalue);

}  // namespace isolux::bench
