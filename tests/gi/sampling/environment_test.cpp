#include "gi/sampling/environment.h"
#include "base/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "gi/harmonics/sh_rotation.h"
#include "gi/sampling/directions.h"
#include "tests/support/invalid_operations.h"
#include "tests/support/spherical_functions.h"
#include "tests/support/statistics.h"

namespace isolux::gi {
namespace {

using test::chiSquaredLimit;
using test::Moments;

using std::numbers::pi;
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

double brightness(glm::dvec3 c) {
  return base::luminance(c);
}

glm::vec2 point(std::uint32_t i) {
  return samplePair(DirectionSequence::random, 11, i, 0);
}
glm::vec3 randomSkyDirection(std::uint32_t i) {
  return test::uniformSphere(samplePair(DirectionSequence::random, 12, i, 0));
}

Environment painted(int width, int height, const std::function<glm::dvec3(glm::dvec3)>& function) {
  const Environment frame =
      Environment(width, height, std::vector<glm::vec3>(static_cast<std::size_t>(width) * height));
  std::vector<glm::vec3> pixels;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      pixels.emplace_back(function(frame.directionOf(column + 0.5, row + 0.5)));
  return Environment(width, height, std::move(pixels));
}

// Images of every kind that sampling must stand up to.
struct Case {
  const char* name;
  Environment environment;
};

std::vector<Case> cases() {
  std::vector<glm::vec3> noise(24 * 11), sun(64 * 32, glm::vec3(0.01f)), range(16 * 8, glm::vec3(1e-3f)),
      sparse(16 * 8, glm::vec3(0.0f)), blue(6 * 5, glm::vec3(0.0f)), top(12 * 6, glm::vec3(0.0f));
  for (std::size_t i = 0; i < noise.size(); ++i) {
    const glm::vec2 u = point(static_cast<std::uint32_t>(i));
    noise[i] = glm::vec3(u.x * u.x, u.y, u.x * u.y);
  }
  sun[10 * 64 + 40] = glm::vec3(1e6f);
  range[3 * 16 + 14] = glm::vec3(1e5f);
  sparse[2] = glm::vec3(1.0f);
  sparse[5 * 16 + 15] = glm::vec3(0.5f, 0, 0);
  sparse[7 * 16] = glm::vec3(1e-6f);
  blue[17] = glm::vec3(0, 0, 1e-30f);
  for (int i = 0; i < 12; ++i) top[i] = glm::vec3(3.0f);
  std::vector<Case> all;
  all.push_back({"constant", Environment::constant({0.2, 1, 3})});
  all.push_back({"black", Environment(8, 4, std::vector<glm::vec3>(32))});
  all.push_back({"noise", Environment(24, 11, noise)});
  all.push_back({"sun", Environment(64, 32, sun)});
  all.push_back({"range", Environment(16, 8, range)});
  all.push_back({"sparse", Environment(16, 8, sparse)});
  all.push_back({"blue", Environment(6, 5, blue)});
  all.push_back({"top", Environment(12, 6, top)});
  all.push_back({"column", Environment(1, 7, std::vector<glm::vec3>(7, glm::vec3(2.0f)))});
  all.push_back({"row", Environment(9, 1, std::vector<glm::vec3>(9, glm::vec3(2.0f)))});
  return all;
}

// It is in the keys of bakes on disk.
TEST(Environment, KeepsItsHash) {
  const std::vector<glm::vec3> pixels{{1.0f, 0.5f, 0.25f}, glm::vec3(2.0f)};
  EXPECT_EQ(Environment(2, 1, pixels).hash(), 0x30a9a465e43d8d03u);
  EXPECT_EQ(Environment(1, 2, pixels).hash(), 0xb6ed448b3b49df9eu);
}

TEST(Environment, SolidAnglesCoverTheSphere) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(5, 3), std::pair(1024, 512)}) {
    const auto environment =
        Environment(width, height, std::vector<glm::vec3>(static_cast<std::size_t>(width) * height));
    double sum = 0;
    for (int row = 0; row < height; ++row) sum += width * environment.solidAngle(row);
    EXPECT_NEAR(sum, 4 * pi, 1e-11);
  }
}

