// Adds uncertainty surfaces: the first surface at its isovalue plus and minus multiples of the noise, as
// transparent isosurfaces (isosurface.ghost).
#pragma once

#include <vector>

#include "scene/scene.h"

namespace isolux::scene {

// Turns further isosurfaces that are not shown into uncertainty surfaces, in their order and colours: first
// the one above the isovalue. If only one of them is free, adds one; if none is free or the noise is 0, adds
// none. Requires that isosurface.value and derivatives.noise are known.
void addGhosts(Scene& scene);
// Returns how many of the two uncertainty surfaces found no free further isosurface.
int ghostsWithoutRoom(const Scene& scene);

// Returns the isovalues (data units) of all visible surfaces, including uncertainty surfaces; the first
// surface's comes first.
std::vector<double> seenIsovalues(Scene scene);

}  // namespace isolux::scene
