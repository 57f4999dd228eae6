// Computes the automatic values of a look that depend on the curvature of the whole surface. These are ends
// of colour maps, the threshold of ridges and the curvature of hollows. No GL; 1/mm (Gaussian curvature:
// 1/mm^2).
//
// `flat` is the curvature below which a surface counts as flat: it is the fallback if the surface has no
// curvature.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "scene/scene.h"
#include "volume/statistics/curvature_statistics.h"

namespace isolux::render {

// Returns whether a number that the image shows is automatic and follows the surface.
bool readsCurvatureRanges(const scene::Scene& scene);

// Returns the outer bounds of several surfaces' statistics.
volume::CurvatureStatistics outerBounds(const std::vector<volume::CurvatureStatistics>& surfaces);

// Returns the low and high end of the colour map of look.mode, for both axes with curvature_2d. Automatic:
// signed measures get a range symmetric around 0, curvedness one from 0, the shape index -1 to 1. A single
// fixed end leaves the other one automatic; for curvature_2d it fixes both.
glm::dvec2 measureRange(const scene::Scene& scene, const volume::CurvatureStatistics& statistics,
                        double flat);

// Returns the values of automatic look settings that the image shows, by their paths: ends of the range.
std::map<std::string, double> foundNumbers(const scene::Scene& scene,
                                           const volume::CurvatureStatistics& statistics, double flat);

// Returns the curvatures above which ridges (x) and valleys (y) are drawn.
glm::dvec2 ridgeThresholds(const scene::Scene& scene, const volume::CurvatureStatistics& statistics,
                           double flat);

// Returns the minimum length of lines for these thresholds, mm. Automatic: a line no longer than the radius
// of the threshold's curvature is a bump, not a line.
glm::dvec2 ridgeLengths(const scene::Scene& scene, const glm::dvec2& thresholds);

// Returns a curvature that is strong for this surface.
double curvatureScale(const volume::CurvatureStatistics& statistics, double flat);

}  // namespace isolux::render
