// The body in a scan: what is above an isovalue, without the thin things beside it, a headrest or a table.
//
// On nodes, about 128 along the longest axis. Above, or with something above in five of the six directions
// along the axes (air in a nose or lung, the dark bone of an MR scan): solid. Its depth at a node is the
// distance to the nearest node that is not solid; the border of the volume is no surface. Where a ball of 5
// mm, or of a tenth of the greatest depth if that is less, fits into the solid, it is thick; a connected part
// of what such balls reach counts where it is a quarter as deep as the deepest: both legs do, the shell of a
// headrest does not, whether it touches the head or not.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/voxels/extent.h"

namespace isolux::volume {

class Grid;
class Pieces;

class Body {
 public:
  // isovalue: data units; the body is above it, whatever is inside of the isosurfaces. The grid is whole.
  // Multithreaded. Throws Error{interrupted}.
  Body(const Grid& grid, double isovalue, base::Progress& progress);

  double isovalue() const { return isovalue_; }
  // How deep the voxel lies, as a fraction of the greatest depth; 0: outside. 1 where nothing is outside.
  float depth(glm::ivec3 voxel) const { return depth_[Extent3{dims_}.index(voxel / step_)]; }

 private:
  double isovalue_;
  glm::ivec3 step_, dims_;  // voxels from node to node; nodes
  std::vector<float> depth_;
};

// Counts the voxels of each piece that lie in the body, at least so deep. Multithreaded.
std::vector<std::uint64_t> voxelsInBody(const Pieces& pieces, const Body& body, double depth);

}  // namespace isolux::volume
