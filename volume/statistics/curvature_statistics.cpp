#include "volume/statistics/curvature_statistics.h"

#include <algorithm>
#include <optional>

#include "base/quantiles.h"
#include "base/random.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {

namespace {

// The point where the surface cuts a random edge of a block's cells, if it does.
std::optional<glm::dvec3> cutOfRandomEdge(const Grid& grid, double isovalue, glm::ivec3 low, glm::ivec3 high,
                                          std::uint64_t trial) {
  const std::uint64_t random = base::counterHash(41, trial);
  const int axis = static_cast<int>(random % 3);
  glm::ivec3 at;
  for (int i = 0; i < 3; ++i)
    at[i] = low[i] + static_cast<int>((random >> (8 + 16 * i) & 0xffffu) %
                                      static_cast<std::uint64_t>(high[i] - low[i]));
  glm::ivec3 next = at;
  ++next[axis];
  const double a = grid.value(at.x, at.y, at.z) - isovalue, b = grid.value(next.x, next.y, next.z) - isovalue;
  if (!((a < 0.0 && b >= 0.0) || (a >= 0.0 && b < 0.0))) return std::nullopt;
  glm::dvec3 cut(at);
  cut[axis] += a / (a - b);
  return cut;
}

Quantiles quantilesOf(std::vector<double>& values) {
  using base::lowerQuantile;
  return {lowerQuantile(values, 0.05), lowerQuantile(values, 0.5), lowerQuantile(values, 0.95)};
}

template <class SampleAt>
CurvatureStatistics statisticsOf(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                 double outward, const SampleAt& sampleAt, std::size_t wanted) {
  CurvatureStatistics result;
  std::vector<std::uint32_t> active;
  const auto stored = static_cast<float>(grid.storedOfValue(isovalue));
  for (std::size_t i = 0; i < blocks.count(); ++i)
    if (blocks.active(i, stored)) active.push_back(static_cast<std::uint32_t>(i));
  if (active.empty()) return result;

  std::vector<glm::dvec2> kappas;
  const glm::ivec3 dims = blocks.dims();
  // A surface through a block of 8^3 cells cuts about 100 of its 1536 edges.
  for (std::uint64_t trial = 0; trial < 50 * wanted && kappas.size() < wanted; ++trial) {
    const auto block = static_cast<int>(active[base::counterHash(40, trial) % active.size()]);
    const glm::ivec3 low =
        glm::ivec3(block % dims.x, block / dims.x % dims.y, block / (dims.x * dims.y)) * blocks.blockCells();
    const glm::ivec3 high = glm::min(low + blocks.blockCells(), grid.dims() - 1);
    const auto cut = cutOfRandomEdge(grid, isovalue, low, high, trial);
    if (!cut) continue;
    const FieldSample field = sampleAt(*cut);
    const PrincipalCurvature k = principalCurvature(worldGradient(grid.geometry(), field.gradient),
                                                    worldHessian(grid.geometry(), field.hessian), outward);
    if (k.normal == glm::dvec3(0.0)) continue;
    kappas.emplace_back(k.kappa1, k.kappa2);
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
  return result;
}

}  // namespace

Quantiles CurvatureStatistics::of(scene::LookMode look) const {
  const auto found = measures.find(look);
  return found == measures.end() ? Quantiles{} : found->second;
}

CurvatureStatistics curvatureStatistics(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                        double outward, const Coefficients* coefficients,
                                        std::size_t wanted) {
  const auto sampleAt = [&](glm::dvec3 voxel) {
    return coefficients ? sampleCubic(*coefficients, grid, voxel) : sampleCubic(grid, voxel);
  };
  return statisticsOf(grid, blocks, isovalue, outward, sampleAt, wanted);
}

CurvatureStatistics curvatureStatistics(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                        double outward, const ScaledField& scaled, std::size_t wanted) {
  const auto sampleAt = [&](glm::dvec3 voxel) { return sampleScaled(scaled, grid, voxel); };
  return statisticsOf(grid, blocks, isovalue, outward, sampleAt, wanted);
}

}  // namespace isolux::volume
