// The filter of stored irradiance: no GL.
#include "render/light/light_filter.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace isolux::render {
namespace {

constexpr std::size_t kAll = kFilterTexels * kFilterTexels * kFilterTexels;

// A field that rises along z; its isosurfaces are planes.
std::vector<FilterTexel> planes() {
  std::vector<FilterTexel> texels(kAll);
  for (std::size_t i = 0; i < kAll; ++i) {
    FilterTexel& t = texels[i];
    t.normal = {0.0f, 0.0f, 1.0f};
    t.place =
        glm::vec3(i % kFilterTexels, i / kFilterTexels % kFilterTexels, i / (kFilterTexels * kFilterTexels));
    t.isovalue = 10.0f * static_cast<float>(i / (kFilterTexels * kFilterTexels));
    t.skyPaths = t.lampsPaths = 100.0f;
    t.sky = glm::vec3(2.0f, 3.0f, 4.0f);
    t.lamps = glm::vec3(1.0f);
  }
  return texels;
}
std::size_t inPadded(int x, int y, int z) {
  return static_cast<std::size_t>(((z + 1) * kFilterTexels + y + 1) * kFilterTexels + x + 1);
}

TEST(LightFilterTest, LightOfOneValueStays) {
  for (const FilterTexel& t : filterBlock(planes())) {
    EXPECT_NEAR(t.sky.y, 3.0f, 1e-5f);
    EXPECT_NEAR(t.lamps.x, 1.0f, 1e-5f);
  }
}

// Along its surface and by symmetry, light that changes evenly, by less than its noise, stays as well.
TEST(LightFilterTest, LinearLightStays) {
  std::vector<FilterTexel> texels = planes();
  for (std::size_t i = 0; i < kAll; ++i) texels[i].sky.x = 100.0f + static_cast<float>(i % kFilterTexels);
  const std::vector<FilterTexel> result = filterBlock(texels);
  for (std::size_t i = 0; i < result.size(); ++i)
    EXPECT_NEAR(result[i].sky.x, 100.0f + static_cast<float>(i % gi::kBlockTexels + 1), 0.02f);
}

// What its noise does not explain is an edge of shadow.
TEST(LightFilterTest, EdgesOfLightStay) {
  std::vector<FilterTexel> texels = planes();
  for (FilterTexel& t : texels) t.skyPaths = t.lampsPaths = 1000.0f;
  for (std::size_t i = 0; i < kAll; ++i)
    texels[i].sky = texels[i].lamps = glm::vec3(i % kFilterTexels < 5 ? 1.0f : 3.0f);
  const std::vector<FilterTexel> result = filterBlock(texels);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const float edge = i % gi::kBlockTexels + 1 < 5 ? 1.0f : 3.0f;
    EXPECT_NEAR(result[i].sky.y, edge, 1e-3f);
    EXPECT_NEAR(result[i].lamps.y, edge, 1e-3f);
  }
}

// Where all texels are lit on one isosurface, it is their places that count.
TEST(LightFilterTest, FarPlacesCountLittle) {
  std::vector<FilterTexel> texels = planes();
  for (FilterTexel& t : texels) t.isovalue = 0.0f;
  const std::size_t other = inPadded(4, 3, 3);
  texels[other].sky = glm::vec3(2.5f, 3.0f, 4.0f);
  const std::size_t here = 3 * 64 + 3 * 8 + 3;
  const float near = filterBlock(texels)[here].sky.x - 2.0f;
  texels[other].place.x += 2.0f;
  const float far = filterBlock(texels)[here].sky.x - 2.0f;
  EXPECT_GT(near, 0.01f);
  // Weights of Gaussian exp(-d^2 / 1.28) at distances 1 and 3, but for their sum.
  EXPECT_NEAR(far / near, std::exp(-8.0f / 1.28f), 4e-4f);
}

TEST(LightFilterTest, NoiseShrinks) {
  std::vector<FilterTexel> texels = planes();
  std::mt19937 random(3);
  std::normal_distribution<float> noise(0.0f, 1.0f);
  for (FilterTexel& t : texels) t.sky.x = 2.0f + noise(random);
  double before = 0.0, after = 0.0;
  const std::vector<FilterTexel> result = filterBlock(texels);
  for (int i = 0; i < gi::kTexelsOfBlock; ++i) {
    const double a = texels[inPadded(i % 8, i / 8 % 8, i / 64)].sky.x - 2.0f;
    const double b = result[static_cast<std::size_t>(i)].sky.x - 2.0f;
    before += a * a;
    after += b * b;
  }
  EXPECT_LT(after, 0.4 * before);  // in a plane the weights' own sum of squares is about 0.26
}

// The other side of a wall and a surface at a right angle.
TEST(LightFilterTest, NothingLeaksFromOtherNormals) {
  std::vector<FilterTexel> texels = planes();
  const std::size_t wall = inPadded(4, 3, 3), corner = inPadded(2, 3, 3);
  texels[wall].normal = {0.0f, 0.0f, -1.0f};
  texels[corner].normal = {1.0f, 0.0f, 0.0f};
  for (const std::size_t i : {wall, corner}) texels[i].sky = glm::vec3(1e6f);
  EXPECT_NEAR(filterBlock(texels)[3 * 64 + 3 * 8 + 3].sky.x, 2.0f, 1e-5f);
}

// A step of the isovalue steepens the slope that it is measured by: its distance is 11 / 6 texels, of
// Gaussian exp(-(11 / 3)^2 / 2), times that of one texel's distance.
TEST(LightFilterTest, LittleLeaksFromFarIsosurfaces) {
  std::vector<FilterTexel> texels = planes();
  const std::size_t far = inPadded(3, 3, 4);
  texels[far].isovalue += 100.0f;
  texels[far].sky = glm::vec3(1e6f);
  const double weight = std::exp(-0.5 * 121.0 / 9.0 - 1.0 / 1.28);
  const float leaked = filterBlock(texels)[3 * 64 + 3 * 8 + 3].sky.x - 2.0f;
  EXPECT_GT(leaked, 0.0f);
  EXPECT_LT(leaked, 1e6 * weight);  // the others' weights sum to more than 1
}

TEST(LightFilterTest, WhatHasNoPathsHasNoWeight) {
  std::vector<FilterTexel> texels = planes();
  const std::size_t hole = inPadded(3, 3, 3);
  texels[hole].skyPaths = 0.0f;
  texels[hole].sky = glm::vec3(1e6f);
  const std::vector<FilterTexel> result = filterBlock(texels);
  EXPECT_EQ(result[3 * 64 + 3 * 8 + 3].sky.x, 1e6f);  // stays as it is: the lattice says it is not baked
  EXPECT_NEAR(result[3 * 64 + 3 * 8 + 4].sky.x, 2.0f, 1e-4f);
}

}  // namespace
}  // namespace isolux::render
