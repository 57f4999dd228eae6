#include "volume/statistics/interpolated_slices.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

namespace isolux::volume {
namespace {

// What a scanner's slices `distance` voxels apart along an axis become when they are interpolated linearly.
Grid betweenSlices(const Grid& grid, int axis, double distance) {
  const int last = static_cast<int>(std::floor((grid.dims()[axis] - 1) / distance));
  return test::gridOfVoxels(grid.geometry(), [&](glm::dvec3 p) {
    const double slice = p[axis] / distance;
    const int before = std::min(static_cast<int>(slice), last - 1);
    const auto valueAt = [&](int of) {
      glm::ivec3 voxel(p);
      voxel[axis] = static_cast<int>(std::lround(of * distance));
      return grid.value(voxel.x, voxel.y, voxel.z);
    };
    return std::lerp(valueAt(before), valueAt(before + 1), slice - before);
  });
}

glm::dvec3 slicesOf(const Grid& grid) {
  base::Progress progress;
  return interpolatedSlices(grid, progress);
}

TEST(InterpolatedSlices, AreFoundAlongTheirAxis) {
  for (const double noise : {0.0, 20.0}) {
    const Grid head = test::withNoise(test::phantomGrid("head", 96), noise, glm::dvec3(0.0), 4);
    for (int axis = 0; axis < 3; ++axis)
      for (const double distance : {2.0, 2.5, 3.0, 4.0}) {
        glm::dvec3 expected(0.0);
        expected[axis] = distance;
        const glm::dvec3 distances = slicesOf(betweenSlices(head, axis, distance));
        for (int other = 0; other < 3; ++other)
          EXPECT_NEAR(distances[other], expected[other], 0.02)
              << axis << ' ' << distance << ' ' << other << ", noise " << noise;
      }
  }
}

TEST(InterpolatedSlices, AreNoneWhereEachWasMeasured) {
  for (const char* name : {"ball", "torus", "head"})
    for (const double noise : {0.0, 0.5})
      for (const glm::dvec3& blur : {glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0)}) {
        const Grid grid = test::phantomGrid(name, 96);
        const double deviation = noise * (name == std::string("head") ? 40.0 : 1.0);
        EXPECT_EQ(slicesOf(test::withNoise(grid, deviation, blur, 2)), glm::dvec3(0.0))
            << name << ' ' << noise;
      }
}

// Too few slices, missing voxels, and nothing at all.
TEST(InterpolatedSlices, AreNoneWhereNothingCanBeFound) {
  EXPECT_EQ(slicesOf(test::phantomGrid("ball", 16)), glm::dvec3(0.0));
  EXPECT_EQ(slicesOf(test::phantomGrid("ball", glm::ivec3(1, 64, 64))), glm::dvec3(0.0));
  const GridGeometry geometry = test::unitGeometry(glm::ivec3(48));
  EXPECT_EQ(slicesOf(test::gridOfVoxels(geometry, [](glm::dvec3) { return 3.0; })), glm::dvec3(0.0));
  EXPECT_EQ(slicesOf(test::gridOfVoxels(geometry, [](glm::dvec3) { return std::nan(""); })), glm::dvec3(0.0));
}

// By its definition: n for a wave of that frequency sampled at n points over whole periods, half of it for
// one of a sine's two parts; 1 on average for what does not depend on the positions.
TEST(InterpolatedSlices, PowerIsThatOfAWave) {
  constexpr std::size_t n = 1000;
  std::vector<double> wave, noise, positions;
  for (std::size_t i = 0; i < n; ++i) {
    positions.push_back(static_cast<double>(i));
    wave.push_back(std::sin(2.0 * 3.14159265358979 * 0.4 * static_cast<double>(i) + 0.3));
  }
  EXPECT_NEAR(powerAt(wave, positions, 0.4), 0.5 * n, 1e-6 * n);
  EXPECT_LT(powerAt(wave, positions, 0.2), 1e-6);
  double mean = 0.0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    noise.clear();
    for (std::size_t i = 0; i < n; ++i) noise.push_back(base::normalNoise(seed, i));
    mean += powerAt(noise, positions, 0.37) / 400.0;
  }
  EXPECT_NEAR(mean, 1.0, 0.2);
}

}  // namespace
}  // namespace isolux::volume
