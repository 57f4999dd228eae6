// Finds the texels that an image or a whole volume needs (for a band of isovalues: gi/texels/texel_band.h).
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// Returns the texels that a lookup at any of `hits` reads: 2 per axis, or 4 for tri-cubic lookups (`reach` 1
// or 2). `hits` are voxel coordinates; NaN and infinities are ignored. Blocks are in the order in which the
// hits first touch them.
std::vector<BlockRequest> texelsAround(const LatticeGeometry& lattice, std::span<const glm::vec3> hits,
                                       int reach);
// Returns the texels within `texels` steps along each axis of a texel of `inner`, but not in it.
std::vector<BlockRequest> texelsBeside(const LatticeGeometry& lattice, const std::vector<BlockRequest>& inner,
                                       int texels);
std::vector<BlockRequest> allTexels(const LatticeGeometry& lattice);

}  // namespace isolux::gi
