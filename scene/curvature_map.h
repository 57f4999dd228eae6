// The two-dimensional colour map of look.curvature_points: (kappa1, kappa2) to colour.
//
// Kappas are in parts of the map's range and clamped to [-1, 1]; colours are linear RGB. Control points are
// joined by inverse-distance-squared weights (Shepard, "A two-dimensional interpolation function for
// irregularly-spaced data", 1968): smooth, exact at every point, never outside the colours of the points.
// kappa1 >= kappa2, so only the half on and below the diagonal is ever looked up.
//
// The automatic map is of one lightness all over, so that shading stays readable on it: hue by the shape
// index, in even steps from violet cups over green saddles to red caps, and chroma by the curvedness. What is
// flat is grey. Hue, chroma and lightness are those of OKLab (Ottosson 2020).
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace isolux::scene {

// `points` must not be empty. Points that coincide with `kappa` share it equally.
glm::dvec3 curvatureColor(std::span<const CurvaturePoint> points, glm::dvec2 kappa);

glm::dvec3 automaticCurvatureColor(glm::dvec2 kappa);

// The automatic map at its middle and around its kinds of shape: what an own map starts from.
std::vector<CurvaturePoint> automaticCurvaturePoints();

// The map of a look as size x size texels, kappa1 along rows from -1 to 1, rows from kappa2 = -1 to 1, at
// texel centres: a linear lookup at (kappa + 1) / 2 reads it.
std::vector<glm::vec3> curvatureTexels(const Look& look, int size);

}  // namespace isolux::scene
