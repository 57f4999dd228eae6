#include "volume/clip/clip_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

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

// The only segment of a region without removed boxes; an empty one where none is kept.
ClipRegion::Segment segmentOf(const ClipRegion& region, glm::dvec3 origin, glm::dvec3 direction) {
  const ClipRegion::RaySegments all = region.segmentsOf(origin, direction);
  constexpr double never = std::numeric_limits<double>::infinity();
  return all.empty() ? ClipRegion::Segment{never, -never} : *all.begin();
}

std::vector<std::pair<double, double>> endsOf(const ClipRegion& region, glm::dvec3 origin,
                                              glm::dvec3 direction) {
  std::vector<std::pair<double, double>> ends;
  for (const auto& [begin, end] : region.segmentsOf(origin, direction)) ends.emplace_back(begin, end);
  return ends;
}

// Boxes between pairs of corners are removed.
scene::Clip without(std::vector<glm::dvec3> corners) {
  scene::Clip clip;
  clip.removed = std::move(corners);
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
  EXPECT_TRUE(std::isinf(segmentOf(all, {0, 0, 0}, {1, 0, 0}).end));
}

TEST(ClipRegion, APlaneCutsTheSideItsNormalPointsTo) {
  const ClipRegion below{planes({{{0, 0, 5}, {0, 0, 7}}})};
  EXPECT_TRUE(below.contains({100, 100, 5}));
  EXPECT_FALSE(below.contains({0, 0, 5.001}));
  const ClipRegion::Segment down = segmentOf(below, {1, 2, 15}, {0, 0, -2});
  EXPECT_DOUBLE_EQ(down.begin, 5.0);
  EXPECT_TRUE(std::isinf(down.end));
  EXPECT_DOUBLE_EQ(segmentOf(below, {1, 2, 1}, {0, 0, 1}).end, 4.0);
  EXPECT_TRUE(segmentOf(below, {1, 2, 6}, {1, 0, 0}).empty());
  EXPECT_FALSE(segmentOf(below, {1, 2, 5}, {1, 0, 0}).empty());
}

TEST(ClipRegion, PlanesThatFaceAwayKeepTheSlabBetween) {
  const ClipRegion slab{planes({{{0, 0, 5}, {0, 0, 1}}, {{0, 0, 2}, {0, 0, -1}}})};
  const ClipRegion::Segment kept = segmentOf(slab, {0, 0, 0}, {0, 0, 1});
  EXPECT_DOUBLE_EQ(kept.begin, 2.0);
  EXPECT_DOUBLE_EQ(kept.end, 5.0);
  const ClipRegion none{planes({{{0, 0, 2}, {0, 0, 1}}, {{0, 0, 5}, {0, 0, -1}}})};
  EXPECT_TRUE(segmentOf(none, {0, 0, 0}, {0, 0, 1}).empty());
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
      const ClipRegion::Segment kept = segmentOf(box, centre, side * along[axis]);
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
    const ClipRegion::Segment segment = segmentOf(region, from, to - from);
    const double t = test::randomVector(3 * i + 2, 7).x;
    if (std::abs(t - segment.begin) < 1e-9 || std::abs(t - segment.end) < 1e-9) continue;
    EXPECT_EQ(segment.holds(t), region.contains(from + t * (to - from)));
    kept += segment.holds(t);
  }
  EXPECT_GT(kept, 40);
}

constexpr double kEndless = std::numeric_limits<double>::infinity();

TEST(ClipRegion, ARemovedBoxLeavesWhatIsBeforeAndBehindIt) {
  const ClipRegion region{without({{4, 8, 3}, {2, 5, 7}})};
  EXPECT_TRUE(region.cuts());
  EXPECT_FALSE(region.contains({3, 6, 5}));
  EXPECT_TRUE(region.contains({3, 6, 7.001}));
  using Ends = std::vector<std::pair<double, double>>;
  EXPECT_EQ(endsOf(region, {3, 6, 0}, {0, 0, 2}), (Ends{{-kEndless, 1.5}, {3.5, kEndless}}));
  EXPECT_EQ(endsOf(region, {3, 6, 5}, {1, 0, 0}), (Ends{{-kEndless, -1}, {1, kEndless}}));  // from within it
  EXPECT_EQ(endsOf(region, {3, 9, 5}, {1, 0, 0}), (Ends{{-kEndless, kEndless}}));
}

TEST(ClipRegion, ABoxWithoutThicknessRemovesNothing) {
  const ClipRegion region{without({{2, 5, 3}, {4, 8, 3}})};
  EXPECT_TRUE(region.contains({3, 6, 3}));
  for (const glm::dvec3& direction : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(1, 1, 1)})
    EXPECT_EQ(endsOf(region, {3, 6, 3}, direction).size(), 1u);
}

