// Which texels a picture, a band of isovalues, or a whole volume needs.
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "gi/bake/light_bake.h"
#include "scene/scene.h"
#include "volume/grid.h"

namespace isolux::gi {

// Texels that a lookup at any of `hits` (voxel coordinates; NaN and infinities are passed over) reads: 2 per
// axis, or 4 for tri-cubic lookups (`reach` 1 or 2). Blocks in the order in which the hits first touch them.
std::vector<WantedBlock> texelsAround(const LatticeGeometry& lattice, std::span<const glm::vec3> hits,
                                      int reach);
// Those that are within `texels` steps along each axis of one of `inner`, and not in it.
std::vector<WantedBlock> texelsBeside(const LatticeGeometry& lattice, const std::vector<WantedBlock>& inner,
                                      int texels);
// Texels that lookups on the isosurfaces of isovalues [low, high] (data units) can read, by the least and
// greatest voxel around each: all of them, and few more. Of Field::cubic_interpolating, which overshoots its
// voxels, some may be missing. Multithreaded; throws Error{interrupted}.
std::vector<WantedBlock> texelsOfBand(const LatticeGeometry& lattice, const volume::Grid& grid, double low,
                                      double high, int reach, base::Progress& progress,
                                      scene::Field field = scene::Field::trilinear);
std::vector<WantedBlock> allTexels(const LatticeGeometry& lattice);

}  // namespace isolux::gi
