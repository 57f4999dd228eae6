// The first surface at its isovalue plus and minus multiples of the noise, as transparent isosurfaces beside
// it (isosurface.ghost).
#pragma once

#include <vector>

#include "scene/scene.h"

namespace isolux::scene {

// Further isosurfaces that are not shown become the ghosts, in their order and colours: first that above the
// isovalue.
// With one of them free there is that ghost alone, with none there is none; nor is there without noise.
// isosurface.value and derivatives.noise are known.
void addGhosts(Scene& scene);
// How many of the two found no further isosurface free.
int ghostsWithoutRoom(const Scene& scene);

// Isovalues (data units) of all that can be seen, ghosts among them; the first surface's comes first.
std::vector<double> seenIsovalues(Scene scene);

}  // namespace isolux::scene
