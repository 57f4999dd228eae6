#include "volume/csg.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include <tbb/parallel_for.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "volume/histogram.h"
#include "volume/reconstruct.h"

namespace isolux::volume {

namespace {

double isovalueOf(const Volume& volume) {
  if (volume.isovalue) return *volume.isovalue;
  return suggestIsovalue(*volume.grid, makeHistogram(*volume.grid), volume.unit);
}

// Data units per mm across the surface: the median over the pairs of neighbouring voxels that it separates;
// 0 without a surface.
double steepness(const Grid& grid, double isovalue) {
  std::vector<float> slopes;
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  const glm::ivec3 dims = grid.dims();
  const auto add = [&](double here, double there, double distance) {
    if ((here >= isovalue) != (there >= isovalue) && std::isfinite(here) && std::isfinite(there))
      slopes.push_back(static_cast<float>(std::abs(here - there) / distance));
  };
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const double here = grid.value(x, y, z);
        if (x > 0) add(here, grid.value(x - 1, y, z), spacing.x);
        if (y > 0) add(here, grid.value(x, y - 1, z), spacing.y);
        if (z > 0) add(here, grid.value(x, y, z - 1), spacing.z);
      }
  if (slopes.empty()) return 0.0;
  const auto middle = slopes.begin() + static_cast<std::ptrdiff_t>(slopes.size() / 2);
  std::nth_element(slopes.begin(), middle, slopes.end());
  return *middle;
}

bool sameGeometry(const GridGeometry& a, const GridGeometry& b) {
  if (a.dims != b.dims) return false;
  const double tolerance = 1e-6 * std::min({a.spacingMm().x, a.spacingMm().y, a.spacingMm().z});
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 voxel((corner & 1) ? a.dims.x - 1 : 0, (corner & 2) ? a.dims.y - 1 : 0,
                           (corner & 4) ? a.dims.z - 1 : 0, 1.0);
    if (glm::length(a.worldFromVoxel * voxel - b.worldFromVoxel * voxel) > tolerance) return false;
  }
  return true;
}

// A grid's values at the voxels of another one; NaN where it is missing or does not reach.
class Resampled {
 public:
  Resampled(const Grid& grid, const GridGeometry& onto)
      : grid_(grid),
        direct_(sameGeometry(grid.geometry(), onto)),
        voxelFromVoxel_(grid.geometry().voxelFromWorld() * onto.worldFromVoxel) {}

  bool direct() const { return direct_; }
  double at(int x, int y, int z) const {
    if (direct_) return grid_.value(x, y, z);
    constexpr double slack = 1e-6;  // voxels: borders that meet
    const glm::dvec3 p(voxelFromVoxel_ * glm::dvec4(x, y, z, 1.0));
    for (int axis = 0; axis < 3; ++axis)
      if (!(p[axis] >= -slack && p[axis] <= grid_.dims()[axis] - 1 + slack))
        return std::numeric_limits<double>::quiet_NaN();
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
  double v1, v2, scale;
  double least2;  // of the second: stands where there is none of it

  double operator()(double f1, double f2) const {
    if (std::isnan(f2)) f2 = least2;
    const double h = v1 + scale * (f2 - v2);
    if (op == scene::Csg::unite) return std::max(f1, h);
    return std::min(f1, op == scene::Csg::intersection ? h : 2.0 * v1 - h);
  }
};

Grid combine(const Grid& first, const Resampled& second, const Combination& combination,
             scene::Progress& progress) {
  const glm::ivec3 dims = first.dims();
  std::vector<float> values(first.geometry().voxelCount());
  progress.report(0.0, "combining");
  tbb::parallel_for(0, dims.z, [&](int z) {
    if (progress.stopRequested()) return;
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const double f1 = first.value(x, y, z);
        values[first.index(x, y, z)] =
            static_cast<float>(std::isnan(f1) ? f1 : combination(f1, second.at(x, y, z)));
      }
  });
  progress.throwIfStopped();
  return {first.geometry(), std::move(values)};
}

const char* signOf(scene::Csg op) {
  return op == scene::Csg::unite ? " ∪ " : op == scene::Csg::intersection ? " ∩ " : " − ";
}

bool reachesOut(const GridGeometry& second, const GridGeometry& first) {
  glm::dvec3 low, high, low1, high1;
  second.worldBounds(low, high);
  first.worldBounds(low1, high1);
  const double slack = 1e-6 * glm::length(high1 - low1);
  return glm::any(glm::lessThan(low, low1 - slack)) || glm::any(glm::greaterThan(high, high1 + slack));
}

}  // namespace

CsgResult combined(const Volume& first, const Volume& second, scene::Csg op,
                   std::optional<double> secondIsovalue, scene::Progress& progress) {
  assert(op != scene::Csg::none);
  const Grid &f1 = *first.grid, &f2 = *second.grid;
  scene::machineMemory().check(f1.geometry().voxelCount() * sizeof(float), "the combined volume",
                               "a volume of fewer voxels needs less");
  const double v1 = isovalueOf(first), v2 = secondIsovalue ? *secondIsovalue : isovalueOf(second);
  double scale = 1.0;
  if (first.unit.empty() || first.unit != second.unit) {
    const double steep1 = steepness(f1, v1), steep2 = steepness(f2, v2);
    if (steep1 > 0.0 && steep2 > 0.0) scale = steep1 / steep2;
  }
  const Resampled sampled(f2, f1.geometry());
  const Combination combination{op, v1, v2, scale, std::min(f2.minimum(), v2)};

  CsgResult result;
  result.secondIsovalue = v2;
  Volume& volume = result.volume;
  volume = first;
  volume.grid = std::make_shared<Grid>(combine(f1, sampled, combination, progress));
  volume.name = first.name + signOf(op) + second.name;
  volume.format = first.format + signOf(op) + second.format;
  volume.fileType = VoxelType::float32;
  volume.isovalue = v1;
  for (const std::string& warning : second.warnings) volume.warnings.push_back("second volume: " + warning);
  if (!sampled.direct())
    volume.warnings.emplace_back(
        "the second volume lies on another grid: interpolated at the voxels of the first one");
  if (op == scene::Csg::unite && reachesOut(f2.geometry(), f1.geometry()))
    volume.warnings.emplace_back("the second volume is cut off where the first one's grid ends");
  if (!(volume.grid->minimum() < v1 && v1 <= volume.grid->maximum()))
    volume.warnings.emplace_back("the combined solid is empty or fills the whole grid");
  return result;
}

}  // namespace isolux::volume
