#include "render/passes/curvature_ranges.h"

#include <algorithm>
#include <cmath>

#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

using scene::LookMode;
using volume::CurvatureStatistics;
using volume::Quantiles;

double magnitude(const Quantiles& q) {
  return std::max(std::fabs(q.low), std::fabs(q.high));
}

bool rangeFollowsSurface(const scene::Look& look) {
  if (look.mode == LookMode::curvature_2d) return !look.rangeLow && !look.rangeHigh;
  return scene::isMeasure(look.mode) && look.mode != LookMode::shape_index &&
         (!look.rangeLow || !look.rangeHigh);
}

glm::dvec2 automaticRange(LookMode mode, const CurvatureStatistics& s, double flat) {
  const auto symmetric = [](double most) { return glm::dvec2(-most, most); };
  switch (mode) {
    case LookMode::kappa1:
      return symmetric(std::max(magnitude(s.kappa1), flat));
    case LookMode::kappa2:
      return symmetric(std::max(magnitude(s.kappa2), flat));
    case LookMode::mean_curvature:
      return symmetric(std::max(magnitude(s.mean), flat));
    case LookMode::gaussian_curvature:
      return symmetric(std::max(magnitude(s.gaussian), flat * flat));
    case LookMode::curvedness:
      return {0.0, std::max(s.curvedness.high, flat)};
    case LookMode::curvature_2d:
      return symmetric(std::max({magnitude(s.kappa1), magnitude(s.kappa2), flat}));
    default:
      return {-1.0, 1.0};
  }
}

}  // namespace

bool readsCurvatureRanges(const scene::Scene& scene) {
  const scene::Look& look = scene.look;
  if (scene::isPlain(scene)) return false;
  return rangeFollowsSurface(look) || look.mode == LookMode::accessibility || look.accessibility > 0.0 ||
         (look.ridges > 0.0 && !look.ridgeThreshold) || look.suggestiveContours > 0.0;
}

CurvatureStatistics outerBounds(const std::vector<CurvatureStatistics>& surfaces) {
  CurvatureStatistics sum;
  for (const CurvatureStatistics& s : surfaces) {
    if (s.samples == 0) continue;
    if (sum.samples == 0) {
      sum = s;
      continue;
    }
    sum.samples += s.samples;
    for (Quantiles CurvatureStatistics::*q :
         {&CurvatureStatistics::kappa1, &CurvatureStatistics::kappa2, &CurvatureStatistics::mean,
          &CurvatureStatistics::gaussian, &CurvatureStatistics::curvedness}) {
      (sum.*q).low = std::min((sum.*q).low, (s.*q).low);
      (sum.*q).high = std::max((sum.*q).high, (s.*q).high);
    }
  }
  return sum;
}

glm::dvec2 measureRange(const scene::Scene& scene, const CurvatureStatistics& statistics, double flat) {
  const scene::Look& look = scene.look;
  if (look.mode == LookMode::curvature_2d && (look.rangeLow || look.rangeHigh)) {
    const double most =
        std::max(std::fabs(look.rangeLow.value_or(0.0)), std::fabs(look.rangeHigh.value_or(0.0)));
    return {-most, most};
  }
  glm::dvec2 range = automaticRange(look.mode, statistics, flat);
  if (look.rangeLow) range.x = *look.rangeLow;
  if (look.rangeHigh) range.y = *look.rangeHigh;
  return range;
}

glm::dvec2 ridgeThresholds(const scene::Scene& scene, const CurvatureStatistics& statistics, double flat) {
  if (scene.look.ridgeThreshold) return glm::dvec2(*scene.look.ridgeThreshold);
  // Of the 95 % quantiles: lines on a few per cent of the surface. A surface without valleys has faint ones,
  // which are none: at least a quarter of what counts for the other kind.
  constexpr double part = 0.75, faint = 0.25;
  const double ridge = std::max(part * statistics.kappa1.high, flat);
  const double valley = std::max(-part * statistics.kappa2.low, flat);
  return {std::max(ridge, faint * valley), std::max(valley, faint * ridge)};
}

double curvatureScale(const CurvatureStatistics& statistics, double flat) {
  return std::max({magnitude(statistics.kappa1), magnitude(statistics.kappa2), flat});
}

}  // namespace isolux::render
