#include "volume/prepared/csg.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <tbb/combinable.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "volume/field/reconstruct.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/read/input/patient.h"
#include "volume/statistics/histogram.h"

namespace isolux::volume {

namespace {

constexpr const char* kSigns[] = {"", " ∪ ", " ∩ ", " − ", " → "};  // of scene::Csg

double isovalueOf(const Volume& volume, base::Progress& progress) {
  if (volume.isovalue) return *volume.isovalue;
  return suggestIsovalue(*volume.grid, makeHistogram(*volume.grid, 512, progress), volume.unit);
}

// Calls visit(slope) for each pair of neighbouring voxels that the surface separates, slope in data units per
// mm, on all cores.
template <class Visit>
void forEachCut(const Grid& grid, double isovalue, base::Progress& progress, const Visit& visit) {
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  const std::size_t nx = grid.extent().row(), slice = grid.extent().slice();
  const auto look = [&](const auto& voxels) {
    const auto value = [&](std::size_t i) { return grid.valueOfStored(static_cast<double>(voxels[i])); };
    parallelPieces(grid.extent().rows(), 16, progress, {}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
        for (std::size_t x = 0; x < nx; ++x) {
          const std::size_t i = row * nx + x;
          const double here = value(i);
          const auto compare = [&](double there, double distance) {
            if ((here >= isovalue) != (there >= isovalue) && std::isfinite(here) && std::isfinite(there))
              visit(static_cast<float>(std::abs(here - there) / distance));
          };
          if (x > 0) compare(value(i - 1), spacing.x);
          if (i % slice >= nx) compare(value(i - nx), spacing.y);
          if (i >= slice) compare(value(i - slice), spacing.z);
        }
    });
  };
  grid.visit(look);
}

// How many of the cuts' slopes have each key, which keyOf() tells (below 2^16, or none).
template <class KeyOf>
std::vector<std::uint64_t> countCuts(const Grid& grid, double isovalue, base::Progress& progress,
                                     const KeyOf& keyOf) {
  tbb::combinable<std::vector<std::uint64_t>> partial([] { return std::vector<std::uint64_t>(1 << 16); });
  forEachCut(grid, isovalue, progress, [&](float slope) {
    const std::uint32_t key = keyOf(std::bit_cast<std::uint32_t>(slope));
    if (key < 1 << 16) ++partial.local()[key];
  });
  std::vector<std::uint64_t> sum(1 << 16);
  partial.combine_each([&](const std::vector<std::uint64_t>& counts) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += counts[i];
  });
  return sum;
}

// The key of the element with this rank; `rank` becomes that among the elements of this key.
std::uint32_t keyOfRank(const std::vector<std::uint64_t>& counts, std::uint64_t& rank) {
  std::uint32_t key = 0;
  for (; key + 1 < counts.size() && rank >= counts[key]; ++key) rank -= counts[key];
  return key;
}

// Data units per mm across the surface: the median over the pairs of neighbouring voxels that it separates;
// 0 without a surface. The bits of positive floats are in the order of their values, so the median's upper
// and then its lower half is found by counting: whatever the number of pairs, memory stays the same.
double steepness(const Grid& grid, double isovalue, base::Progress& progress) {
  const std::vector<std::uint64_t> upper =
      countCuts(grid, isovalue, progress, [](std::uint32_t bits) { return bits >> 16; });
  std::uint64_t total = 0;
  for (const std::uint64_t count : upper) total += count;
  if (total == 0) return 0.0;
  std::uint64_t rank = total / 2;
  const std::uint32_t high = keyOfRank(upper, rank);
  const std::vector<std::uint64_t> lower = countCuts(grid, isovalue, progress, [high](std::uint32_t bits) {
    return bits >> 16 == high ? bits & 0xffffu : 1u << 16;
  });
  return static_cast<double>(std::bit_cast<float>(high << 16 | keyOfRank(lower, rank)));
}

// A grid's values at the voxels of another one; NaN where it is missing or does not reach.
class Resampled {
 public:
  Resampled(const Grid& grid, const GridGeometry& onto)
      : grid_(grid),
        direct_(grid.geometry().sameAs(onto)),
        voxelFromVoxel_(grid.geometry().voxelFromWorld() * onto.worldFromVoxel) {}

