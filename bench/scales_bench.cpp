// Derivatives at a scale: what the field costs to build against the prefilter of the interpolating field, and
// what derivatives of it cost against those of the samples.
#include <cstdio>

#include <tbb/global_control.h>

#include "bench/bench.h"
#include "tests/support/unwatched.h"
#include "volume/cast/surface_derivatives.h"
#include "volume/phantom/phantom.h"

namespace isolux::bench {
namespace {

constexpr int kSize = 256, kPicture = 512;

volume::Grid gyroid() {
  base::Progress progress;
  return volume::makePhantom(volume::parsePhantom("gyroid:" + std::to_string(kSize)), progress);
}

// The same voxels, slices leaning over each other.
volume::Grid sheared(const volume::Grid& grid) {
  volume::GridGeometry geometry = grid.geometry();
  geometry.worldFromVoxel[2] += 0.3 * geometry.worldFromVoxel[1];
  return {geometry, grid.voxels(), grid.slope(), grid.intercept()};
}

void compareBuilding(const volume::Grid& grid) {
  const double voxel = grid.geometry().spacingMm().x;
  const volume::Grid leaning = sheared(grid);
  const auto build = [&](const volume::Grid& of, double voxels) {
    return [&of, scale = voxels * voxel] {
      base::Progress progress;
      volume::scaledField(of, scene::Field::cubic, scale, progress);
    };
  };
  std::printf(" building, %d^3\n", kSize);
  printComparison({"interpolating prefilter", "scale 0.5 voxels", "scale 1 voxel", "scale 2 voxels",
                   "scale 4 voxels", "scale 1 voxel, slices sheared"},
                  medians({[&] { volume::interpolatingCoefficients(grid); }, build(grid, 0.5),
                           build(grid, 1.0), build(grid, 2.0), build(grid, 4.0), build(leaning, 1.0)},
                          5));
}

// Points that lie side by side as those of a picture do: of a plane askew.
std::vector<glm::vec4> pointsOfPlane() {
  std::vector<glm::vec4> points;
  for (int y = 0; y < kPicture; ++y)
    for (int x = 0; x < kPicture; ++x) {
      const float s = static_cast<float>(x) / kPicture, t = static_cast<float>(y) / kPicture;
      points.emplace_back(glm::vec3(0.1f + 0.8f * s, 0.1f + 0.7f * t + 0.1f * s, 0.2f + 0.3f * s + 0.3f * t) *
                              static_cast<float>(kSize - 1),
                          1.0f);
    }
  return points;
}

void compareDerivatives(const volume::Grid& grid) {
  base::Progress progress;
  const volume::ScaledField scaled =
      volume::scaledField(grid, scene::Field::cubic, grid.geometry().spacingMm().x, progress);
  const std::vector<glm::vec4> points = pointsOfPlane();
  std::vector<glm::vec4> gradient(points.size()), diagonal(points.size()), mixed(points.size());
  const volume::DerivativeImages gradients{gradient, {}, {}}, hessians{gradient, diagonal, mixed};
  const volume::PictureArea area = volume::PictureArea::whole({kPicture, kPicture});
  const auto plain = [&](const volume::DerivativeImages& images) {
    return [&] { surfaceDerivatives(grid, {}, points, area, images); };
  };
  const auto atScale = [&](const volume::DerivativeImages& images) {
    return [&] { surfaceDerivatives(grid, {.scaled = &scaled}, points, area, images); };
  };
  const std::vector<double> times =
      medians({plain(gradients), atScale(gradients), plain(hessians), atScale(hessians)}, 15);
  std::printf(" derivatives on the processor at %zu points, one core\n", points.size());
  printComparison({"gradients", "gradients at a scale"}, {times[0], times[1]});
  printComparison({"gradients and Hessians", "gradients and Hessians at a scale"}, {times[2], times[3]});
}

void run() {
  const volume::Grid grid = gyroid();
  compareBuilding(grid);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  compareDerivatives(grid);
}

const Registration registration("scales", "derivatives at a scale: building the field, looking it up", run);

}  // namespace
}  // namespace isolux::bench
