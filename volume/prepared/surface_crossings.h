// Finds where the isosurfaces that a scene shows cross the edges of the grid: points of the trilinear surface
// that cost a comparison each.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "scene/shown_surfaces.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

struct Surface {
  double isovalue;
  std::shared_ptr<const VoxelMask> hidden;  // null: nothing
};
// Those of opacity above 0. `resolved`: scene::resolve of this volume. Throws Error: interrupted; memory, of
// pieces.
inline std::vector<Surface> shownSurfaces(const PreparedVolume& volume, const scene::Scene& resolved,
                                          base::Progress& progress) {
  std::vector<Surface> surfaces;
  for (const scene::Surface& surface : scene::visibleSurfaces(resolved))
    surfaces.push_back({*surface.value, volume.pieces->hidden(resolved.pieces, *surface.value,
                                                              resolved.isosurface.inside, progress)});
  return surfaces;
}

// Calls each(first voxel of the edge, crossing in voxel coordinates) for the crossings on the edges of the
// voxels of a block. A whole grid.
template <class Each>
void eachCrossing(const PreparedVolume& volume, const Surface& surface, scene::Inside inside,
                  std::size_t block, const Each& each) {
  const Grid& grid = volume.grid();
  const glm::ivec3 low = Extent3{volume.blocks->dims()}.at(block) * volume.blocks->blockCells();
  const glm::ivec3 high = glm::min(low + volume.blocks->blockCells(), grid.dims() - 1);
  const double isovalue = grid.storedOfValue(surface.isovalue);
  const bool insideIsPositive = (inside == scene::Inside::above) == (grid.slope() > 0.0);
  const auto look = [&](const auto& stored) {
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
  };
  grid.visit(look);
}

}  // namespace isolux::volume