// Row 0 is up, the middle looks to +y, right of it is +x, the left edge looks to -y.
TEST(Environment, LooksWhereTheHeaderSays) {
  std::vector<glm::vec3> pixels(8 * 4);
  for (int i = 0; i < 32; ++i) pixels[i] = glm::vec3(static_cast<float>(i));
  const auto environment = Environment(8, 4, pixels);
  const auto at = [&](glm::vec3 d) { return static_cast<int>(environment.radiance(glm::normalize(d)).r); };
  const float e = 0.1f;
  EXPECT_EQ(at({e, 0.02f, 1}) / 8, 0);
  EXPECT_EQ(at({e, 0.02f, -1}) / 8, 3);
  EXPECT_EQ(at({e, 1, e}), 8 + 4);    // right of the middle, above the horizon
  EXPECT_EQ(at({-e, 1, e}), 8 + 3);   // left of it
  EXPECT_EQ(at({e, 1, -e}), 16 + 4);  // below the horizon
  EXPECT_EQ(at({1, e, e}), 8 + 5);
  EXPECT_EQ(at({1, -e, e}), 8 + 6);
  EXPECT_EQ(at({-1, e, e}), 8 + 2);
  EXPECT_EQ(at({-1, -e, e}), 8 + 1);
  EXPECT_EQ(at({-e, -1, e}), 8 + 0);
  EXPECT_EQ(at({e, -1, e}), 8 + 7);
  for (const glm::vec3& pole : {glm::vec3(0, 0, 1), glm::vec3(0, 0, -1)})
    EXPECT_EQ(at(pole) / 8, pole.z > 0 ? 0 : 3);
  EXPECT_NEAR(glm::distance(environment.directionOf(4, 2), glm::dvec3(0, 1, 0)), 0.0, 1e-15);
  EXPECT_NEAR(glm::distance(environment.directionOf(6, 2), glm::dvec3(1, 0, 0)), 0.0, 1e-15);
  EXPECT_NEAR(glm::distance(environment.directionOf(0, 2), glm::dvec3(0, -1, 0)), 0.0, 1e-15);
  EXPECT_NEAR(glm::distance(environment.directionOf(3, 0), glm::dvec3(0, 0, 1)), 0.0, 1e-15);
}

TEST(Environment, EveryPointOfAPixelFindsIt) {
  constexpr int width = 128, height = 64;
  std::vector<glm::vec3> pixels(width * height);
  for (int i = 0; i < width * height; ++i) pixels[i] = glm::vec3(static_cast<float>(i));
  const auto environment = Environment(width, height, pixels);
  for (int i = 0; i < width * height; ++i)
    for (const double f : {1e-3, 0.5, 1 - 1e-3})
      for (const double g : {1e-3, 0.5, 1 - 1e-3})
        ASSERT_EQ(environment.radiance(glm::vec3(environment.directionOf(i % width + f, i / width + g))).r,
                  static_cast<float>(i));
}

TEST(Environment, PdfIntegratesToOneAndFollowsLuminance) {
  for (const auto& [name, environment] : cases()) {
    const auto at = [&e = environment](int column, int row) {
      return glm::vec3(e.directionOf(column + 0.5, row + 0.5));
    };
    double integral = 0, light = 0;
    std::vector<double> lightOfRow(environment.height(), 0.0);
    for (int row = 0; row < environment.height(); ++row)
      for (int column = 0; column < environment.width(); ++column) {
        const double area = environment.solidAngle(row);
        const double pixel = environment.isBlack() ? 1.0 : brightness(environment.radiance(at(column, row)));
        integral += environment.lookUp(at(column, row)).pdf * area;
        lightOfRow[row] += pixel * area;
        light += pixel * area;
      }
    EXPECT_NEAR(integral, 1.0, 1e-6) << name;
    for (int row = 0; row < environment.height(); ++row)
      for (int column = 0; column < environment.width(); ++column) {
        const glm::vec3 d = at(column, row);
        const double area = environment.solidAngle(row);
        const double pixel = environment.isBlack() ? 1.0 : brightness(environment.radiance(d));
        if (pixel == 0.0) {
          EXPECT_EQ(environment.lookUp(d).pdf, 0.0f) << name;
          continue;
        }
        EXPECT_GT(environment.lookUp(d).pdf, 0.0f) << name;
        // The probabilities of the row and of the column in it are whole numbers of 2^-31: both ends of an
        // interval are rounded, and one may have made room for an improbable neighbour.
        const double ofRow = lightOfRow[row] / light, ofColumn = pixel * area / lightOfRow[row];
        const double rounding = 2.0 * 0x1p-31;
        const double tolerance = rounding * (ofRow + ofColumn + rounding) + 5e-7 * ofRow * ofColumn;
        EXPECT_NEAR(environment.lookUp(d).pdf * area, ofRow * ofColumn, tolerance) << name;
      }
  }
}

