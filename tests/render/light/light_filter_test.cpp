// The filter of stored irradiance: no GL.
#include "render/light/light_filter.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

namespace isolux::render {
namespace {

constexpr std::size_t kAll = kFilterTexels * kFilterTexels * kFilterTexels;

std::vector<FilterTexel> filterBlock(const std::vector<FilterTexel>& texels) {
  return render::filterBlock(texels, glm::ivec3(0));
}

// A field that rises along z; its isosurfaces are planes.
std::vector<FilterTexel> planes() {
  std::vector<FilterTexel> texels(kAll);
  for (std::size_t i = 0; i < kAll; ++i) {
    FilterTexel& t = texels[i];
    t.normal = {0.0f, 0.0f, 1.0f};
    t.place =
        glm::vec3(i % kFilterTexels, i / kFilterTexels % kFilterTexels, i / (kFilterTexels * kFilterTexels));
    t.isovalue = 10.0f * static_cast<float>(i / (kFilterTexels * kFilterTexels));
    t.shape = {10.0f, 0.0f};
    t.skyPaths = t.lampsPaths = 100.0f;
    t.sky = glm::vec3(2.0f, 3.0f, 4.0f);
    t.lamps = glm::vec3(1.0f);
  }
  return texels;
}
std::size_t inPadded(int x, int y, int z) {
  constexpr int b = kFilterBorder;
  return static_cast<std::size_t>(((z + b) * kFilterTexels + y + b) * kFilterTexels + x + b);
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
    EXPECT_NEAR(result[i].sky.x, 100.0f + static_cast<float>(i % gi::kBlockTexels + kFilterBorder), 0.02f);
}

// What its noise does not explain is an edge of shadow.
TEST(LightFilterTest, EdgesOfLightStay) {
  std::vector<FilterTexel> texels = planes();
  for (FilterTexel& t : texels) t.skyPaths = t.lampsPaths = 1000.0f;
  for (std::size_t i = 0; i < kAll; ++i)
    texels[i].sky = texels[i].lamps = glm::vec3(i % kFilterTexels < 6 ? 1.0f : 3.0f);
  const std::vector<FilterTexel> result = filterBlock(texels);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const float edge = i % gi::kBlockTexels + kFilterBorder < 6 ? 1.0f : 3.0f;
    EXPECT_NEAR(result[i].sky.y, edge, 1e-3f);
    EXPECT_NEAR(result[i].lamps.y, edge, 1e-3f);
  }
}

// Where all texels are lit on one isosurface, it is their places that count.
TEST(LightFilterTest, FarPlacesCountLittle) {
  std::vector<FilterTexel> texels = planes();
  for (FilterTexel& t : texels) {
    t.isovalue = 0.0f;
    t.skyPaths = 1e-3f;  // so that the difference is noise
  }
  const std::size_t other = inPadded(4, 3, 3);
  texels[other].sky = glm::vec3(2.5f, 3.0f, 4.0f);
  const std::size_t here = 3 * 64 + 3 * 8 + 3;
  const float near = filterBlock(texels)[here].sky.x - 2.0f;
  texels[other].place.x += 2.0f;
  const float far = filterBlock(texels)[here].sky.x - 2.0f;
  EXPECT_GT(near, 0.01f);
  // Weights of Gaussian exp(-d^2 / (2 * 1.6^2)) at distances 1 and 3; their sum has changed by less than a
  // tenth.
  EXPECT_NEAR(far / near, std::exp(-8.0f / 5.12f), 0.1f * far / near);
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

// Light in a gap: it falls as the square of the depth to a kink, along a plane that lies askew in the
// lattice, with the noise of 100 paths. Lookups between texels, as light_lattice.glsl makes them, are nearer
// to the formula than without the filter by more than noise alone would explain.
class GapTest : public ::testing::Test {
 protected:
  static constexpr float kNoise = 0.08f;
  static glm::vec3 normal() { return glm::normalize(glm::vec3(0.2f, 0.9f, -0.4f)); }
  static float lightAt(glm::vec3 place) {
    const float depth =
        glm::dot(place - glm::vec3(5.3f), glm::normalize(glm::cross(normal(), glm::vec3(1.0f, 0.0f, 0.0f))));
    return 0.2f + 0.3f * std::max(0.0f, depth) * std::max(0.0f, depth);
  }
  static float distanceTo(glm::vec3 place) { return glm::dot(place - glm::vec3(5.6f), normal()); }

  static std::vector<FilterTexel> texels(float noisePart) {
    std::mt19937 random(11);
    std::normal_distribution<float> noise(0.0f, noisePart);
    std::vector<FilterTexel> result(kAll);
    for (std::size_t i = 0; i < kAll; ++i) {
      const glm::vec3 at(i % kFilterTexels, i / kFilterTexels % kFilterTexels,
                         i / (kFilterTexels * kFilterTexels));
      if (std::abs(distanceTo(at)) > 0.95f) continue;
      FilterTexel& t = result[i];
      t.normal = normal();
      t.place = at - distanceTo(at) * normal();
      t.shape = {1.0f, 0.0f};
      t.skyPaths = 100.0f;
      t.sky = glm::vec3(lightAt(t.place) * (1.0f + noise(random)));
    }
    return result;
  }
  // RMS error of lookups over the part of the plane whose eight texels are there, of light that texels give.
  template <class LightOf>
  static double errorOf(const std::vector<FilterTexel>& texels, const LightOf& lightOf) {
    std::mt19937 random(17);
    std::uniform_real_distribution<float> any(0.0f, 7.0f);
    double squares = 0.0;
    int count = 0;
    for (int tried = 0; tried < 4000; ++tried) {
      glm::vec3 place(any(random), any(random), any(random));
      place += static_cast<float>(kFilterBorder);
      place -= distanceTo(place) * normal();
      const glm::ivec3 base = glm::ivec3(glm::floor(place)) - kFilterBorder;
      if (glm::any(glm::lessThan(base, glm::ivec3(0))) || glm::any(glm::greaterThan(base, glm::ivec3(6))))
        continue;
      const glm::vec3 part = place - glm::floor(place);
      double sum = 0.0, whole = 0.0;
      for (int c = 0; c < 8; ++c) {
        const glm::ivec3 step(c & 1, c >> 1 & 1, c >> 2), t = base + step;
        const glm::vec3 w = glm::mix(1.0f - part, part, glm::vec3(step));
        if (texels[inPadded(t.x, t.y, t.z)].skyPaths == 0.0f) continue;
        const double weight = static_cast<double>(w.x * w.y * w.z);
        whole += weight;
        sum += weight * static_cast<double>(lightOf(t));
      }
      if (whole < 0.5) continue;
      const double error = sum / whole - static_cast<double>(lightAt(place));
      squares += error * error;
      ++count;
    }
    EXPECT_GT(count, 500);
    return std::sqrt(squares / count);
  }
  // Unfiltered, filtered.
  static std::pair<double, double> errors(float noisePart) {
    const std::vector<FilterTexel> all = texels(noisePart), block = filterBlock(all);
    return {errorOf(all, [&](glm::ivec3 t) { return all[inPadded(t.x, t.y, t.z)].sky.y; }),
            errorOf(all, [&](glm::ivec3 t) {
              return block[static_cast<std::size_t>((t.z * 8 + t.y) * 8 + t.x)].sky.y;
            })};
  }
};

TEST_F(GapTest, LightThatBendsIsNotBlurred) {
  const auto [unfiltered, filtered] = errors(0.0f);
  EXPECT_LT(filtered, 0.8 * unfiltered);
}

TEST_F(GapTest, NoiseShrinksAlongTheLinesOfEqualLight) {
  const auto [unfiltered, filtered] = errors(kNoise);
  EXPECT_LT(filtered, 0.75 * unfiltered);
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

// Two texels off by its isovalue, and one in place.
TEST(LightFilterTest, LittleLeaksFromFarIsosurfaces) {
  std::vector<FilterTexel> texels = planes();
  const std::size_t far = inPadded(3, 3, 4);
  for (FilterTexel& t : texels) t.skyPaths = 1e-3f;  // so that the difference is noise
  texels[far].isovalue += 10.0f;
  texels[far].sky = glm::vec3(1e6f);
  const double weight = std::exp(-0.5 * 16.0 - 1.0 / 5.12);
  const float leaked = filterBlock(texels)[3 * 64 + 3 * 8 + 3].sky.x - 2.0f;
  EXPECT_GT(leaked, 0.0f);
  EXPECT_LT(leaked, 1e6 * weight);  // the others' weights sum to more than 1
}

// f = max(0, z - 3): what is lit at the kink, or below it, is lit on nobody's isosurface.
TEST(LightFilterTest, PlateausTakeTheLightOfTheSlope) {
  std::vector<FilterTexel> texels = planes();
  for (int z = -kFilterBorder; z <= 9; ++z)
    for (int y = -kFilterBorder; y <= 9; ++y)
      for (int x = -kFilterBorder; x <= 9; ++x) {
        const auto f = [](int at) { return 10.0f * static_cast<float>(std::max(0, at - 3)); };
        FilterTexel& t = texels[inPadded(x, y, z)];
        t.isovalue = f(z);
        t.shape = fieldShape(f(z), {f(z), f(z), f(z - 1)}, {f(z), f(z), f(z + 1)});
        if (z <= 3) t.sky = glm::vec3(1000.0f);
      }
  const std::vector<FilterTexel> result = filterBlock(texels);
  EXPECT_LT(result[3 * 64 + 3 * 8 + 3].sky.x, 350.0f);
  EXPECT_NEAR(result[4 * 64 + 3 * 8 + 3].sky.x, 2.0f, 2.0f);
  EXPECT_NEAR(result[5 * 64 + 3 * 8 + 3].sky.x, 2.0f, 1e-3f);
}

// A transfer vector of three numbers against the weights as the header tells them, in double precision.
TEST(LightFilterTest, TransferIsTheMeanThatTheHeaderTells) {
  std::vector<FilterTexel> texels = planes();
  std::mt19937 random(5);
  std::uniform_real_distribution<float> any(0.0f, 1.0f);
  std::vector<float> vectors(3 * kAll);
  for (std::size_t i = 0; i < kAll; ++i) {
    for (std::size_t c = 0; c < 3; ++c) vectors[3 * i + c] = any(random);
    texels[i].normal = glm::normalize(glm::vec3(any(random), any(random), 1.0f));
    texels[i].skyPaths = i % 7 == 0 ? 0.0f : any(random);
    texels[i].transfer = texels[i].skyPaths > 0.0f ? &vectors[3 * i] : nullptr;
  }
  const std::vector<float> transfer = filterTransfer(texels, 3);
  ASSERT_EQ(transfer.size(), 3u * gi::kTexelsOfBlock);
  for (int i = 0; i < gi::kTexelsOfBlock; ++i) {
    const int x = i % 8, y = i / 8 % 8, z = i / 64;
    const FilterTexel& own = texels[inPadded(x, y, z)];
    double whole = 0.0;
    glm::dvec3 sum(0.0);
    for (int n = 0; n < 27; ++n) {
      const glm::ivec3 step = glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
      const FilterTexel& other = texels[inPadded(x + step.x, y + step.y, z + step.z)];
      if (!other.transfer) continue;
      const double cosine = std::max(0.0, glm::dot(glm::dvec3(own.normal), glm::dvec3(other.normal)));
      const double off = 2.0 * step.z, apart = glm::dot(glm::dvec3(step), glm::dvec3(step)) / (0.8 * 0.8);
      const double weight =
          static_cast<double>(other.skyPaths) * std::pow(cosine, 16.0) * std::exp(-0.5 * (apart + off * off));
      whole += weight;
      sum += weight * glm::dvec3(other.transfer[0], other.transfer[1], other.transfer[2]);
    }
    for (int c = 0; c < 3; ++c) {
      const double expected = own.transfer ? sum[c] / whole : 0.0;
      ASSERT_NEAR(transfer[3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(c)], expected,
                  3e-3);  // parts below 1e-4 are left out
    }
  }
}

// Units are anything: nothing overflows or vanishes.
TEST(LightFilterTest, TheUnitOfTheFieldDoesNotMatter) {
  const auto filteredIn = [](float unit) {
    std::vector<FilterTexel> texels = planes();
    for (std::size_t i = 0; i < kAll; ++i) {
      texels[i].isovalue *= unit;
      texels[i].shape.steepness *= unit;
      texels[i].sky.x = static_cast<float>(i % kFilterTexels);
    }
    return filterBlock(texels)[3 * 64 + 3 * 8 + 3].sky.x;
  };
  const float expected = filteredIn(1.0f);
  EXPECT_GT(expected, 3.0f);
  EXPECT_LT(expected, 5.0f);
  for (const float unit : {1e-36f, 1e30f}) EXPECT_NEAR(filteredIn(unit), expected, 1e-5f) << unit;
}

TEST(FieldShapeTest, OfALineAndAParabola) {
  for (const float unit : {1e-36f, 1.0f, 1e36f}) {
    const FieldShape line =
        fieldShape(5.0f * unit, glm::vec3(4.0f, 3.0f, 3.0f) * unit, glm::vec3(6.0f, 7.0f, 7.0f) * unit);
    EXPECT_NEAR(line.steepness / unit, 3.0f, 1e-5f);
    EXPECT_NEAR(line.kink, 0.0f, 1e-6f);
    const FieldShape parabola =
        fieldShape(9.0f * unit, glm::vec3(4.0f, 9.0f, 9.0f) * unit, glm::vec3(16.0f, 9.0f, 9.0f) * unit);
    EXPECT_NEAR(parabola.steepness / unit, 6.0f, 1e-5f);
    EXPECT_NEAR(parabola.kink, 1.0f / 3.0f, 1e-6f);
  }
}

TEST(FieldShapeTest, AtTheBorderTheOneSideThereIs) {
  const glm::vec3 none(NAN), known(7.0f, 5.0f, 5.0f);
  const FieldShape shape = fieldShape(5.0f, none, known);
  EXPECT_FLOAT_EQ(shape.steepness, 2.0f);
  EXPECT_FLOAT_EQ(shape.kink, 0.0f);
  EXPECT_FLOAT_EQ(fieldShape(5.0f, known, none).steepness, 2.0f);
  EXPECT_FLOAT_EQ(fieldShape(5.0f, none, none).steepness, 0.0f);
}

TEST(LightFilterTest, BlackLightStaysBlack) {
  std::vector<FilterTexel> texels = planes();
  for (FilterTexel& t : texels) t.sky = t.lamps = glm::vec3(0.0f);
  for (const FilterTexel& t : filterBlock(texels)) {
    EXPECT_EQ(t.sky, glm::vec3(0.0f));
    EXPECT_EQ(t.lamps, glm::vec3(0.0f));
  }
}

// Dark beside bright: what lookups take from the bright texel is taken back, as far as there is light.
TEST(LightFilterTest, NoLightIsNegative) {
  std::vector<FilterTexel> texels = planes();
  for (std::size_t i = 0; i < kAll; ++i) {
    texels[i].skyPaths = 1e6f;
    texels[i].place.x += 0.5f;  // between texels: a lookup there takes half of the next
    texels[i].sky = glm::vec3(i % kFilterTexels < 6 ? 0.0f : 100.0f);
  }
  for (const FilterTexel& t : filterBlock(texels)) EXPECT_GE(t.sky.x, 0.0f);
}

// Nothing says how far apart isosurfaces are, and none are.
TEST(LightFilterTest, OnAPlateauLightOfOneValueStays) {
  std::vector<FilterTexel> texels = planes();
  for (FilterTexel& t : texels) {
    t.isovalue = 0.0f;
    t.shape = {0.0f, 0.0f};
  }
  for (const FilterTexel& t : filterBlock(texels)) EXPECT_NEAR(t.sky.y, 3.0f, 1e-5f);
}

// Lit on a neighbour's place, of which nothing is known: a lookup there finds no light.
TEST(LightFilterTest, ATexelAloneStays) {
  std::vector<FilterTexel> texels = planes();
  const std::size_t alone = inPadded(3, 3, 3);
  for (std::size_t i = 0; i < kAll; ++i)
    if (i != alone) texels[i].normal = glm::vec3(0.0f);
  texels[alone].place.x += 1.0f;
  const std::vector<FilterTexel> result = filterBlock(texels);
  EXPECT_NEAR(result[3 * 64 + 3 * 8 + 3].sky.y, 3.0f, 1e-5f);
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
