#include "volume/pieces/body.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/volumes.h"
#include "volume/pieces/piece_sets.h"
#include "volume/pieces/shown_pieces.h"

namespace isolux::volume {
namespace {

constexpr double kAir = -1000.0, kSkinValue = 50.0, kBoneValue = 900.0, kSkin = -200.0, kBone = 300.0;

// What is at a world point, mm: the first part that holds it.
struct Part {
  std::function<bool(glm::dvec3)> holds;
  double value;
};

Part ball(glm::dvec3 centre, double radius, double value) {
  return {[=](glm::dvec3 p) { return glm::length(p - centre) <= radius; }, value};
}
Part box(glm::dvec3 low, glm::dvec3 high, double value) {
  return {[=](glm::dvec3 p) {
            return glm::all(glm::greaterThanEqual(p, low)) && glm::all(glm::lessThanEqual(p, high));
          },
          value};
}
// Along z.
Part cylinder(glm::dvec2 centre, double radius, double value) {
  return {[=](glm::dvec3 p) { return glm::length(glm::dvec2(p) - centre) <= radius; }, value};
}

std::shared_ptr<const PreparedVolume> scan(const std::vector<Part>& parts, glm::ivec3 dims = {120, 120, 80},
                                           glm::dvec3 spacing = {1.5, 1.5, 2.0}) {
  return test::prepared(test::gridOfWorld(GridGeometry::make(dims, spacing), [&](glm::dvec3 p) {
    for (const Part& part : parts)
      if (part.holds(p)) return part.value;
    return kAir;
  }));
}

// Whether what holds each point is shown at the bone's isovalue.
std::vector<bool> shownAt(const PreparedVolume& volume, const std::vector<glm::dvec3>& pointsMm,
                          const scene::Pieces& choice, double isovalue = kBone) {
  base::Progress progress;
  const auto pieces = volume.pieces->at(isovalue, scene::Inside::above, progress);
  const std::vector<bool> shown = volume.pieces->shown(*pieces, choice, progress);
  const auto hidden = volume.pieces->hidden(choice, isovalue, scene::Inside::above, progress);
  std::vector<bool> result;
  for (const glm::dvec3& p : pointsMm) {
    const glm::dvec3 voxel(volume.grid().geometry().voxelFromWorld() * glm::dvec4(p, 1.0));
    const std::uint32_t piece = pieces->ofVoxel(glm::ivec3(glm::round(voxel)));
    if (piece == Pieces::kNone) {
      ADD_FAILURE() << "no bone at " << p.x << " " << p.y << " " << p.z;
      return {};
    }
    result.push_back(shown[piece]);
    EXPECT_EQ(shown[piece], !hidden || !hidden->at(glm::ivec3(glm::round(voxel))));
  }
  return result;
}

scene::Pieces within(double isovalue, double depth = 0.0) {
  scene::Pieces choice;
  choice.within = isovalue;
  choice.depth = depth;
  return choice;
}

using Shown = std::vector<bool>;

// A head of 50 mm radius with a skull, a tooth, a splinter in an open cavity, a headrest that touches it and
// a table that does not.
constexpr glm::dvec3 kHead{90, 80, 80}, kTooth{90, 128, 80}, kSplinter{90, 118, 84}, kRest{144.5, 80, 80},
    kTable{60, 10, 80};
std::vector<Part> headOnItsRest() {
  return {ball(kTooth, 4, kBoneValue),
          ball(kSplinter, 2.5, kBoneValue),
          {[](glm::dvec3 p) { return std::abs(p.z - 84) < 8 && std::abs(p.x - 90) < 6 && p.y > 108; }, kAir},
          ball(kHead, 35, kBoneValue),
          ball(kHead, 50, kSkinValue),
          box({142, 40, 30}, {146, 120, 140}, kBoneValue),      // plastic
          box({139.6, 40, 30}, {147.4, 120, 140}, kSkinValue),  // in its cover, on the skin
          box({20, 8, 0}, {160, 12, 160}, kBoneValue)};
}

TEST(Body, WhatLiesBesideThePatientIsHiddenAndNothingWithin) {
  const auto volume = scan(headOnItsRest());
  const std::vector<glm::dvec3> all{kHead, kTooth, kSplinter, kRest, kTable};
  EXPECT_EQ(shownAt(*volume, all, {}), (Shown{true, true, true, true, true}));
  EXPECT_EQ(shownAt(*volume, all, within(kSkin)), (Shown{true, true, true, false, false}));
  // Together with the others.
  scene::Pieces large = within(kSkin);
  large.smallest = 150.0;
  EXPECT_EQ(shownAt(*volume, all, large), (Shown{true, true, false, false, false}));
}

TEST(Body, BothLegsAndAnArmAreThePatient) {
  const glm::dvec2 left(50, 90), right(130, 90), arm(90, 150);
  const auto volume =
      scan({cylinder(left, 12, kBoneValue), cylinder(right, 12, kBoneValue), cylinder(arm, 5, kBoneValue),
            cylinder(left, 36, kSkinValue), cylinder(right, 34, kSkinValue), cylinder(arm, 14, kSkinValue),
            box({0, 8, 0}, {180, 12, 160}, kBoneValue)});
  EXPECT_EQ(shownAt(*volume, {{left, 80}, {right, 80}, {arm, 80}, kTable}, within(kSkin)),
            (Shown{true, true, true, false}));
}

TEST(Body, HidesNothingWhereNothingIsOutside) {
  const auto volume = scan(headOnItsRest());
  const std::vector<glm::dvec3> all{kHead, kTooth, kSplinter, kRest, kTable};
  EXPECT_EQ(shownAt(*volume, all, within(-2000.0)), (Shown{true, true, true, true, true}));
  EXPECT_EQ(shownAt(*volume, all, within(5000.0)), (Shown{false, false, false, false, false}));
}

// Scalp and brain of one value, with a skull between them that is as dark as air.
TEST(Body, DepthTellsWhatIsBelowTheSurface) {
  const auto volume = scan({ball(kHead, 30, kBoneValue), ball(kHead, 42, kAir), ball(kHead, 48, kBoneValue),
                            ball(kHead, 50, kSkinValue)});
  const glm::dvec3 scalp = kHead + glm::dvec3(45, 0, 0);
  EXPECT_EQ(shownAt(*volume, {kHead, scalp}, within(kSkin)), (Shown{true, true}));
  EXPECT_EQ(shownAt(*volume, {kHead, scalp}, within(kSkin, 0.2)), (Shown{true, false}));
  EXPECT_EQ(shownAt(*volume, {kHead, scalp}, within(kSkin, 0.9)), (Shown{false, false}));
}

// Against a search among all voxels: nodes are voxels here, and the body is thick.
TEST(Body, DepthIsTheDistanceToWhatIsOutside) {
  const glm::dvec3 spacing(1.0, 1.25, 2.0);
  const glm::ivec3 dims(20, 18, 12);
  const GridGeometry geometry = GridGeometry::make(dims, spacing);
  const auto solid = [](glm::dvec3 p) {
    return glm::length((p - glm::dvec3(9.5, 11, 12)) / glm::dvec3(8, 9, 10)) <= 1.0;
  };
  const Grid grid = test::gridOfWorld(geometry, [&](glm::dvec3 p) { return solid(p) ? 1.0 : 0.0; });
  base::Progress progress;
  const Body body(grid, 0.5, progress);
  std::vector<double> expected;
  const auto everyVoxel = [&](const auto& visit) {
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) visit(glm::ivec3(x, y, z));
  };
  const auto at = [&](glm::ivec3 v) { return glm::dvec3(v) * spacing; };
  everyVoxel([&](glm::ivec3 v) {
    double nearest = 1e9;
    if (solid(at(v)))
      everyVoxel([&](glm::ivec3 other) {
        if (!solid(at(other))) nearest = std::min(nearest, glm::length(at(v) - at(other)));
      });
    expected.push_back(solid(at(v)) ? nearest : 0.0);
  });
  const double deepest = *std::max_element(expected.begin(), expected.end());
  std::size_t i = 0, rim = 0, solids = 0;
  everyVoxel([&](glm::ivec3 v) {
    const double found = static_cast<double>(body.depth(v)), right = expected[i++] / deepest;
    solids += right > 0.0;
    // Where no ball fits into the corners of voxels it is no body.
    if (found == 0.0 && right > 0.0 && right < 0.2)
      ++rim;
    else
      EXPECT_NEAR(found, right, 1e-6) << v.x << " " << v.y << " " << v.z;
  });
  EXPECT_LT(rim, solids / 10);
}

TEST(Body, IsMadeOnceForAnIsovalue) {
  const auto volume = scan(headOnItsRest());
  base::Progress progress;
  EXPECT_FALSE(volume->pieces->knowsBody(within(kSkin)));
  const auto body = volume->pieces->body(kSkin, progress);
  EXPECT_TRUE(volume->pieces->knowsBody(within(kSkin)));
  EXPECT_EQ(volume->pieces->body(kSkin, progress), body);
  progress.requestStop();
  EXPECT_THROW(volume->pieces->body(0.0, progress), base::Error);
}

}  // namespace
}  // namespace isolux::volume