// Counts of samples per pixel against pdf times solid angle. Pixels of few expected samples are put together.
TEST(Environment, SamplesFollowThePdf) {
  constexpr int samples = 200000;
  for (const auto& [name, environment] : cases()) {
    std::vector<double> counts(environment.pixels().size());
    for (int i = 0; i < samples; ++i) {
      const Environment::Sample s = environment.sample(point(i));
      ASSERT_NEAR(glm::length(s.direction), 1.0f, 1e-6f) << name;
      ASSERT_GT(s.pdf, 0.0f) << name;
      const double column = (std::atan2(s.direction.x, s.direction.y) / (2 * pi) + 0.5) * environment.width();
      const double row = std::acos(std::clamp(s.direction.z, -1.0f, 1.0f)) / pi * environment.height();
      const int r = std::min(static_cast<int>(row), environment.height() - 1);
      const int c = std::min(static_cast<int>(column), environment.width() - 1);
      counts[r * environment.width() + c]++;
    }
    double chi = 0, restExpected = 0, rest = 0;
    int cells = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const int row = static_cast<int>(i) / environment.width(),
                column = static_cast<int>(i) % environment.width();
      const double expected =
          samples * environment.solidAngle(row) *
          environment.lookUp(glm::vec3(environment.directionOf(column + 0.5, row + 0.5))).pdf;
      if (expected < 10) {
        restExpected += expected;
        rest += counts[i];
        continue;
      }
      chi += (counts[i] - expected) * (counts[i] - expected) / expected;
      ++cells;
    }
    if (restExpected >= 10) {
      chi += (rest - restExpected) * (rest - restExpected) / restExpected;
      ++cells;
    } else {
      EXPECT_LT(rest, restExpected + 6 * std::sqrt(restExpected) + 5) << name;
    }
    EXPECT_LT(chi, cells > 1 ? chiSquaredLimit(cells - 1) : 1.0) << name << " " << cells;
  }
}

// Within a pixel the density is even over solid angle: a single bright pixel that is a large part of the
// sphere.
TEST(Environment, SamplesAreEvenWithinAPixel) {
  for (const int bright : {0, 1}) {
    std::vector<glm::vec3> pixels(3 * 2);
    pixels[bright * 3 + 2] = glm::vec3(1.0f);
    const auto environment = Environment(3, 2, pixels);
    std::vector<double> counts(100);
    constexpr int samples = 100000;
    for (int i = 0; i < samples; ++i) {
      const glm::dvec3 d(environment.sample(point(i)).direction);
      const double azimuth = (std::atan2(d.x, d.y) / (2 * pi) + 0.5) * 3 - 2;
      const double z = std::abs(d.z);
      ASSERT_EQ(d.z < 0, bright == 1);
      counts[std::clamp(static_cast<int>(10 * z), 0, 9) * 10 +
             std::clamp(static_cast<int>(10 * azimuth), 0, 9)]++;
    }
    double chi = 0;
    for (const double c : counts) chi += (c - samples / 100.0) * (c - samples / 100.0) / (samples / 100.0);
    EXPECT_LT(chi, chiSquaredLimit(99));
  }
}

