#include "app/study/study_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/quantiles.h"

namespace isolux::app {

double angleDegrees(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * (180.0 / std::numbers::pi);
}

double curvatureError(double kappa1, double kappa2, const TrueShape& reference, double flatCurvature) {
  const double size = std::max({std::abs(reference.kappa1), std::abs(reference.kappa2), flatCurvature});
  return std::max(std::abs(kappa1 - reference.kappa1), std::abs(kappa2 - reference.kappa2)) / size;
}

namespace {

double partsPerMillion(std::size_t count, std::size_t of) {
  return of == 0 ? 0.0 : 1e6 * static_cast<double>(count) / static_cast<double>(of);
}

}  // namespace

bool isFirstCrossing(double depthMm, const TrueHit& reference) {
  const double behind = depthMm - reference.depthMm;
  return std::abs(behind) * reference.voxelsPerMm <= kSameCrossingVoxels &&
         behind <= reference.nextMm - depthMm;
}

Spread spreadOf(std::vector<double> errors) {
  Spread spread;
  spread.pixels = errors.size();
  if (errors.empty()) {
    spread.median = spread.rms = spread.most99 = spread.maximum = std::numeric_limits<double>::quiet_NaN();
    return spread;
  }
  std::ranges::sort(errors);
  double squares = 0.0;
  for (const double error : errors) squares += error * error;
  spread.maximum = errors.back();
  spread.median = base::quantile(errors, 0.5);
  spread.rms = std::sqrt(squares / static_cast<double>(errors.size()));
  spread.most99 = base::quantile(errors, 0.99);
  return spread;
}

double unknownShare(const DrawnImages& drawn) {
  std::size_t seen = 0, unknown = 0;
  for (std::size_t i = 0; i < drawn.hit.size(); ++i) {
    if (drawn.hit[i] != 1.0f) continue;
    ++seen;
    if (!(drawn.confidence[i] >= 0.5f)) ++unknown;
  }
  return static_cast<double>(unknown) / static_cast<double>(seen);
}

double Errors::missedPpm() const {
  return partsPerMillion(missed, pixels);
}
double Errors::inventedPpm() const {
  return partsPerMillion(invented, pixels);
}

Errors errorsOf(const DrawnImages& drawn, const TrueSurface& reference,
                const std::function<bool(std::size_t)>& undecided) {
  Errors errors;
  errors.pixels = reference.hits.size();
  std::vector<double> depthVoxels, depthMm, normal, curvature;
  for (std::size_t i = 0; i < errors.pixels; ++i) {
    const TrueHit& expected = reference.hits[i];
    const bool hit = drawn.hit[i] != 0.0f;
    if (expected.hit) ++errors.surface;
    if (!expected.hit && !hit) continue;
    const double depth = drawn.depthMm[i];
    if (!expected.hit || !hit || !isFirstCrossing(depth, expected)) {
      const bool missing = expected.hit && !(hit && depth < expected.depthMm);
      ++(undecided(i) ? errors.undecided : missing ? errors.missed : errors.invented);
      continue;
    }
    depthMm.push_back(std::abs(depth - expected.depthMm));
    depthVoxels.push_back(depthMm.back() * expected.voxelsPerMm);

    const TrueShape& shape = reference.shapes[i];
    const glm::dvec3 n(drawn.normal[3 * i], drawn.normal[3 * i + 1], drawn.normal[3 * i + 2]);
    if (shape.hasNormal && !std::isnan(n.x)) normal.push_back(angleDegrees(n, shape.normal));
    const float* const kappa = &drawn.kappa[2 * i];
    if (shape.hasCurvature && !std::isnan(kappa[0]))
      curvature.push_back(curvatureError(kappa[0], kappa[1], shape, reference.flatCurvature));
  }
  errors.depthVoxels = spreadOf(std::move(depthVoxels));
  errors.depthMm = spreadOf(std::move(depthMm));
  errors.normalDegrees = spreadOf(std::move(normal));
  errors.curvature = spreadOf(std::move(curvature));
  return errors;
}

}  // namespace isolux::app