// Whatever the direction, and in whatever order boxes are listed: between them nothing is kept, not even for
// a ray in the face that they share.
TEST(ClipRegion, BoxesThatTouchOrOverlapHaveNothingBetween) {
  const std::vector<glm::dvec3> left{{0, 0, 0}, {1.0 / 3.0, 1, 1}}, right{{1.0 / 3.0, 0, 0}, {0.7, 1, 1}},
      over{{0.6, 0, 0}, {0.9, 1, 1}};
  const std::vector<std::vector<glm::dvec3>> orders[] = {{left, right, over}, {over, right, left}};
  GridGeometry oblique = test::unitGeometry({20, 30, 40});
  oblique.worldFromVoxel =
      glm::dmat4{{0.4, 0.1, 0, 0}, {0.2, -0.7, 0.1, 0}, {0.3, 0, 5, 0}, {-3, 40, -60, 1}};
  const glm::dmat4 voxelFromWorld = oblique.voxelFromWorld();
  for (const auto& order : orders) {
    scene::Clip clip;
    for (const auto& box : order) clip.removed.insert(clip.removed.end(), box.begin(), box.end());
    const ClipRegion region(clip), voxels = region.inVoxels(oblique);
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const glm::dvec3 from = test::randomPoint(2 * i, glm::dvec3(-3, 0.1, 0.1), glm::dvec3(-1, 0.9, 0.9)),
                       to = test::randomPoint(2 * i + 1, glm::dvec3(2, 0.1, 0.1), glm::dvec3(4, 0.9, 0.9));
      EXPECT_EQ(endsOf(region, from, to - from).size(), 2u);
      EXPECT_EQ(endsOf(region, to, from - to).size(), 2u);
      EXPECT_EQ(endsOf(voxels, glm::dvec3(voxelFromWorld * glm::dvec4(from, 1)),
                       glm::dmat3(voxelFromWorld) * (to - from))
                    .size(),
                2u);
    }
    EXPECT_FALSE(region.contains({1.0 / 3.0, 0.5, 0.5}));
    EXPECT_EQ(endsOf(region, {1.0 / 3.0, 0.5, -5}, {0, 0, 1}),
              (std::vector<std::pair<double, double>>{{-kEndless, 5}, {6, kEndless}}));
  }
}

// A ray along a face of a box is in it along its low faces, and beside it along its high ones: as contains().
TEST(ClipRegion, RaysAlongFacesFollowThePointsOnThem) {
  const ClipRegion region{without({{2, 2, 2}, {4, 4, 4}})};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {2.0, 4.0}) {
      glm::dvec3 origin(3.0), along(0.0);
      origin[axis] = side;
      along[(axis + 1) % 3] = 1.0;
      EXPECT_EQ(region.contains(origin), side == 4.0);
      EXPECT_EQ(region.segmentsOf(origin, along).hold(0.0), side == 4.0);
    }
}

// A box that ends at a plane, or at the end of the ray, leaves no point there.
TEST(ClipRegion, NothingIsLeftBehindABoxThatEndsAtAPlane) {
  scene::Clip clip = without({{-9, -9, 2}, {9, 9, 5}});
  clip.planes = {{{0, 0, 5}, {0, 0, 1}}};
  using Ends = std::vector<std::pair<double, double>>;
  EXPECT_EQ(endsOf(ClipRegion(clip), {0, 0, 0}, {0, 0, 1}), (Ends{{-kEndless, 2}}));
  EXPECT_EQ(endsOf(ClipRegion(clip), {0, 0, 9}, {0, 0, -1}), (Ends{{7, kEndless}}));
  clip.planes.clear();
  EXPECT_TRUE(ClipRegion(clip).segmentsOf({0, 0, 2}, {0, 0, 1}, {0.0, 3.0}).empty());
}