// What sample() says of a direction is what radiance() and pdf() say of it, but where rounding puts a
// direction on the edge of its pixel into the next.
TEST(Environment, SampleRadianceAndPdfAgree) {
  for (const auto& [name, environment] : cases()) {
    int differ = 0;
    for (int i = 0; i < 20000; ++i) {
      const Environment::Sample s = environment.sample(point(i));
      if (s.radiance != environment.radiance(s.direction) || s.pdf != environment.lookUp(s.direction).pdf)
        ++differ;
    }
    EXPECT_LT(differ, 20) << name;
  }
  const Environment black = Environment(8, 4, std::vector<glm::vec3>(32));
  for (const glm::vec2& u : {glm::vec2(0), glm::vec2(1 - 0x1p-24f), glm::vec2(0.5f)}) {
    const Environment::Sample s = black.sample(u);
    EXPECT_EQ(s.radiance, glm::vec3(0.0f));
    EXPECT_NEAR(s.pdf, 0.25 / pi, 1e-6);
  }
}

// Irradiance on a plane by sampling the environment, and by sampling the cosine, against the sum over pixels.
TEST(Environment, IrradianceByBothSamplingsIsThatOfQuadrature) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.3, -0.5, 0.6));
  const Frame frame = Frame::about(glm::vec3(normal));
  for (const auto& [name, environment] : cases()) {
    glm::dvec3 expected(0.0);
    constexpr int parts = 16;  // each pixel as parts x parts: exact but for the edge of the horizon
    for (int row = 0; row < environment.height(); ++row)
      for (int column = 0; column < environment.width(); ++column) {
        const glm::dvec3 radiance = environment.pixels()[row * environment.width() + column];
        if (radiance == glm::dvec3(0.0)) continue;
        const int n = environment.pixels().size() < 10 ? 40 * parts : parts;
        for (int i = 0; i < n; ++i)
          for (int j = 0; j < n; ++j) {
            const double y = row + (i + 0.5) / n, cell = pi / environment.height() / n;
            const double area = 2 * pi / environment.width() / n * 2 *
                                std::sin(pi * y / environment.height()) * std::sin(0.5 * cell);
            const glm::dvec3 d = environment.directionOf(column + (j + 0.5) / n, y);
            expected += radiance * area * std::max(0.0, glm::dot(normal, d));
          }
      }
    Moments byLight, byCosine;
    for (int i = 0; i < 100000; ++i) {
      const Environment::Sample s = environment.sample(point(i));
      byLight.add(brightness(s.radiance) * std::max(0.0f, glm::dot(glm::vec3(normal), s.direction)) / s.pdf);
      byCosine.add(pi *
                   brightness(environment.radiance(frame.toWorld(cosineHemisphere(point(i + 1000000))))));
    }
    EXPECT_LT(std::abs(byLight.z(brightness(expected))), 4.5) << name;
    // A sun that no cosine direction meets has an empirical variance without meaning.
    if (std::string(name) != "sun" && std::string(name) != "blue" && std::string(name) != "sparse") {
      EXPECT_LT(std::abs(byCosine.z(brightness(expected))), 4.5) << name;
    }
  }
}

TEST(Environment, BrightTopLightsUpwardSurfaces) {
  std::vector<glm::vec3> pixels(16 * 8);
  for (int i = 0; i < 16; ++i) pixels[i] = glm::vec3(1.0f);
  const auto environment = Environment(16, 8, pixels);
  const auto sh = environment.project(5);
  EXPECT_GT(test::irradianceSh(5, sh, glm::dvec3(0, 0, 1)).g,
            3 * test::irradianceSh(5, sh, glm::dvec3(1, 0, 0)).g);
  EXPECT_GT(environment.radiance(glm::vec3(0, 0, 1)).g, 0.5f);
  EXPECT_EQ(environment.radiance(glm::vec3(0, 0, -1)).g, 0.0f);
  // The cap of half angle pi / 8: E = pi sin^2, up to the bands left out.
  const auto all = environment.project(8);
  EXPECT_NEAR(test::irradianceSh(8, all, glm::dvec3(0, 0, 1)).g, pi * std::pow(std::sin(pi / 8), 2), 0.01);
}

