// Finds where the isosurfaces that a scene shows cross the edges of the grid: points of the trilinear surface
// that cost a comparison each.
#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

struct ShownSurface {
  double isovalue;
  std::shared_ptr<const VoxelMask> hidden;  // null: nothing
};
// Those of opacity above 0. `resolved`: scene::resolve of this volume. Throws Error: interrupted; memory, of
// pieces.
std::vector<ShownSurface> shownSurfaces(const PreparedVolume& volume, const scene::Scene& resolved,
                                        base::Progress& progress);

// Calls each(first voxel of the edge, crossing in voxel coordinates) for the crossings on the edges of the
// voxels from `low` to `high`. A whole grid.
template <class T, class Each>
void eachCrossing(const std::vector<T>& stored, const Grid& grid, const ShownSurface& surface,
                  scene::Inside inside, glm::ivec3 low, glm::ivec3 high, const Each& each) {
  const double isovalue = grid.storedOfValue(surface.isovalue);
  const bool insideIsPositive = (inside == scene::Inside::above) == (grid.slope() > 0.0);
  const auto at = [&](glm::ivec3 v) { return static_cast<double>(stored[grid.index(v)]) - isovalue; };
  forEachIn(low, high + 1, [&](glm::ivec3 begin) {
    const double f = at(begin);
    for (int axis = 0; axis < 3; ++axis) {
      glm::ivec3 end = begin;
      if (++end[axis] > high[axis]) continue;
      const double g = at(end);
      if ((f >= 0.0) == (g >= 0.0) || std::isnan(f) || std::isnan(g)) continue;
      const glm::ivec3 within = (f >= 0.0) == insideIsPositive ? begin : end;
      if (surface.hidden && surface.hidden->at(within)) continue;
      glm::dvec3 point(begin);
      point[axis] += f / (f - g);
      each(begin, point);
    }
  });
}

}  // namespace isolux::volume
