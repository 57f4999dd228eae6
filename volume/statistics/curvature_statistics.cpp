#include "volume/statistics/curvature_statistics.h"

#include <algorithm>

#include "base/quantiles.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
#include "volume/statistics/visible_points.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kPoints = 2000;

Quantiles quantilesOf(std::vector<double>& values) {
  using base::lowerQuantile;
  return {lowerQuantile(values, 0.05), lowerQuantile(values, 0.5), lowerQuantile(values, 0.95)};
}

}  // namespace

Quantiles CurvatureStatistics::of(scene::LookMode look) const {
  const auto found = measures.find(look);
  return found == measures.end() ? Quantiles{} : found->second;
}

CurvatureStatistics curvatureStatistics(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                        double outward, const Coefficients* coefficients,
                                        const ScaledField* scaled, const HiddenPieces& hidden) {
  CurvatureStatistics result;
  std::vector<glm::dvec2> kappas;
  std::vector<double> flowlines;
  for (const VisiblePoint& point : visiblePoints(grid, blocks, isovalue, kPoints, hidden)) {
    const FieldSample field = sampleField(grid, scene::Field::cubic, coefficients, point.voxel, scaled);
    const PrincipalCurvature k = principalCurvature(worldGradient(grid.geometry(), field.gradient),
                                                    worldHessian(grid.geometry(), field.hessian), outward);
    if (k.normal == glm::dvec3(0.0)) continue;
    kappas.emplace_back(k.kappa1, k.kappa2);
    flowlines.push_back(k.flowline);
  }
  result.samples = kappas.size();
  if (kappas.empty()) return result;
  std::vector<double> values(kappas.size());
  for (const scene::LookInfo& look : scene::looks()) {
    if (!look.measure) continue;
    std::transform(kappas.begin(), kappas.end(), values.begin(),
                   [&](const glm::dvec2& kappa) { return look.measure(kappa.x, kappa.y); });
    result.measures[look.mode] = quantilesOf(values);
  }
  result.measures[scene::LookMode::flowline_curvature] = quantilesOf(flowlines);
  return result;
}

}  // namespace isolux::volume