TEST(Environment, MeanIsOverTheSphere) {
  EXPECT_NEAR(glm::distance(Environment::constant({1, 2, 3}).mean(), glm::dvec3(1, 2, 3)), 0.0, 1e-12);
  std::vector<glm::vec3> top(16 * 8);
  for (int i = 0; i < 16; ++i) top[i] = glm::vec3(2, 0, 1);
  const double part = (1 - std::cos(pi / 8)) / 2;  // of the sphere
  EXPECT_NEAR(glm::distance(Environment(16, 8, top).mean(), part * glm::dvec3(2, 0, 1)), 0.0, 1e-12);
}

// Exact over pixels: against quadrature of the radiance itself, subdivided; and the first coefficient is the
// mean.
TEST(Environment, ProjectionIntegratesThePixels) {
  for (const auto& [name, environment] : cases()) {
    const auto coefficients = environment.project(maxShOrder);
    EXPECT_NEAR(glm::distance(coefficients[0], std::sqrt(4 * pi) * environment.mean()), 0.0,
                1e-12 * (1 + glm::length(environment.mean())))
        << name;
    std::vector<glm::dvec3> expected(coefficients.size(), glm::dvec3(0.0));
    const GaussLegendre rule(32);
    double scale = 0;
    for (int row = 0; row < environment.height(); ++row)
      for (int column = 0; column < environment.width(); ++column) {
        const glm::dvec3 radiance = environment.pixels()[row * environment.width() + column];
        if (radiance == glm::dvec3(0.0)) continue;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i)
          for (std::size_t j = 0; j < rule.nodes.size(); ++j) {
            const double x = column + 0.5 + 0.5 * rule.nodes[j], y = row + 0.5 + 0.5 * rule.nodes[i];
            const double area = std::sin(pi * y / environment.height()) * rule.weights[i] * rule.weights[j] *
                                0.25 * 2 * pi / environment.width() * pi / environment.height();
            std::array<double, shTerms(maxShOrder)> basis;
            evaluateSh(maxShOrder, environment.directionOf(x, y), basis.data());
            for (std::size_t k = 0; k < expected.size(); ++k) expected[k] += radiance * (area * basis[k]);
            scale += area * glm::length(radiance);
          }
      }
    for (std::size_t k = 0; k < expected.size(); ++k)
      EXPECT_NEAR(glm::distance(coefficients[k], expected[k]), 0.0, 1e-11 * scale) << name << " " << k;
    const auto fewer = environment.project(3);
    for (std::size_t k = 0; k < fewer.size(); ++k)
      EXPECT_NEAR(glm::distance(fewer[k], coefficients[k]), 0.0, 1e-12 * scale);
  }
}

// A band-limited function painted at pixel centres: its coefficients come back with an error of second order
// in the size of a pixel.
TEST(Environment, ProjectionOfAPaintedFunctionConverges) {
  std::vector<glm::dvec3> wanted(25);
  for (int i = 0; i < 25; ++i)
    wanted[i] = 0.1 * glm::dvec3(std::sin(i + 1.0), std::cos(3.0 * i), std::sin(2.0 * i * i));
  wanted[0] = glm::dvec3(10.0);  // above 0 everywhere
  const auto error = [&](int height) {
    const auto found = painted(2 * height, height, [&](glm::dvec3 d) {
                         return test::reconstructSh(5, wanted, d);
                       }).project(5);
    double sum = 0;
    for (int i = 0; i < 25; ++i) sum += glm::dot(found[i] - wanted[i], found[i] - wanted[i]);
    return std::sqrt(sum);
  };
  const double coarse = error(32), fine = error(64);
  EXPECT_LT(coarse, 0.02);
  EXPECT_NEAR(coarse / fine, 4.0, 0.2);
}

