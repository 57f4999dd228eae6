// Where the texels of a lattice are lit.
#include "gi/trace/lattice_estimator.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/gi/light_fixture.h"

namespace isolux::gi {
namespace {

constexpr int kSize = 21;
constexpr float kRadius = 6.3f;

// A ball of that radius about the middle voxel is the isosurface of 0.
std::shared_ptr<const LightScene> ballUnderAWhiteSky() {
  const auto volume =
      test::volumeOf(test::cube(kSize), [](glm::dvec3 p) { return kRadius - glm::length(p); });
  LightScene light = test::lightSceneOf(volume);
  test::setUnitSky(light);
  return std::make_shared<const LightScene>(std::move(light));
}

std::vector<glm::ivec3> texelsOf(const LatticeGeometry& lattice) {
  std::vector<glm::ivec3> texels;
  for (int z = 0; z < lattice.dims.z; ++z)
    for (int y = 0; y < lattice.dims.y; ++y)
      for (int x = 0; x < lattice.dims.x; ++x) texels.emplace_back(x, y, z);
  return texels;
}

TEST(LatticeEstimator, TexelsAreLitOnTheIsosurfaceOfTheLattice) {
  const glm::vec3 middle(0.5f * (kSize - 1));
  for (const double scale : {0.5, 1.0, 2.0}) {
    const LatticeGeometry lattice = LatticeGeometry::make(glm::ivec3(kSize), scale, 0.0f);
    const LatticeEstimator estimator(ballUnderAWhiteSky(), lattice, LightPart::sky);
    const std::vector<glm::ivec3> texels = texelsOf(lattice);
    std::vector<TexelPoint> points(texels.size());
    estimator.points(texels, points);
    int lit = 0;
    for (std::size_t i = 0; i < texels.size(); ++i) {
      const glm::vec3 texel = lattice.voxelOf(texels[i]);
      const float height = glm::length(texel - middle) - kRadius;
      if (points[i].normal == glm::vec3(0.0f)) {
        EXPECT_GT(std::abs(height), 0.9f * lattice.reach().x) << scale;
        continue;
      }
      ++lit;
      const glm::vec3 outward = glm::normalize(points[i].voxel - middle);
      EXPECT_NEAR(glm::length(points[i].voxel - middle), kRadius, 0.06f) << "trilinear, not the ball itself";
      EXPECT_GT(glm::dot(points[i].normal, outward), 0.98f);
      EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(points[i].voxel - texel), lattice.reach() + 1.0f)));
    }
    EXPECT_GT(lit, 100) << scale;
  }
}

TEST(LatticeEstimator, WithoutAnIsovalueTexelsAreLitWhereTheyAre) {
  const LatticeGeometry lattice = LatticeGeometry::make(glm::ivec3(kSize), 1.0);
  const LatticeEstimator estimator(ballUnderAWhiteSky(), lattice, LightPart::sky);
  const std::vector<glm::ivec3> texels = {{4, 5, 6}, {12, 3, 9}};
  std::vector<TexelPoint> points(texels.size());
  estimator.points(texels, points);
  for (std::size_t i = 0; i < texels.size(); ++i) {
    EXPECT_EQ(points[i].voxel, glm::vec3(texels[i]));
    EXPECT_NE(points[i].normal, glm::vec3(0.0f));
  }
}

// A convex body sees the whole sky, on whichever of its isosurfaces: E = pi.
TEST(LatticeEstimator, LightIsThatOfThePlace) {
  const LatticeGeometry lattice = LatticeGeometry::make(glm::ivec3(kSize), 1.0, 0.0f);
  const LatticeEstimator estimator(ballUnderAWhiteSky(), lattice, LightPart::sky);
  const std::vector<glm::ivec3> texels = {{10, 10, 4}, {10, 16, 11}};
  std::vector<TexelPoint> points(texels.size());
  estimator.points(texels, points);
  std::vector<double> sums(texels.size() * static_cast<std::size_t>(estimator.content().components()));
  std::uint64_t rays = 0;
  ASSERT_TRUE(estimator.add(texels, points, {0, 64}, sums, rays, {}));
  for (const double sum : sums) EXPECT_NEAR(sum / 64.0, 3.14159265, 1e-4);
}

// Texels stand on voxels here: of their cells the far corners have weight 0. No spline is known beside a gap.
TEST(LatticeEstimator, TexelsBesideAMissingVoxelAreNotLit) {
  const auto volume = test::volumeOf(
      test::cube(kSize), [&](glm::dvec3 p) { return p == glm::dvec3(1.0, 1.0, -3.0) ? std::nan("") : -p.z; });
  LightScene light = test::lightSceneOf(volume);
  test::setUnitSky(light);
  const LatticeGeometry lattice = LatticeGeometry::make(glm::ivec3(kSize), 1.0);
  const LatticeEstimator estimator(std::make_shared<const LightScene>(std::move(light)), lattice,
                                   LightPart::sky);
  const std::vector<glm::ivec3> texels = {{10, 10, 6}, {10, 11, 7}, {11, 11, 6}, {11, 11, 7}, {4, 5, 6}};
  std::vector<TexelPoint> points(texels.size());
  estimator.points(texels, points);
  for (std::size_t i = 0; i < texels.size(); ++i) EXPECT_EQ(points[i].normal == glm::vec3(0.0f), i < 4) << i;
}

}  // namespace
}  // namespace isolux::gi
