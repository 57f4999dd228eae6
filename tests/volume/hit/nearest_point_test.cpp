// The nearest point of an isosurface, against a search of the whole neighbourhood.
#include "volume/hit/nearest_point.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {
namespace {

using volume::nearestSurfacePoint;

constexpr glm::vec3 kReach(1.0f);

// The least distance from `voxel` to a change of side among points 0.05 voxels apart, within reach; infinite
// where there is none.
double searched(const volume::Grid& grid, glm::dvec3 voxel, double isovalue) {
  constexpr int steps = 20;
  const auto inside = [&](glm::dvec3 p) { return volume::sampleTrilinear(grid, p).value >= isovalue; };
  double least = std::numeric_limits<double>::infinity();
  for (int z = -steps; z < steps; ++z)
    for (int y = -steps; y < steps; ++y)
      for (int x = -steps; x < steps; ++x) {
        const glm::dvec3 p = voxel + glm::dvec3(x, y, z) / static_cast<double>(steps);
        const double distance = glm::length(p - voxel);
        if (distance >= least) continue;
        const bool side = inside(p);
        for (int axis = 0; axis < 3; ++axis) {
          glm::dvec3 next = p;
          next[axis] += 1.0 / steps;
          if (inside(next) != side) least = distance;
        }
      }
  return least;
}

TEST(NearestSurfacePoint, IsOnTheSurfaceAndNearlyTheNearest) {
  for (const char* name : {"ball", "gyroid", "sheets", "head"}) {
    const volume::Grid grid = phantomGrid(name, std::string(name) == "head" ? 96 : 40);
    const double isovalue = std::string(name) == "head" ? 300.0 : 0.0;
    int found = 0;
    double excess = 0.0;
    for (int i = 0; i < 4000 && found < 60; ++i) {
      const std::int64_t n = i;
      const glm::ivec3 texel =
          glm::ivec3(3) + glm::ivec3(glm::i64vec3(n * 7919 % 31, n * 104729 % 33, n * 1299709 % 34));
      const auto point = nearestSurfacePoint(grid, glm::vec3(texel), kReach, static_cast<float>(isovalue));
      if (!point) continue;
      ++found;
      const volume::FieldSample at = volume::sampleTrilinear(grid, glm::dvec3(*point));
      EXPECT_LT(std::abs(at.value - isovalue), 2e-3 * glm::length(at.gradient) + 1e-5 * std::abs(isovalue))
          << name << " " << i;
      const double distance = glm::length(glm::dvec3(*point) - glm::dvec3(texel));
      const double least = searched(grid, glm::dvec3(texel), isovalue);
      EXPECT_LT(distance, least + 0.5) << name << " " << i;
      excess += std::max(distance - least, 0.0);
    }
    ASSERT_GT(found, 20) << name;
    EXPECT_LT(excess / found, 0.08) << name;
  }
}

// Every texel that a lookup at a point of the surface reads has a point of its own.
TEST(NearestSurfacePoint, EveryCornerOfACellThatIsCrossedHasOne) {
  const volume::Grid grid = phantomGrid("noise", 24);
  std::vector<double> off;  // voxels, to first order
  for (int z = 0; z < 23; ++z)
    for (int y = 0; y < 23; ++y)
      for (int x = 0; x < 23; ++x) {
        bool above = false, below = false;
        for (int c = 0; c < 8; ++c)
          (grid.stored(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)) >= 0.0 ? above : below) = true;
        if (!above || !below) continue;
        for (int c = 0; c < 8; ++c) {
          const glm::vec3 corner(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
          const auto point = nearestSurfacePoint(grid, corner, kReach, 0.0f);
          ASSERT_TRUE(point) << x << " " << y << " " << z;
          const volume::FieldSample at = volume::sampleTrilinear(grid, glm::dvec3(*point));
          off.push_back(std::abs(at.value) / glm::length(at.gradient));
        }
      }
  // Two of Newton's steps lead back to it; one leaves ten times as much.
  std::sort(off.begin(), off.end());
  EXPECT_LT(off[off.size() * 95 / 100], 3e-6);
}

TEST(NearestSurfacePoint, IsTheFootOnAPlane) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(1.0, 2.0, -2.0));
  const volume::Grid grid = gridOfVoxels(
      unitGeometry({9, 9, 9}), [&](glm::dvec3 v) { return glm::dot(normal, v - glm::dvec3(4.2, 3.9, 4.1)); });
  const auto point = nearestSurfacePoint(grid, {4.0f, 4.0f, 4.0f}, kReach, 0.0f);
  ASSERT_TRUE(point);
  const double height = glm::dot(normal, glm::dvec3(-0.2, 0.1, -0.1));
  const glm::dvec3 foot = glm::dvec3(4.0) - height * normal;
  EXPECT_LT(glm::length(glm::dvec3(*point) - foot), 1e-4);
}

