#include "volume/clip/clip_region.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/rays.h"
#include "tests/support/volumes.h"

namespace isolux::volume {
namespace {

scene::Clip planes(std::vector<scene::ClipPlane> list) {
  scene::Clip clip;
  clip.planes = std::move(list);
  return clip;
}

// A box of half lengths 10, 20, 5 about (1, 2, 3), turned by 30 degrees about z.
scene::Clip turnedBox() {
  scene::Clip clip;
  clip.box = {{11, -18, 8}, {-9, 22, -2}};
  const double half = std::numbers::pi / 12.0;
  clip.boxRotation = {2.0 * std::cos(half), 0, 0, 2.0 * std::sin(half)};
  return clip;
}

TEST(ClipRegion, NothingKeepsEverything) {
  const ClipRegion all{scene::Clip{}};
  EXPECT_FALSE(all.cuts());
  EXPECT_EQ(all.key(), 0u);
  EXPECT_TRUE(all.contains({1e9, -1e9, 0}));
  EXPECT_TRUE(std::isinf(all.stretchOf({0, 0, 0}, {1, 0, 0}).end));
}

TEST(ClipRegion, APlaneCutsTheSideItsNormalPointsTo) {
  const ClipRegion below{planes({{{0, 0, 5}, {0, 0, 7}}})};
  EXPECT_TRUE(below.contains({100, 100, 5}));
  EXPECT_FALSE(below.contains({0, 0, 5.001}));
  const ClipRegion::Stretch down = below.stretchOf({1, 2, 15}, {0, 0, -2});
  EXPECT_DOUBLE_EQ(down.begin, 5.0);
  EXPECT_TRUE(std::isinf(down.end));
  EXPECT_DOUBLE_EQ(below.stretchOf({1, 2, 1}, {0, 0, 1}).end, 4.0);
  EXPECT_TRUE(below.stretchOf({1, 2, 6}, {1, 0, 0}).empty());
  EXPECT_FALSE(below.stretchOf({1, 2, 5}, {1, 0, 0}).empty());
}

TEST(ClipRegion, PlanesThatFaceAwayKeepTheSlabBetween) {
  const ClipRegion slab{planes({{{0, 0, 5}, {0, 0, 1}}, {{0, 0, 2}, {0, 0, -1}}})};
  const ClipRegion::Stretch kept = slab.stretchOf({0, 0, 0}, {0, 0, 1});
  EXPECT_DOUBLE_EQ(kept.begin, 2.0);
  EXPECT_DOUBLE_EQ(kept.end, 5.0);
  const ClipRegion none{planes({{{0, 0, 2}, {0, 0, 1}}, {{0, 0, 5}, {0, 0, -1}}})};
  EXPECT_TRUE(none.stretchOf({0, 0, 0}, {0, 0, 1}).empty());
}

TEST(ClipRegion, ABoxIsTurnedAboutItsCentre) {
  const ClipRegion box{turnedBox()};
  EXPECT_EQ(box.faces().size(), 6u);
  const glm::dvec3 centre(1, 2, 3);
  const double c = std::sqrt(0.75), s = 0.5;
  const glm::dvec3 along[3] = {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
  const double half[3] = {10, 20, 5};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      EXPECT_TRUE(box.contains(centre + side * (half[axis] - 1e-9) * along[axis]));
      EXPECT_FALSE(box.contains(centre + side * (half[axis] + 1e-9) * along[axis]));
      const ClipRegion::Stretch kept = box.stretchOf(centre, side * along[axis]);
      EXPECT_NEAR(kept.end, half[axis], 1e-12);
      EXPECT_NEAR(kept.begin, -half[axis], 1e-12);
    }
}

// Stretches say what contains() says along random rays.
TEST(ClipRegion, StretchesHoldThePointsThatAreKept) {
  scene::Clip clip = turnedBox();
  clip.planes = {{{2, 3, 3}, {1, 1, 0.3}}, {{0, 0, 0}, {-0.2, 0.1, -1}}};
  const ClipRegion region(clip);
  int kept = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const glm::dvec3 from = test::randomPoint(3 * i, glm::dvec3(-40), glm::dvec3(40)),
                     to = test::randomPoint(3 * i + 1, glm::dvec3(-40), glm::dvec3(40));
    const ClipRegion::Stretch stretch = region.stretchOf(from, to - from);
    const double t = test::randomVector(3 * i + 2, 7).x;
    if (std::abs(t - stretch.begin) < 1e-9 || std::abs(t - stretch.end) < 1e-9) continue;
    EXPECT_EQ(stretch.holds(t), region.contains(from + t * (to - from)));
    kept += stretch.holds(t);
  }
  EXPECT_GT(kept, 40);
}

// In voxels of an oblique, anisotropic, left-handed grid the same points are kept, at the same t.
TEST(ClipRegion, IsTheSameInVoxels) {
  GridGeometry geometry = test::unitGeometry({20, 30, 40});
  geometry.worldFromVoxel =
      glm::dmat4{{0.4, 0.1, 0, 0}, {0.2, -0.7, 0.1, 0}, {0.3, 0, 5, 0}, {-3, 40, -60, 1}};
  const ClipRegion world(turnedBox()), voxels = world.inVoxels(geometry);
  for (std::uint64_t i = 0; i < 500; ++i) {
    const glm::dvec3 from = test::randomPoint(i, glm::dvec3(0), glm::dvec3(20, 30, 40));
    const glm::dvec3 direction = test::randomVector(i, 5) - 0.5;
    const ClipRegion::Stretch own = voxels.stretchOf(from, direction);
    const ClipRegion::Stretch expected =
        world.stretchOf(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(from, 1)),
                        glm::dmat3(geometry.worldFromVoxel) * direction);
    EXPECT_NEAR(own.begin, expected.begin, 1e-6 * (1.0 + std::abs(expected.begin)));
    EXPECT_NEAR(own.end, expected.end, 1e-6 * (1.0 + std::abs(expected.end)));
  }
}

TEST(ClipRegion, KeysTellRegionsApart) {
  EXPECT_EQ(ClipRegion(turnedBox()).key(), ClipRegion(turnedBox()).key());
  scene::Clip other = turnedBox();
  other.box[0].x += 1e-6;
  EXPECT_NE(ClipRegion(other).key(), ClipRegion(turnedBox()).key());
}

}  // namespace
}  // namespace isolux::volume
