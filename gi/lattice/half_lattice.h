// Stored light as half of its texels alone would give it: what another sampling of the same light changes, by
// the noise of paths and by where texels lie, is read off the two halves (docs/explanation/accuracy.md).
#pragma once

#include <memory>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// The texels of a lattice like the fields of a chessboard: x + y + z is even or odd.
enum class HalfOfTexels { even, odd };

// A lattice in which the texels of the other half hold the mean of their lit neighbours along the axes, which
// are all of `half`, each by the fourth power of the normals' cosine and its paths; where there is none that
// faces the same way they keep their own. Normals, places and paths are those of `lattice`. Throws
// Error{memory}.
std::shared_ptr<LightLattice> halfOf(const LightLattice& lattice, HalfOfTexels half);

}  // namespace isolux::gi
