// Which texels a picture or a whole volume needs (a band of isovalues: gi/texels/texel_band.h).
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "gi/bake/wish.h"
#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// Texels that a lookup at any of `hits` (voxel coordinates; NaN and infinities are passed over) reads: 2 per
// axis, or 4 for tri-cubic lookups (`reach` 1 or 2). Blocks in the order in which the hits first touch them.
std::vector<WantedBlock> texelsAround(const LatticeGeometry& lattice, std::span<const glm::vec3> hits,
                                      int reach);
// Those that are within `texels` steps along each axis of one of `inner`, and not in it.
std::vector<WantedBlock> texelsBeside(const LatticeGeometry& lattice, const std::vector<WantedBlock>& inner,
                                      int texels);
std::vector<WantedBlock> allTexels(const LatticeGeometry& lattice);

}  // namespace isolux::gi