TEST(NearestSurfacePoint, FarOffAndInGapsThereIsNone) {
  const volume::Grid ball = phantomGrid("ball", 40);
  EXPECT_FALSE(nearestSurfacePoint(ball, {20.0f, 20.0f, 20.0f}, kReach, 0.0f));
  EXPECT_FALSE(nearestSurfacePoint(ball, {1.0f, 1.0f, 1.0f}, kReach, 0.0f));
  const volume::Grid gap = gridOfVoxels(unitGeometry({5, 5, 5}), [](glm::dvec3 v) {
    return v.x < 2.0 ? 1.0 : v.x > 2.0 ? -1.0 : std::numeric_limits<double>::quiet_NaN();
  });
  EXPECT_FALSE(nearestSurfacePoint(gap, {2.0f, 2.0f, 2.0f}, kReach, 0.0f));
}

// An edge of the surface whose cells all have a missing corner: there is no gradient to slide along.
TEST(NearestSurfacePoint, BesideMissingVoxelsItIsANumber) {
  const volume::Grid grid = gridOfVoxels(unitGeometry(glm::ivec3(8)), [](glm::dvec3 p) {
    const bool missing = p.x == 3.0 && (p.y != 4.0 || p.z != 4.0);
    return missing ? std::numeric_limits<double>::quiet_NaN() : 3.5 - p.x;
  });
  const auto point = nearestSurfacePoint(grid, {3.2f, 4.1f, 4.1f}, kReach, 0.0f);
  ASSERT_TRUE(point);
  EXPECT_FLOAT_EQ(point->x, 3.5f);
  EXPECT_FLOAT_EQ(point->y, 4.0f);
  EXPECT_FLOAT_EQ(point->z, 4.0f);
}

// The same, and the volume's first voxel lies on the surface: where a place that is no number is looked up.
TEST(NearestSurfacePoint, WithoutAGradientItDoesNotSlide) {
  const volume::Grid gap = gridOfVoxels(unitGeometry(glm::ivec3(8)), [](glm::dvec3 p) {
    if (p == glm::dvec3(0.0)) return 0.0;
    const bool missing = p.x == 3.0 && (p.y != 4.0 || p.z != 4.0);
    return missing ? std::numeric_limits<double>::quiet_NaN() : 3.5 - p.x;
  });
  const auto beside = nearestSurfacePoint(gap, {3.2f, 4.1f, 4.1f}, kReach, 0.0f);
  ASSERT_TRUE(beside);
  EXPECT_EQ(*beside, glm::vec3(3.5f, 4.0f, 4.0f));
  // The foot lies where all is -1.
  const volume::Grid plateau =
      gridOfVoxels(unitGeometry({4, 3, 2}), [](glm::dvec3 p) { return p.x > 0.0 || p.y > 1.0 ? -1.0 : p.y; });
  const auto crossing = nearestSurfacePoint(plateau, {1.95f, 0.3f, 0.0f}, kReach, 0.0f);
  ASSERT_TRUE(crossing);
  EXPECT_EQ(*crossing, glm::vec3(0.5f, 1.0f, 0.0f));
}

}  // namespace
}  // namespace isolux::test
