// The numbers a look takes from the curvature of the surface as a whole where its settings leave them
// automatic: ends of colour maps, the threshold of ridges, what counts as hollow. No GL; 1/mm (Gaussian
// curvature: 1/mm^2).
//
// `flat` is the curvature below which a surface counts as flat: it stands in where the surface has none.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "scene/scene.h"
#include "volume/statistics/curvature_statistics.h"

namespace isolux::render {

// Some number that the picture shows is automatic and follows the surface.
bool readsCurvatureRanges(const scene::Scene& scene);

// The outer bounds of several surfaces' statistics.
volume::CurvatureStatistics outerBounds(const std::vector<volume::CurvatureStatistics>& surfaces);

// Low and high end of the colour map of look.mode, of both axes for curvature_2d. Automatic: measures with a
// sign get a range symmetric around 0, curvedness one from 0, the shape index -1 to 1. A single fixed end
// leaves the other one automatic; for curvature_2d it fixes both.
glm::dvec2 measureRange(const scene::Scene& scene, const volume::CurvatureStatistics& statistics,
                        double flat);

// The numbers behind settings of the look that are automatic and whose value the picture shows, by their
// paths: ends of the range.
std::map<std::string, double> foundNumbers(const scene::Scene& scene,
                                           const volume::CurvatureStatistics& statistics, double flat);

// From which curvature on ridges (x) and valleys (y) are drawn.
glm::dvec2 ridgeThresholds(const scene::Scene& scene, const volume::CurvatureStatistics& statistics,
                           double flat);

// From which length on lines of these thresholds are drawn, mm. Automatic: what is no longer than the
// radius of the threshold's curvature is a knob, not a line.
glm::dvec2 ridgeLengths(const scene::Scene& scene, const glm::dvec2& thresholds);

// A strong curvature of this surface.
double curvatureScale(const volume::CurvatureStatistics& statistics, double flat);

}  // namespace isolux::render
