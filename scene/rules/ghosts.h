// Adds uncertainty surfaces: a surface at its isovalue plus and minus multiples of the noise, as transparent
// isosurfaces (surfaces.ID.ghost).
#pragma once

#include <vector>

#include "scene/scene.h"

namespace isolux::scene {

// Adds the uncertainty surfaces of each surface that is shown at the end, first the one above its isovalue.
// If the noise is 0, adds none. Requires that isovalues and derivatives.noise are known.
void addGhosts(Scene& scene);

// Returns the isovalues (data units) of all visible surfaces, including uncertainty surfaces; the first
// surface's comes first.
std::vector<double> seenIsovalues(Scene scene);

}  // namespace isolux::scene