  bool direct() const { return direct_; }
  double at(int x, int y, int z) const {
    if (direct_) return grid_.value(x, y, z);
    constexpr double slack = 1e-6;  // voxels: borders that meet
    const glm::dvec3 p(voxelFromVoxel_ * glm::dvec4(x, y, z, 1.0));
    if (!grid_.geometry().holds(p, slack)) return std::numeric_limits<double>::quiet_NaN();
    return sampleTrilinear(grid_, p).value;
  }

 private:
  const Grid& grid_;
  bool direct_;
  glm::dmat4 voxelFromVoxel_;
};

// f1 and f2 -> the combined value, csg.h.
struct Combination {
  scene::Csg op;
  double v1, v2, scale, weight;
  double least2;  // of the second: stands where there is none of it

  double operator()(double f1, double f2) const {
    if (std::isnan(f2)) f2 = least2;
    const double h = v1 + scale * (f2 - v2);
    if (op == scene::Csg::blend) return (1.0 - weight) * f1 + weight * h;
    if (op == scene::Csg::unite) return std::max(f1, h);
    return std::min(f1, op == scene::Csg::intersection ? h : 2.0 * v1 - h);
  }
};

Grid combine(const Grid& first, const Resampled& second, const Combination& combination,
             base::Progress& progress) {
  std::vector<float> values;
  resizeStoppably(values, first.geometry().voxelCount(), progress);
  parallelSteps(first.extent().rows(), progress, {0.0, 1.0, "combining"}, [&](std::size_t row) {
    for (glm::ivec3 at = first.extent().firstOfRow(row); at.x < first.dims().x; ++at.x) {
      const double f1 = first.value(at);
      values[first.index(at)] =
          static_cast<float>(std::isnan(f1) ? f1 : combination(f1, second.at(at.x, at.y, at.z)));
    }
  });
  return {first.geometry(), std::move(values), 1.0, 0.0, progress};
}

bool reachesOut(const GridGeometry& second, const GridGeometry& first) {
  const auto [low, high] = second.worldBounds();
  const auto [low1, high1] = first.worldBounds();
  const double slack = 1e-6 * glm::length(high1 - low1);
  return glm::any(glm::lessThan(low, low1 - slack)) || glm::any(glm::greaterThan(high, high1 + slack));
}

}  // namespace

bool showsBoth(scene::Csg op) {
  return op == scene::Csg::unite || op == scene::Csg::blend;
}

CsgResult combined(const Volume& first, const Volume& second, const CsgRequest& request,
                   base::Progress& progress) {
  const scene::Csg op = request.op;
  assert(op != scene::Csg::none);
  const Grid &f1 = *first.grid, &f2 = *second.grid;
  base::machineMemory().check(f1.geometry().voxelCount() * sizeof(float), "the combined volume",
                              "a volume of fewer voxels needs less");
  const double v1 = isovalueOf(first, progress),
               v2 = request.secondIsovalue ? *request.secondIsovalue : isovalueOf(second, progress);
  double scale = 1.0;
  if (first.unit.empty() || first.unit != second.unit) {
    const double steep1 = steepness(f1, v1, progress), steep2 = steepness(f2, v2, progress);
    if (steep1 > 0.0 && steep2 > 0.0) scale = steep1 / steep2;
  }
  const Resampled sampled(f2, f1.geometry());
  const Combination combination{op, v1, v2, scale, request.weight, std::min(f2.minimum(), v2)};

  CsgResult result;
  result.secondIsovalue = v2;
  Volume& volume = result.volume;
  volume = first;
  volume.grid = std::make_shared<Grid>(combine(f1, sampled, combination, progress));
  rememberPatient(volume.grid, patientOf(first.grid));
  const char* const sign = kSigns[static_cast<int>(op)];
  volume.name = first.name + sign + second.name;
  volume.format = first.format + sign + second.format;
  volume.fileType = VoxelType::float32;
  volume.isovalue = v1;
  for (const std::string& warning : second.warnings) volume.warnings.push_back("second volume: " + warning);
  if (!sampled.direct())
    volume.warnings.emplace_back(
        "the second volume has another grid; interpolated at the voxels of the first");
  if (showsBoth(op) && reachesOut(f2.geometry(), f1.geometry()))
    volume.warnings.emplace_back("the second volume is cut off where the first one's grid ends");
  if (!(volume.grid->minimum() < v1 && v1 <= volume.grid->maximum()))
    volume.warnings.emplace_back("the combined solid is empty or fills the whole grid");
  return result;
}

}  // namespace isolux::volume