TEST(Environment, NonFinitePixelsBecomeTheMeanOfTheirNeighboursAndAreCounted) {
  std::vector<glm::vec3> pixels(6 * 4, glm::vec3(1, 2, 3));
  pixels[7] = glm::vec3(nan, 2, 3);
  pixels[8] = glm::vec3(1, infinity, 3);
  pixels[12] = glm::vec3(1, 2, -infinity);
  pixels[23] = glm::vec3(-5, 2, 3);
  const auto environment = Environment(6, 4, pixels);
  EXPECT_EQ(environment.badPixels(), 4u);
  for (int i = 0; i < 23; ++i)
    EXPECT_NEAR(glm::distance(environment.pixels()[i], glm::vec3(1, 2, 3)), 0, i == 12 ? 0.15 : 0) << i;
  EXPECT_EQ(environment.pixels()[23], glm::vec3(0, 2, 3));
  // Beside the left edge lies the right one: pixel 12 has pixel 23 among the seven that are finite.
  EXPECT_NEAR(environment.pixels()[12].r, 6.0f / 7.0f, 1e-6f);
  const auto none = Environment(2, 1, {glm::vec3(nan), glm::vec3(infinity)});
  EXPECT_EQ(none.badPixels(), 2u);
  EXPECT_TRUE(none.isBlack());
  EXPECT_EQ(Environment::constant({1, 1, 1}).badPixels(), 0u);
  EXPECT_EQ(Environment::constant({0.5, 0.5, 0.5}).badPixels(), 0u);
}

// Probabilities are whole numbers of 2^-31; what shines a little must not fall below one, wherever it stands.
TEST(Environment, ARarePixelIsNeverWithoutProbability) {
  constexpr int width = 8, height = 6;
  for (const int rare : {0, 3, 7, 8, 20, 40, 47})
    for (const int rareToo : {1, 30, 46}) {
      std::vector<glm::vec3> pixels(width * height, glm::vec3(1.0f));
      pixels[rare] = pixels[rareToo] = glm::vec3(1e-20f);
      const auto environment = Environment(width, height, pixels);
      for (const int i : {rare, rareToo}) {
        const glm::vec3 middle(environment.directionOf(i % width + 0.5, i / width + 0.5));
        ASSERT_EQ(environment.radiance(middle).r, 1e-20f);
        EXPECT_GT(environment.lookUp(middle).pdf, 0.0f) << rare << ' ' << rareToo << ' ' << i;
      }
    }
  // A first row of little light, too.
  std::vector<glm::vec3> pixels(width * height, glm::vec3(1.0f));
  std::fill_n(pixels.begin(), width, glm::vec3(1e-20f));
  const auto environment = Environment(width, height, pixels);
  EXPECT_GT(environment.lookUp(glm::vec3(environment.directionOf(2.5, 0.5))).pdf, 0.0f);
}

TEST(Environment, RowsWithoutLightHaveNoDistribution) {
  std::vector<glm::vec3> pixels(8 * 4, glm::vec3(0.0f));
  pixels[2 * 8 + 3] = glm::vec3(1.0f);
  const test::InvalidOperations invalid;
  const auto environment = Environment(8, 4, pixels);
  EXPECT_FALSE(invalid.met());
  EXPECT_EQ(environment.lookUp(glm::vec3(environment.directionOf(3.5, 1.5))).pdf, 0.0f);
  EXPECT_NEAR(environment.lookUp(glm::vec3(environment.directionOf(3.5, 2.5))).pdf,
              1.0 / environment.solidAngle(2), 1e-6 / environment.solidAngle(2));
}

TEST(Environment, HugeValuesStayFinite) {
  std::vector<glm::vec3> pixels(8 * 4, glm::vec3(3e38f));
  pixels[5] = glm::vec3(1e-45f);
  const auto environment = Environment(8, 4, pixels);
  EXPECT_GT(environment.lookUp(glm::vec3(environment.directionOf(5.5, 0.5))).pdf, 0.0f);
  for (int i = 0; i < 1000; ++i) EXPECT_TRUE(std::isfinite(environment.sample(point(i)).pdf));
  EXPECT_TRUE(std::isfinite(environment.mean().r));
}

