// Provides the one-dimensional colour maps of look.colormap.
//
// Samples are linear RGB (BT.709) in [0, 1], evenly spaced from the low to the high end of the range, ends
// included. Sources:
//   viridis, inferno   van der Walt & Smith 2015 (CC0); lightness rises evenly
//   cividis            Nunez, Anderton & Renslow 2018; the same, also for colour-blind readers
//   gray               even in CIE lightness
//   coolwarm, blue_orange, purple_green   Moreland, "Diverging color maps for scientific visualization", 2009
//   spectral           ColorBrewer (Brewer & Harrower), 11 classes, joined linearly; blue is low
//   shape index        after Koenderink & van Doorn 1992: cups green and blue, saddles white, caps red
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/looks.h"

namespace isolux::scene {

// Returns `size` samples of a map. `automatic`: the colours that ColorMap::automatic selects.
std::vector<glm::vec3> colorMapSamples(ColorMap map, int size, LookColors automatic = LookColors::sequential);

}  // namespace isolux::scene
