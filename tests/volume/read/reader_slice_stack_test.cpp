// The grid that parallel slices lie on.
#include <cmath>

#include <glm/geometric.hpp>

#include "tests/volume/read/reader_support.h"
#include "volume/read/dicom/slice_stack.h"

namespace isolux {
namespace {

using volume::SlicePlanes;
using volume::SliceStack;

SlicePlanes planesAt(const std::vector<double>& zs) {
  SlicePlanes planes;
  for (double z : zs) planes.positionsMm.emplace_back(1.0, 2.0, z);
  planes.spacingXMm = 0.5;
  planes.spacingYMm = 0.75;
  planes.thicknessMm = 3.0;
  return planes;
}

bool warns(const SliceStack& stack, const std::string& part) {
  for (const std::string& warning : stack.warnings)
    if (warning.find(part) != std::string::npos) return true;
  return false;
}

TEST(SliceStack, SortsByPosition) {
  const SliceStack stack = stackSlices(planesAt({4, -2, 2, 0}), "f");
  EXPECT_THAT(stack.order, testing::ElementsAre(1, 3, 2, 0));
  EXPECT_THAT(stack.warnings, testing::IsEmpty());
  EXPECT_TRUE(stack.resampled.empty());
  test::expectNear(glm::dvec3(stack.worldFromVoxel[3]), {1, 2, -2});
  test::expectNear(glm::dvec3(stack.worldFromVoxel[0]), {0.5, 0, 0});
  test::expectNear(glm::dvec3(stack.worldFromVoxel[1]), {0, 0.75, 0});
  test::expectNear(glm::dvec3(stack.worldFromVoxel[2]), {0, 0, 2});
}

TEST(SliceStack, SagittalSlicesAreSortedAlongTheirNormal) {
  SlicePlanes planes;
  planes.rowDirection = {0, 1, 0};
  planes.columnDirection = {0, 0, -1};  // normal: -x
  for (double x : {0.0, 2.0, 1.0}) planes.positionsMm.emplace_back(x, 5.0, 6.0);
  const SliceStack stack = stackSlices(planes, "f");
  EXPECT_THAT(stack.order, testing::ElementsAre(1, 2, 0));
  test::expectNear(glm::dvec3(stack.worldFromVoxel[2]), {-1, 0, 0});
}

TEST(SliceStack, OneSliceUsesTheThickness) {
  const SliceStack stack = stackSlices(planesAt({7}), "f");
  EXPECT_EQ(stack.slices(), 1u);
  test::expectNear(glm::dvec3(stack.worldFromVoxel[2]), {0, 0, 3});
}

TEST(SliceStack, GantryTiltIsKeptAsAnObliqueGrid) {
  SlicePlanes planes = planesAt({0, 1, 2, 3});
  for (auto& p : planes.positionsMm) p.y += 0.25 * p.z;
  const SliceStack stack = stackSlices(planes, "f");
  EXPECT_TRUE(warns(stack, "gantry tilt of 14.04"));
  EXPECT_TRUE(stack.resampled.empty());
  test::expectNear(glm::dvec3(stack.worldFromVoxel[2]), {0, 0.25, 1});
}

TEST(SliceStack, SmallUnevennessIsToleratedAndSaid) {
  EXPECT_THAT(stackSlices(planesAt({0, 1.001, 2, 3}), "f").warnings, testing::IsEmpty());
  const SliceStack stack = stackSlices(planesAt({0, 1.05, 2, 3}), "f");
  EXPECT_TRUE(warns(stack, "taken as even"));
  EXPECT_TRUE(stack.resampled.empty());
}

// Positions of the resampled slices must be where the plan says.
void expectPositions(const SliceStack& stack, const std::vector<double>& zs) {
  const double step = stack.worldFromVoxel[2].z;
  for (std::size_t k = 0; k < stack.resampled.size(); ++k) {
    const auto& blend = stack.resampled[k];
    ASSERT_LT(blend.first + 1, zs.size());
    const double at = (1 - blend.fraction) * zs[blend.first] + blend.fraction * zs[blend.first + 1];
    EXPECT_NEAR(at, zs[0] + step * static_cast<double>(k), 1e-9);
  }
}

TEST(SliceStack, UnevenDistancesAreResampled) {
  const std::vector<double> zs{0, 1, 2.5, 3.5, 5, 6};
  const SliceStack stack = stackSlices(planesAt(zs), "f");
  EXPECT_TRUE(warns(stack, "uneven (1 to 1.5 mm)"));
  EXPECT_EQ(stack.slices(), 7u);
  expectPositions(stack, zs);
}

TEST(SliceStack, MissingSlicesAreFilledAndSaid) {
  const std::vector<double> zs{0, 2, 4, 10, 12};
  const SliceStack stack = stackSlices(planesAt(zs), "f");
  EXPECT_TRUE(warns(stack, "missing in 1 place"));
  EXPECT_EQ(stack.slices(), 7u);
  expectPositions(stack, zs);
  EXPECT_EQ(stack.resampled[1].fraction, 0.0);  // slices that exist are not blended
}

TEST(SliceStack, RepeatsAreTimeStepsOrLeftOut) {
  const SliceStack steps = stackSlices(planesAt({0, 0, 1, 1, 2, 2}), "f");
  EXPECT_EQ(steps.timeSteps, 2u);
  EXPECT_THAT(steps.order, testing::ElementsAre(0, 2, 4, 1, 3, 5));
  const SliceStack uneven = stackSlices(planesAt({0, 1, 1, 2}), "f");
  EXPECT_EQ(uneven.timeSteps, 1u);
  EXPECT_THAT(uneven.order, testing::ElementsAre(0, 1, 3));
  EXPECT_TRUE(warns(uneven, "repeat the position"));
}

TEST(SliceStack, RefusesWhatNoGridHolds) {
  SlicePlanes beside = planesAt({0, 1, 2, 3});
  beside.positionsMm[1].x += 1.0;
  EXPECT_THROW(stackSlices(beside, "f"), base::Error);
  EXPECT_THROW(stackSlices(planesAt({0, 1, 2, 1000}), "f"), base::Error);
  EXPECT_THROW(stackSlices(planesAt({1, 1, 1}), "f"), base::Error);
  EXPECT_THROW(stackSlices(planesAt({0, std::nan(""), 1}), "f"), base::Error);
  SlicePlanes flat = planesAt({0, 1});
  flat.columnDirection = flat.rowDirection;
  EXPECT_THROW(stackSlices(flat, "f"), base::Error);
}

TEST(SliceStack, TwoBlocksOfSlicesAreToldFromMissingSlices) {
  const SliceStack blocks = stackSlices(planesAt({0, 4, 8, 12, 16, 20, 27, 34, 41}), "f");
  EXPECT_TRUE(warns(blocks, "slice distance changes from 4 to 7 mm"));
  EXPECT_FALSE(warns(blocks, "missing"));
  const SliceStack joined = stackSlices(planesAt({0, 4, 8, 12, 16, 20, 25.5, 32.5, 39.5}), "f");  // 5.5 mm
  EXPECT_TRUE(warns(joined, "slice distance changes from 4 to 7 mm"));
  const SliceStack met = stackSlices(planesAt({0, 4, 8, 12, 16, 17.08, 24.08, 31.08}), "f");  // 1.08 mm
  EXPECT_TRUE(warns(met, "slice distance changes from 4 to 7 mm"));
  EXPECT_FALSE(warns(met, "missing")) << "a narrow gap lacks no slice";
  const SliceStack holes = stackSlices(planesAt({0, 4, 8, 16, 20, 24, 32, 36}), "f");
  EXPECT_TRUE(warns(holes, "missing in 2 places"));
}

}  // namespace
}  // namespace isolux
