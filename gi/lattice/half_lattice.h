// Interpolates baked lighting from half of its texels, to estimate the sampling error.
//
// The difference between the two halves shows the noise of paths and the effect of the texels' positions
// (docs/explanation/accuracy.md).
#pragma once

#include <memory>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// The two halves of a lattice in a chessboard pattern: x + y + z is even or odd.
enum class HalfOfTexels { even, odd };

// Returns a lattice in which each texel of the other half has the mean of its lit neighbours along the axes.
// All of these are in `half`. A neighbour's weight is the fourth power of the normals' cosine times its
// paths. A texel without a neighbour that faces the same way keeps its own light. Normals, positions and
// paths are those of `lattice`. Throws Error{memory}.
std::shared_ptr<LightLattice> halfOf(const LightLattice& lattice, HalfOfTexels half);

}  // namespace isolux::gi
