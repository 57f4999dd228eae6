// A net of polygons whose corners lie on the trilinear isosurface: where it crosses the edges between voxels,
// joined within each face of a cell as the trilinear field joins them (asymptotic decider). For finding ways
// along the surface.
//
// World mm. Polygons of a cell are the loops of its faces' arcs, cut into triangles from their first corner.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/grid.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct SurfaceGraph {
  std::vector<glm::dvec3> points;           // world mm
  std::vector<glm::ivec3> triangles;        // of points
  std::vector<std::uint32_t> firstOfPoint;  // triangles about point i: trianglesOfPoint[firstOfPoint[i] ...
  std::vector<std::uint32_t> trianglesOfPoint;  // ... firstOfPoint[i + 1]]
};

// Throws Error{interrupted}; Error{memory} above 2^31 points.
SurfaceGraph surfaceGraph(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                          base::Progress& progress);

}  // namespace isolux::volume
