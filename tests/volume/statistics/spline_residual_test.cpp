// The gap between trilinear and spline surfaces, judged by the spline's own coefficients.
#include "volume/statistics/spline_residual.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/progress.h"
#include "base/random.h"
#include "tests/support/unwatched.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_hit.h"
#include "volume/phantom/phantom.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {
namespace {

Grid phantomOf(const char* text) {
  base::Progress progress;
  return makePhantom(parsePhantom(text), progress);
}

// First hits of parallel rays, a voxel apart.
std::vector<glm::dvec3> hits(const Grid& grid, double isovalue) {
  base::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  const glm::dvec3 middle = 0.5 * glm::dvec3(grid.dims() - 1), along = glm::normalize(glm::dvec3(3, 5, 8));
  const glm::dvec3 right = glm::normalize(glm::cross(along, glm::dvec3(0, 0, 1))),
                   up = glm::cross(right, along);
  const int reach = static_cast<int>(glm::length(middle));
  std::vector<glm::dvec3> points;
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i) {
      const glm::dvec3 start = middle + static_cast<double>(i) * right + static_cast<double>(j) * up;
      const auto hit = firstHit(grid, blocks, isovalue, {start - 2.0 * reach * along, along, 0.0});
      if (hit) points.push_back(hit->voxel);
    }
  return points;
}

TEST(SplineResidual, IsThatOfTheSplinesCoefficients) {
  for (const char* name : {"noise:24", "wires:64", "marschner_lobb:32", "head:40"}) {
    const Grid grid = phantomOf(name);
    const double isovalue = phantomNamed(parsePhantom(name).name).isovalue;
    const Coefficients coefficients = interpolatingCoefficients(grid);
    const std::vector<glm::dvec3> points = hits(grid, isovalue);
    ASSERT_GT(points.size(), 40u) << name;
    for (const double gap : {0.02, 0.1, 0.3}) {
      std::size_t beside = 0;
      for (const glm::dvec3& point : points) {
        const FieldSample spline = sampleCubic(coefficients, grid, point);
        const double trilinear = sampleTrilinear(grid, point).value;
        if (std::abs(spline.value - trilinear) > gap * glm::length(spline.gradient)) ++beside;
      }
      const double share = static_cast<double>(beside) / static_cast<double>(points.size());
      EXPECT_NEAR(shareBesideSpline(grid, points, gap), share, 1.5 / static_cast<double>(points.size()))
          << name << ' ' << gap;
    }
  }
}

TEST(SplineResidual, TellsWiresFromSurfacesThatAreResolved) {
  const auto share = [](const char* name) {
    const Grid grid = phantomOf(name);
    return shareBesideSpline(grid, hits(grid, phantomNamed(parsePhantom(name).name).isovalue));
  };
  EXPECT_GT(share("wires:128"), 0.5);  // 1.4 voxels wide
  EXPECT_LT(share("gyroid:64"), 0.05);
  EXPECT_LT(share("torus:64"), 0.01);
  EXPECT_LT(share("head:192"), kManyBesideSpline);
}

TEST(SplineResidual, PointsNearMissingVoxelsDoNotCount) {
  base::Progress progress;
  std::vector<float> values(16 * 16 * 16, 1.0f);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<float>(base::normalNoise(3, i));
  values[8 * 256 + 8 * 16 + 8] = std::nanf("");
  const Grid grid(GridGeometry::make(glm::ivec3(16), glm::dvec3(1.0), glm::dvec3(0.0)), std::move(values),
                  1.0, 0.0, progress);
  const std::vector<glm::dvec3> near{{8.5, 8.0, 8.0}, {7.2, 8.1, 8.9}};
  EXPECT_EQ(shareBesideSpline(grid, near), 0.0);
  EXPECT_EQ(shareBesideSpline(grid, {}), 0.0);
}

}  // namespace
}  // namespace isolux::volume
