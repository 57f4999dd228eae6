// Provides the one-dimensional colour maps of look.colormap, and transfer functions of control points.
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

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/looks.h"
#include "scene/scene.h"

namespace isolux::scene {

// Returns `size` samples of a map. `automatic`: the colours that ColorMap::automatic selects.
std::vector<glm::vec3> colorMapSamples(ColorMap map, int size, LookColors automatic = LookColors::sequential);

// Returns the colour at t: linear between neighbours, that of the first and last point beyond them. Requires
// points in ascending order, at least one; of several at t, the last one counts.
glm::dvec3 colorOfPoints(std::span<const ColorPoint> points, double t);
// Returns `size` samples from position 0 to 1, ends included.
std::vector<glm::vec3> pointSamples(std::span<const ColorPoint> points, int size);

// Returns samples of the map that the look selects, look.colormap_points aside: the start of a custom one.
std::vector<ColorPoint> automaticColorPoints(const Look& look);
// Returns the points that automatic crevice shading amounts to: dark brown at 0, white at 1.
std::vector<ColorPoint> automaticAccessibilityPoints();

}  // namespace isolux::scene