// Random boxes, planes and rays, with corners on a lattice so that many touch: a point of a ray is kept where
// contains() says so.
TEST(ClipRegion, StretchesBesideRemovedBoxesHoldThePointsThatAreKept) {
  int kept = 0, gone = 0, several = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    scene::Clip clip;
    for (std::uint64_t i = 0; i < 2 * (1 + k % scene::kRemovedBoxes); ++i)
      clip.removed.push_back(glm::round(test::randomPoint(100 * k + i, glm::dvec3(-4), glm::dvec3(4))));
    if (k % 3 == 0) clip.planes = {{test::randomPoint(k, glm::dvec3(-2), glm::dvec3(2)), {1, 0.5, -0.2}}};
    if (k % 5 == 0) clip.box = {glm::dvec3(-3.5), glm::dvec3(3, 4, 2.5)};
    const ClipRegion region(clip);
    for (std::uint64_t i = 0; i < 300; ++i) {
      const std::uint64_t n = 1000 * k + 3 * i;
      glm::dvec3 from = test::randomPoint(n, glm::dvec3(-6), glm::dvec3(6)),
                 to = test::randomPoint(n + 1, glm::dvec3(-6), glm::dvec3(6));
      if (i % 4 == 0) from.x = to.x = std::round(from.x);  // in the planes of faces
      const ClipRegion::RaySegments segments = region.segmentsOf(from, to - from);
      double before = -kEndless;
      for (const auto& [begin, end] : segments) {
        EXPECT_GE(begin, before);
        EXPECT_GE(end, begin);
        before = end;
      }
      several += segments.end() - segments.begin() > 2;
      for (std::uint64_t j = 0; j < 8; ++j) {
        const double t = 2.0 * test::randomVector(n + j, 7).x - 0.5;
        const bool near = std::any_of(segments.begin(), segments.end(), [&](const auto& one) {
          return std::abs(t - one.begin) < 1e-9 || std::abs(t - one.end) < 1e-9;
        });
        if (near) continue;
        glm::dvec3 at = from + t * (to - from);
        if (i % 4 == 0) at.x = from.x;
        EXPECT_EQ(segments.hold(t), region.contains(at)) << k << ' ' << i;
        (segments.hold(t) ? kept : gone) += 1;
      }
    }
  }
  EXPECT_GT(kept, 50000);
  EXPECT_GT(gone, 50000);
  EXPECT_GT(several, 1000);
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
    const ClipRegion::Segment own = segmentOf(voxels, from, direction);
    const ClipRegion::Segment expected =
        segmentOf(world, glm::dvec3(geometry.worldFromVoxel * glm::dvec4(from, 1)),
                  glm::dmat3(geometry.worldFromVoxel) * direction);
    EXPECT_EQ(own.empty(), expected.empty());
    if (own.empty()) continue;
    EXPECT_NEAR(own.begin, expected.begin, 1e-6 * (1.0 + std::abs(expected.begin)));
    EXPECT_NEAR(own.end, expected.end, 1e-6 * (1.0 + std::abs(expected.end)));
  }
}

TEST(ClipRegion, RemovedBoxesAreTheSameInVoxels) {
  GridGeometry geometry = test::unitGeometry({20, 30, 40});
  geometry.worldFromVoxel =
      glm::dmat4{{0.4, 0.1, 0, 0}, {0.2, -0.7, 0.1, 0}, {0.3, 0, 5, 0}, {-3, 40, -60, 1}};
  const ClipRegion world{without({{0, 20, -50}, {1e9, 1e9, 40}})}, voxels = world.inVoxels(geometry);
  int gone = 0;
  for (std::uint64_t i = 0; i < 500; ++i) {
    const glm::dvec3 voxel = test::randomPoint(i, glm::dvec3(0), glm::dvec3(20, 30, 40));
    const glm::dvec3 at(geometry.worldFromVoxel * glm::dvec4(voxel, 1));
    EXPECT_EQ(voxels.contains(voxel), world.contains(at));
    gone += !world.contains(at);
    const glm::dvec3 direction = test::randomVector(i, 5) - 0.5;
    const auto own = endsOf(voxels, voxel, direction),
               expected = endsOf(world, at, glm::dmat3(geometry.worldFromVoxel) * direction);
    ASSERT_EQ(own.size(), expected.size());
    for (std::size_t k = 0; k < own.size(); ++k) {
      if (k > 0) {
        EXPECT_NEAR(own[k].first, expected[k].first, 1e-6 * (1.0 + std::abs(expected[k].first)));
      }
      if (k + 1 < own.size()) {
        EXPECT_NEAR(own[k].second, expected[k].second, 1e-6 * (1.0 + std::abs(expected[k].second)));
      }
    }
  }
  EXPECT_GT(gone, 50);
}

TEST(ClipRegion, KeysTellRegionsApart) {
  EXPECT_EQ(ClipRegion(without({{1, 2, 3}, {4, 5, 6}})).key(),
            ClipRegion(without({{4, 5, 6}, {1, 2, 3}})).key());
  EXPECT_NE(ClipRegion(without({{1, 2, 3}, {4, 5, 6}})).key(),
            ClipRegion(without({{1, 2, 3}, {4, 5, 7}})).key());
  EXPECT_NE(ClipRegion(without({{1, 2, 3}, {4, 5, 6}})).key(), 0u);
  EXPECT_EQ(ClipRegion(turnedBox()).key(), ClipRegion(turnedBox()).key());
  scene::Clip other = turnedBox();
  other.box[0].x += 1e-6;
  EXPECT_NE(ClipRegion(other).key(), ClipRegion(turnedBox()).key());
}

}  // namespace
}  // namespace isolux::volume
