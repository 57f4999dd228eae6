// Provides the two-dimensional colour map of look.curvature_points: (kappa1, kappa2) to colour.
//
// kappa1 and kappa2 are fractions of the map's range, clamped to [-1, 1]; colours are linear RGB. Control
// points are joined by inverse-distance-squared weights (Shepard, "A two-dimensional interpolation function
// for irregularly-spaced data", 1968). The map is smooth, exact at every point, and never outside the colours
// of the points. kappa1 >= kappa2, so only the half on and below the diagonal is ever looked up.
//
// The automatic map has constant lightness, so that shading stays readable. The hue shows the shape index, in
// even steps from violet cups over green saddles to red caps. The chroma shows the curvedness; flat points
// are grey. Hue, chroma and lightness are those of OKLab (Ottosson 2020).
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// Returns the colour at `kappa`. Requires that `points` is not empty. Points that coincide with `kappa` share
// it equally.
glm::dvec3 curvatureColor(std::span<const CurvaturePoint> points, glm::dvec2 kappa);

glm::dvec3 automaticCurvatureColor(glm::dvec2 kappa);

// Returns samples of the automatic map, at its centre and around the shape index, as the start of a custom
// map.
std::vector<CurvaturePoint> automaticCurvaturePoints();

// Returns the map of a look as size x size texels. kappa1 runs along rows from -1 to 1, rows from kappa2 = -1
// to 1, at texel centres. A linear lookup at (kappa + 1) / 2 reads it.
std::vector<glm::vec3> curvatureTexels(const Look& look, int size);

}  // namespace isolux::scene
