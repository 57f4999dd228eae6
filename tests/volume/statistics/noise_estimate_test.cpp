#include "volume/statistics/noise_estimate.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/unwatched.h"

namespace isolux::volume {
namespace {

// The deviation at the middle of the values that it is known for.
double deviationOf(const Grid& grid) {
  const scene::NoiseModel model = estimateNoise(grid);
  return model.values.empty() ? 0.0 : model.at(0.5 * (model.values.front() + model.values.back()));
}

TEST(NoiseModel, IsLinearBetweenItsValuesAndConstantBeyond) {
  const scene::NoiseModel model{.values = {-10.0, 30.0}, .deviations = {1.0, 5.0}, .correlation = {}};
  EXPECT_EQ(model.at(-100.0), 1.0);
  EXPECT_EQ(model.at(-10.0), 1.0);
  EXPECT_DOUBLE_EQ(model.at(20.0), 4.0);
  EXPECT_EQ(model.at(31.0), 5.0);
  EXPECT_EQ(scene::NoiseModel().at(3.0), 0.0);
}

TEST(NoiseEstimate, FindsTheNoiseOfPhantoms) {
  struct Case {
    const char* name;
    int size;
    double noise;
  };
  for (const Case& c :
       {Case{"head", 96, 20.0}, Case{"head", 96, 30.0}, Case{"ball", 48, 0.2}, Case{"ball", 48, 5.0},
        Case{"gyroid", 64, 0.05}, Case{"marschner_lobb", 96, 0.05}, Case{"torus", 20, 0.3}})
    EXPECT_NEAR(deviationOf(test::phantomGrid(c.name, c.size, c.noise)), c.noise, 0.15 * c.noise)
        << c.name << ' ' << c.size;
}

// Whatever the isovalue, of skin, flesh or bone; neighbours independent, alike over two voxels, alike between
// slices.
TEST(NoiseEstimate, IsWithinATenthOnTheHeadWithConstantAir) {
  const Grid head = test::phantomGrid("head", 192);
  for (const glm::dvec3& blur : {glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(0.0, 0.0, 1.0)})
    for (const double deviation : {0.0, 2.0, 5.0, 20.0, 80.0}) {
      const scene::NoiseModel model =
          estimateNoise(test::roundedWithNoise(head, deviation, blur, 3, -1000.0));
      const double reference = std::hypot(deviation, 1.0 / std::sqrt(12.0));
      for (const double isovalue : {-300.0, 40.0, 300.0})
        EXPECT_NEAR(model.at(isovalue), reference, 0.1 * reference)
            << deviation << " HU, blur " << blur.x << ' ' << blur.z;
      if (deviation < 5.0) continue;  // below, rounding adds white noise
      for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(model.correlation[axis], blur[axis], blur[axis] > 0.0 ? 0.1 : 0.4) << axis;
    }
}

TEST(NoiseEstimate, FollowsTheValue) {
  // Two plateaus with a slope between them, with noise of 1 and of 6.
  const Grid grid = test::gridOfVoxels(test::unitGeometry({96, 64, 64}), [](glm::dvec3 p) {
    const double part = std::clamp((p.x - 40.0) / 16.0, 0.0, 1.0);
    const auto i = static_cast<std::uint64_t>(p.x + 96.0 * (p.y + 64.0 * p.z));
    return 100.0 * part + (1.0 + 5.0 * part) * base::normalNoise(5, i);
  });
  const scene::NoiseModel model = estimateNoise(grid);
  EXPECT_NEAR(model.at(0.0), 1.0, 0.1);
  EXPECT_NEAR(model.at(100.0), 6.0, 0.6);
}

TEST(NoiseEstimate, IsNotFooledByConstantAir) {
  // Two thirds of the volume are set to one value.
  const GridGeometry geometry = GridGeometry::make({60, 40, 40}, glm::dvec3(1));
  std::vector<std::int16_t> voxels(geometry.voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = i % 60 < 40 ? std::int16_t{-1000}
                            : static_cast<std::int16_t>(std::lround(30.0 * base::normalNoise(1, i)));
  EXPECT_NEAR(deviationOf(Grid(geometry, voxels)), 30.0, 3.0);
  EXPECT_NEAR(deviationOf(Grid(geometry, voxels, -0.5, 7.0)), 15.0, 1.5);
}

TEST(NoiseEstimate, IsAtLeastWhatStoringCosts) {
  const GridGeometry geometry = GridGeometry::make({16, 16, 16}, glm::dvec3(1));
  EXPECT_DOUBLE_EQ(deviationOf(Grid(geometry, std::vector<std::uint8_t>(4096, 7), 2.0)),
                   2.0 / std::sqrt(12.0));
  std::vector<float> ramp(4096);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<float>(i % 16);
  const double rounding = deviationOf(Grid(geometry, ramp));
  EXPECT_GT(rounding, 0.0);
  EXPECT_LT(rounding, 1e-6);
  const Grid missing(geometry, std::vector<float>(4096, std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(estimateNoise(missing), scene::NoiseModel());
}

TEST(NoiseEstimate, ManagesShortAxesAndMissingVoxels) {
  for (const glm::ivec3& dims : {glm::ivec3(300, 200, 1), glm::ivec3(150, 120, 3), glm::ivec3(2, 2, 2)}) {
    const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
    std::vector<float> voxels(geometry.voxelCount());
    for (std::size_t i = 0; i < voxels.size(); ++i)
      voxels[i] = i % 19 == 0 ? std::numeric_limits<float>::quiet_NaN()
                              : static_cast<float>(2.0 * base::normalNoise(3, i));
    const double noise = deviationOf(Grid(geometry, voxels));
    if (dims.x > 2) {
      EXPECT_NEAR(noise, 2.0, 0.3);
    } else {
      EXPECT_TRUE(std::isfinite(noise));
    }
  }
}

// Along none of its axes there is room for five voxels.
TEST(NoiseEstimate, ManagesVolumesThatAreShortAlongEveryAxis) {
  for (const glm::ivec3& dims : {glm::ivec3(4, 4, 4), glm::ivec3(4, 3, 4)}) {
    double mean = 0.0;
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
      const Grid grid = test::gridOfVoxels(test::unitGeometry(dims), [&](glm::dvec3 p) {
        return 2.0 * base::normalNoise(seed, static_cast<std::uint64_t>(p.x + 4.0 * (p.y + 4.0 * p.z)));
      });
      mean += deviationOf(grid) / 50.0;
    }
    EXPECT_NEAR(mean, 2.0, 1.0) << dims.y;
  }
}

}  // namespace
}  // namespace isolux::volume
