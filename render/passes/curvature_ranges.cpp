#include "render/passes/curvature_ranges.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "scene/looks.h"
#include "scene/rules/needs.h"

namespace isolux::render {

namespace {

using scene::LookInfo;
using scene::LookKind;
using scene::LookMode;
using scene::LookRange;
using volume::CurvatureStatistics;
using volume::Quantiles;

double magnitude(const Quantiles& q) {
  return std::max(std::fabs(q.low), std::fabs(q.high));
}

bool isSquare(const scene::Look& look) {
  return scene::lookInfo(look.mode).kind == LookKind::square;
}

bool rangeFollowsSurface(const scene::Look& look) {
  if (isSquare(look)) return !look.rangeLow && !look.rangeHigh;
  return scene::isMeasure(look.mode) && scene::lookInfo(look.mode).range != LookRange::unit &&
         (!look.rangeLow || !look.rangeHigh);
}

glm::dvec2 automaticRange(const LookInfo& look, const CurvatureStatistics& s, double flat) {
  const auto symmetric = [](double most) { return glm::dvec2(-most, most); };
  if (look.kind == LookKind::square)
    return symmetric(std::max({magnitude(s.of(LookMode::kappa1)), magnitude(s.of(LookMode::kappa2)), flat}));
  // Of lengths: a part in 10^4 of the volume's diagonal.
  const double least = look.dimension == 2 ? flat * flat : look.dimension < 0 ? 1e-5 / flat : flat;
  switch (look.range) {
    case LookRange::symmetric:
      return symmetric(std::max(magnitude(s.of(look.mode)), least));
    case LookRange::fromZero:
      return {0.0, std::max(s.of(look.mode).high, least)};
    case LookRange::unit:
      break;
  }
  return {-1.0, 1.0};
}

}  // namespace

bool readsCurvatureRanges(const scene::Scene& scene) {
  const scene::Look& look = scene.look;
  if (scene::isPlain(scene)) return false;
  return rangeFollowsSurface(look) || look.mode == LookMode::accessibility || look.accessibility > 0.0 ||
         (look.ridges > 0.0 && !look.ridgeThreshold) || look.suggestiveContours > 0.0 ||
         scene::showsFlow(scene);
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
    for (auto& [look, quantiles] : sum.measures) {
      quantiles.low = std::min(quantiles.low, s.of(look).low);
      quantiles.high = std::max(quantiles.high, s.of(look).high);
    }
  }
  return sum;
}

glm::dvec2 measureRange(const scene::Scene& scene, const CurvatureStatistics& statistics, double flat) {
  const scene::Look& look = scene.look;
  if (isSquare(look) && (look.rangeLow || look.rangeHigh)) {
    const double most =
        std::max(std::fabs(look.rangeLow.value_or(0.0)), std::fabs(look.rangeHigh.value_or(0.0)));
    return {-most, most};
  }
  glm::dvec2 range = automaticRange(scene::lookInfo(look.mode), statistics, flat);
  if (look.rangeLow) range.x = *look.rangeLow;
  if (look.rangeHigh) range.y = *look.rangeHigh;
  return range;
}

std::map<std::string, double> foundNumbers(const scene::Scene& scene, const CurvatureStatistics& statistics,
                                           double flat) {
  std::map<std::string, double> found;
  if (!scene::isMeasure(scene.look.mode)) return found;
  const glm::dvec2 range = measureRange(scene, statistics, flat);
  if (!scene.look.rangeLow) found["look.range_low"] = range.x;
  if (!scene.look.rangeHigh) found["look.range_high"] = range.y;
  return found;
}

glm::dvec2 ridgeThresholds(const scene::Scene& scene, const CurvatureStatistics& statistics, double flat) {
  if (scene.look.ridgeThreshold) return glm::dvec2(*scene.look.ridgeThreshold);
  // Of the 95 % quantiles: lines on a few per cent of the surface. A surface without valleys has faint ones,
  // which are none: at least a quarter of what counts for the other kind.
  constexpr double part = 0.75, faint = 0.25;
  const double ridge = std::max(part * statistics.of(LookMode::kappa1).high, flat);
  const double valley = std::max(-part * statistics.of(LookMode::kappa2).low, flat);
  return {std::max(ridge, faint * valley), std::max(valley, faint * ridge)};
}

glm::dvec2 ridgeLengths(const scene::Scene& scene, const glm::dvec2& thresholds) {
  if (scene.look.ridgeLength) return glm::dvec2(*scene.look.ridgeLength);
  return 1.0 / glm::max(thresholds, 1e-30);
}

double curvatureScale(const CurvatureStatistics& statistics, double flat) {
  return std::max(
      {magnitude(statistics.of(LookMode::kappa1)), magnitude(statistics.of(LookMode::kappa2)), flat});
}

}  // namespace isolux::render
