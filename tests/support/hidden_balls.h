// Volumes with pieces of which some are hidden, by hand: what is seen of them is known without any labelling.
#pragma once

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

#include "tests/support/volumes.h"
#include "volume/grid.h"
#include "volume/visible/voxel_mask.h"

namespace isolux::test {

struct PieceBall {
  glm::dvec3 middle;  // voxels
  double radius;
  bool shown = true;
};

// Five balls, more than six voxels apart: two are hidden, one of them before a shown one in many views, one
// large around no other.
inline std::vector<PieceBall> pieceBalls() {
  return {{{12.3, 13.1, 14.2}, 6.2},
          {{34.7, 12.4, 15.8}, 7.1, false},
          {{15.2, 35.3, 33.9}, 7.7},
          {{36.1, 35.5, 36.3}, 6.9, false},
          {{36.4, 34.2, 12.7}, 4.6}};
}

// Distance to the nearest ball's surface, inside positive, cut at 2 voxels, so that balls do not change one
// another's cells; negated where `sign` is -1. `all`: the hidden ones, too.
inline volume::Grid gridOfBalls(const std::vector<PieceBall>& balls, bool all, double sign = 1.0,
                                glm::ivec3 dims = glm::ivec3(48)) {
  return gridOfVoxels(unitGeometry(dims), [&](glm::dvec3 p) {
    double depth = -2.0;
    for (const PieceBall& ball : balls)
      if (all || ball.shown) depth = std::max(depth, ball.radius - glm::length(p - ball.middle));
    return sign * std::min(depth, 2.0);
  });
}

// Of isovalue 0.
inline volume::VoxelMask hiddenOfBalls(const std::vector<PieceBall>& balls,
                                       glm::ivec3 dims = glm::ivec3(48)) {
  volume::VoxelMask hidden(dims);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        for (const PieceBall& ball : balls)
          if (!ball.shown && glm::length(glm::dvec3(x, y, z) - ball.middle) <= ball.radius)
            hidden.hide(x, x + 1, y, z);
  return hidden;
}

// Two half-spaces, x + y < k and x + y > k, apart by a gap that runs through the corners of cells: each cell
// in it has a corner of both, which do not hang together (a d < b c of its faces). In cells the sign of x + y
// - k tells whose a point is.
struct SplitCells {
  static constexpr int k = 31;
  static volume::Grid grid(double sign = 1.0) {
    return gridOfVoxels(unitGeometry({32, 32, 24}), [&](glm::dvec3 p) {
      return sign * (std::abs(p.x + p.y - k) - 0.6) * (1.0 + 0.1 * p.z);
    });
  }
  static volume::VoxelMask hidden() {  // the first
    volume::VoxelMask voxels({32, 32, 24});
    for (int z = 0; z < 24; ++z)
      for (int y = 0; y < 32; ++y) voxels.hide(0, std::clamp(k - y, 0, 32), y, z);
    return voxels;
  }
  static bool shows(const glm::dvec3& voxel) { return voxel.x + voxel.y > k; }
};

}  // namespace isolux::test
