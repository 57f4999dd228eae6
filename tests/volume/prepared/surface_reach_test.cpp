#include "volume/prepared/surface_reach.h"
#include "tests/support/surfaces.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "scene/rules/automatic.h"

namespace isolux::volume {
namespace {

// Two balls on an oblique, anisotropic, left-handed grid: value = radius less distance, mm.
struct TwoBalls {
  static constexpr double largeRadius = 14.0, smallRadius = 5.0;
  glm::dvec3 large{3, -8, 40}, small{0};
  std::shared_ptr<const PreparedVolume> volume;

  TwoBalls() {
    const glm::dvec3 a = glm::normalize(glm::dvec3(1, 0.2, 0.1));
    const glm::dvec3 b = glm::normalize(glm::cross(a, glm::dvec3(0, 0.3, 1)));
    const glm::dmat3 directions(a, b, -glm::cross(a, b));
    const GridGeometry geometry =
        GridGeometry::make({70, 60, 40}, {0.8, 1.0, 1.6}, {-30, -40, 30}, directions);
    const glm::dvec3 middle(geometry.worldFromVoxel * glm::dvec4(30, 25, 20, 1));
    large = middle - a * 5.0;
    small = middle + a * 22.0;
    std::vector<float> values(geometry.voxelCount());
    std::size_t i = 0;
    for (int z = 0; z < 40; ++z)
      for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 70; ++x) {
          const glm::dvec3 p(geometry.worldFromVoxel * glm::dvec4(x, y, z, 1));
          values[i++] = static_cast<float>(
              std::max(largeRadius - glm::length(p - large), smallRadius - glm::length(p - small)));
        }
    Volume made;
    made.grid = std::make_shared<Grid>(geometry, std::move(values));
    base::Progress progress;
    volume = prepareVolume(std::move(made), progress);
  }

  scene::Scene scene() const {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    return scene::resolve(scene, volume->facts);
  }
};

const std::vector<glm::dvec3> directions{{1, 0, 0}, {-0.3, 0.5, -2}, {0, 0, 1}, {0.1, -1, 0}};

TEST(SurfaceReach, IsThatOfTheBallsByTheFormula) {
  const TwoBalls balls;
  base::Progress progress;
  const auto reach = surfaceReach(*balls.volume, balls.scene(), directions, progress);
  ASSERT_TRUE(reach);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const glm::dvec3 d = directions[i];
    const double length = glm::length(d);
    const double expected = std::max(glm::dot(d, balls.large) + TwoBalls::largeRadius * length,
                                     glm::dot(d, balls.small) + TwoBalls::smallRadius * length);
    // Crossings lie on edges of cells: beside the farthest point by less than a cell, which on a ball is
    // little along the direction.
    EXPECT_NEAR((*reach)[i], expected, 0.12 * length) << i;
  }
}

TEST(SurfaceReach, WhatIsCutAwayDoesNotCount) {
  const TwoBalls balls;
  base::Progress progress;
  scene::Scene scene = balls.scene();
  const glm::dvec3 across = glm::normalize(balls.small - balls.large);
  scene.clip.planes = {{balls.large, across}};  // half of the large ball is left
  const std::vector<glm::dvec3> along{across, -across};
  const auto reach = surfaceReach(*balls.volume, scene, along, progress);
  ASSERT_TRUE(reach);
  EXPECT_LE((*reach)[0], glm::dot(across, balls.large) + 1e-9);
  EXPECT_NEAR((*reach)[0], glm::dot(across, balls.large), 1.0);
  EXPECT_NEAR((*reach)[1], TwoBalls::largeRadius - glm::dot(across, balls.large), 0.15);
  scene.surfaces.front().clipped = false;
  EXPECT_NEAR((*surfaceReach(*balls.volume, scene, along, progress))[0],
              glm::dot(across, balls.small) + TwoBalls::smallRadius, 0.15);
}

TEST(SurfaceReach, HiddenPiecesDoNotCount) {
  const TwoBalls balls;
  base::Progress progress;
  scene::Scene scene = balls.scene();
  scene.pieces.keep = 1;
  const auto ball = surfaceBall(*balls.volume, scene, progress);
  ASSERT_TRUE(ball);
  EXPECT_LE(glm::length(ball->centreMm - balls.large), 0.2);
  EXPECT_NEAR(ball->radiusMm, TwoBalls::largeRadius, 0.2);
  scene.pieces = {};
  scene.pieces.hidden = {balls.large};
  const auto other = surfaceBall(*balls.volume, scene, progress);
  ASSERT_TRUE(other);
  EXPECT_LE(glm::length(other->centreMm - balls.small), 0.2);
}

TEST(SurfaceReach, OnlyWhatIsShownCounts) {
  const TwoBalls balls;
  base::Progress progress;
  scene::Scene scene = balls.scene();
  scene.surfaces.front().value = 1000.0;
  EXPECT_FALSE(surfaceReach(*balls.volume, scene, directions, progress)) << "no surface";
  EXPECT_FALSE(surfaceBall(*balls.volume, scene, progress));
  scene.surfaces.front().value = 0.0;
  scene.surfaces.front().opacity = 0.0;
  EXPECT_FALSE(surfaceBall(*balls.volume, scene, progress));
  test::surfaceAt(scene, 1).shown = true;
  test::surfaceAt(scene, 1).value = 6.0;  // only the large ball has a surface there, of radius 8
  const auto ball = surfaceBall(*balls.volume, scene, progress);
  ASSERT_TRUE(ball);
  EXPECT_NEAR(ball->radiusMm, TwoBalls::largeRadius - 6.0, 0.2);
}

TEST(SurfaceReach, StopsWhenAsked) {
  const TwoBalls balls;
  base::Progress progress;
  progress.requestStop();
  EXPECT_THROW(surfaceReach(*balls.volume, balls.scene(), directions, progress), base::Error);
}

}  // namespace
}  // namespace isolux::volume
