#include "volume/statistics/noise_estimate.h"
#include "tests/support/volumes.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "base/random.h"
#include "volume/prepared_volume.h"

namespace isolux::volume {
namespace {

TEST(NoiseEstimate, FindsTheNoiseOfPhantoms) {
  struct Case {
    const char* name;
    int size;
    double noise;
  };
  for (const Case& c :
       {Case{"head", 96, 20.0}, Case{"head", 96, 30.0}, Case{"ball", 48, 0.2}, Case{"ball", 48, 5.0},
        Case{"gyroid", 64, 0.05}, Case{"marschner_lobb", 96, 0.05}, Case{"torus", 20, 0.3}})
    EXPECT_NEAR(estimateNoise(test::phantomGrid(c.name, c.size, c.noise)), c.noise, 0.15 * c.noise)
        << c.name << ' ' << c.size;
}

TEST(NoiseEstimate, IsNotFooledByConstantAir) {
  // Two thirds of the volume are set to one value.
  const GridGeometry geometry = GridGeometry::make({60, 40, 40}, glm::dvec3(1));
  std::vector<std::int16_t> voxels(geometry.voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = i % 60 < 40 ? std::int16_t{-1000}
                            : static_cast<std::int16_t>(std::lround(30.0 * base::normalNoise(1, i)));
  EXPECT_NEAR(estimateNoise(Grid(geometry, voxels)), 30.0, 4.5);
  EXPECT_NEAR(estimateNoise(Grid(geometry, voxels, -0.5, 7.0)), 15.0, 2.25);
}

TEST(NoiseEstimate, IsAtLeastWhatStoringCosts) {
  const GridGeometry geometry = GridGeometry::make({16, 16, 16}, glm::dvec3(1));
  EXPECT_DOUBLE_EQ(estimateNoise(Grid(geometry, std::vector<std::uint8_t>(4096, 7), 2.0)),
                   2.0 / std::sqrt(12.0));
  std::vector<float> ramp(4096);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = static_cast<float>(i % 16);
  const double rounding = estimateNoise(Grid(geometry, ramp));
  EXPECT_GT(rounding, 0.0);
  EXPECT_LT(rounding, 1e-6);
  const Grid missing(geometry, std::vector<float>(4096, std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(estimateNoise(missing), 0.0);
}

TEST(NoiseEstimate, ManagesShortAxesAndMissingVoxels) {
  for (const glm::ivec3& dims : {glm::ivec3(300, 200, 1), glm::ivec3(150, 120, 3), glm::ivec3(2, 2, 2)}) {
    const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
    std::vector<float> voxels(geometry.voxelCount());
    for (std::size_t i = 0; i < voxels.size(); ++i)
      voxels[i] = i % 19 == 0 ? std::numeric_limits<float>::quiet_NaN()
                              : static_cast<float>(2.0 * base::normalNoise(3, i));
    const double noise = estimateNoise(Grid(geometry, voxels));
    if (dims.x > 2) {
      EXPECT_NEAR(noise, 2.0, 0.3);
    } else {
      EXPECT_TRUE(std::isfinite(noise));
    }
  }
}

TEST(NoiseEstimate, IsAFactOfThePreparedVolume) {
  base::Progress progress;
  Volume volume;
  volume.grid = std::make_shared<const Grid>(test::phantomGrid("ball", 32, 0.5));
  const double expected = estimateNoise(*volume.grid);
  EXPECT_EQ(prepareVolume(std::move(volume), progress)->facts.noise, expected);
  EXPECT_GT(expected, 0.0);
}

}  // namespace
}  // namespace isolux::volume