TEST(Environment, KnowsWhatIsConstantAndHashesPixels) {
  EXPECT_TRUE(Environment::constant({1, 0, 0}).isConstant());
  EXPECT_TRUE(Environment(3, 2, std::vector<glm::vec3>(6, glm::vec3(0.5f))).isConstant());
  std::vector<glm::vec3> pixels(6, glm::vec3(0.5f));
  pixels[5].b = 0.25f;
  const auto a = Environment(3, 2, pixels), b = Environment(2, 3, pixels);
  EXPECT_FALSE(a.isConstant());
  EXPECT_EQ(a.hash(), Environment(3, 2, pixels).hash());
  EXPECT_NE(a.hash(), b.hash());
  std::swap(pixels[4], pixels[5]);
  EXPECT_NE(a.hash(), Environment(3, 2, pixels).hash());
}

TEST(Sky, QuaternionTurnsTheEnvironmentAndScaleMultipliesIt) {
  // A quarter turn about z takes what looked to +x to +y.
  const double h = std::sqrt(0.5);
  const glm::dmat3 quarter = worldFromEnvironment(glm::dquat(h, 0, 0, h));
  EXPECT_NEAR(glm::distance(quarter * glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)), 0.0, 1e-15);
  EXPECT_NEAR(glm::distance(worldFromEnvironment(glm::dquat(20 * h, 0, 0, 20 * h))[0], quarter[0]), 0.0,
              1e-15);
  EXPECT_EQ(worldFromEnvironment(glm::dquat(0, 0, 0, 0)), glm::dmat3(1.0));

  for (const auto& [name, environment] : cases()) {
    const glm::dmat3 turn = worldFromEnvironment(glm::dquat(0.3, -0.5, 0.7, 0.2));
    const Sky sky{std::make_shared<const Environment>(environment), glm::mat3(turn), 4.0f};
    for (int i = 0; i < 200; ++i) {
      const glm::vec3 own = randomSkyDirection(i), world(turn * glm::dvec3(own));
      EXPECT_EQ(sky.lookUp(world).radiance, 4.0f * environment.radiance(own)) << name;
      EXPECT_EQ(sky.lookUp(world).pdf, environment.lookUp(own).pdf) << name;
      const Environment::Sample a = sky.sample(point(i)), b = environment.sample(point(i));
      EXPECT_NEAR(glm::distance(a.direction, glm::vec3(turn * glm::dvec3(b.direction))), 0.0f, 1e-6f);
      EXPECT_EQ(a.radiance, 4.0f * b.radiance);
      EXPECT_EQ(a.pdf, b.pdf);
    }
  }
}

// The rotated coefficients are those of the turned sky: the three conventions (image, quaternion, rotation of
// coefficients) agree.
TEST(Sky, RotatedCoefficientsAreThoseOfTheTurnedSky) {
  const auto environment = painted(128, 64, [](glm::dvec3 d) {
    return glm::dvec3(std::exp(2 * d.x + d.y), std::exp(3 * d.z), 1 + d.x * d.y);
  });
  const glm::dmat3 turn = worldFromEnvironment(glm::dquat(0.3, -0.5, 0.7, 0.2));
  std::vector<glm::dvec3> turned = environment.project(5);
  ShRotation(5, turn).apply(turned, turned);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 d = glm::normalize(glm::dvec3(randomSkyDirection(i)));
    const glm::dvec3 own = test::reconstructSh(5, environment.project(5), d);
    EXPECT_NEAR(glm::distance(test::reconstructSh(5, turned, turn * d), own), 0.0, 1e-11 * glm::length(own));
  }
  const Sky sky{std::make_shared<const Environment>(environment), glm::mat3(turn)};
  // Monte Carlo projection of the turned sky, band 1 and 2, green.
  std::array<Moments, 9> moments;
  for (int i = 0; i < 50000; ++i) {
    const Environment::Sample s = sky.sample(point(i));
    std::array<float, 9> y;
    evaluateSh(3, s.direction, y.data());
    for (int k = 0; k < 9; ++k) moments[k].add(s.radiance.g * y[k] / s.pdf);
  }
  for (int k = 0; k < 9; ++k) EXPECT_LT(std::abs(moments[k].z(turned[k].g)), 4.5) << k;
}

}  // namespace
}  // namespace isolux::gi
