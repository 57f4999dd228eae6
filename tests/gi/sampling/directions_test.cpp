#include "gi/sampling/directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/spherical_functions.h"
#include "tests/support/statistics.h"

namespace isolux::gi {
namespace {

using test::chiSquaredLimit;
using test::Moments;

using std::numbers::pi;
constexpr std::array<DirectionSequence, 3> sequences{DirectionSequence::sobol_owen, DirectionSequence::r2,
                                                     DirectionSequence::random};

glm::vec2 randomPair(std::uint32_t i) {
  return samplePair(DirectionSequence::random, 7, i, 0);
}

TEST(SamplePair, LiesInTheOpenUnitSquareAndIsAFunctionOfItsArguments) {
  for (const DirectionSequence sequence : sequences)
    for (std::uint32_t i = 0; i < 20000; ++i) {
      const std::uint32_t sample = i < 10000 ? i : ~i;
      const glm::vec2 u = samplePair(sequence, i / 100, sample, i % 5);
      const float one = sampleOne(sequence, i / 100, sample, i % 5);
      for (const float v : {u.x, u.y, one}) {
        ASSERT_GT(v, 0.0f);
        ASSERT_LT(v, 1.0f);
      }
      ASSERT_EQ(u, samplePair(sequence, i / 100, sample, i % 5));
      ASSERT_EQ(one, sampleOne(sequence, i / 100, sample, i % 5));
    }
}

// Every elementary box of every shape: the definition of a (0, m, 2)-net in base 2.
void expectNet(const std::vector<glm::vec2>& points, int m, const std::string& what) {
  ASSERT_EQ(points.size(), 1u << m);
  for (int wide = 0; wide <= m; ++wide) {
    std::vector<int> count(points.size(), 0);
    for (const glm::vec2& p : points) {
      const auto x = static_cast<std::size_t>(std::ldexp(p.x, wide));
      const auto y = static_cast<std::size_t>(std::ldexp(p.y, m - wide));
      ++count[x << (m - wide) | y];
    }
    for (const int c : count) ASSERT_EQ(c, 1) << what << ", boxes 2^-" << wide << " wide";
  }
}

TEST(SamplePair, ScrambledSobolIsANetInEveryAlignedBlockAndPair) {
  for (const std::uint32_t seed : {0u, 1u, 123456u, 0xffffffffu})
    for (const std::uint32_t pair : {0u, 1u, 2u, 9u})
      for (int m = 0; m <= 10; ++m)
        for (const std::uint32_t block : {0u, 1u, 5u, (0xffffffffu >> m)}) {
          std::vector<glm::vec2> points;
          for (std::uint32_t i = 0; i < 1u << m; ++i)
            points.push_back(samplePair(DirectionSequence::sobol_owen, seed, (block << m) + i, pair));
          expectNet(points, m, "seed " + std::to_string(seed) + " pair " + std::to_string(pair));
        }
}

TEST(SampleOne, PutsOnePointIntoEachPartOfTheInterval) {
  for (const DirectionSequence sequence : {DirectionSequence::sobol_owen, DirectionSequence::r2})
    for (const std::uint32_t dimension : {0u, 1u, 7u}) {
      std::set<int> parts;
      for (std::uint32_t i = 0; i < 1024; ++i)
        parts.insert(static_cast<int>(1024.0f * sampleOne(sequence, 42, i, dimension)));
      EXPECT_EQ(parts.size(), 1024u);
    }
}

// Steps of R2 from its definition, at small and at the largest sample numbers.
TEST(SamplePair, R2IsTheShiftedLatticeWithoutDrift) {
  long double p = 1.3L;
  for (int i = 0; i < 100; ++i) p -= (p * p * p - p - 1) / (3 * p * p - 1);
  const auto fraction = [](long double v) { return v - std::floor(v); };
  for (const std::uint32_t seed : {0u, 5u, 0x80000000u}) {
    const glm::vec2 shift = samplePair(DirectionSequence::r2, seed, 0, 0);
    for (const std::uint32_t n : {1u, 2u, 100u, 1u << 20, 0x7fffffffu, 0xffffffffu}) {
      const glm::vec2 u = samplePair(DirectionSequence::r2, seed, n, 0);
      for (int k = 0; k < 2; ++k) {
        const long double expected = fraction(shift[k] + n / (k == 0 ? p : p * p));
        const long double apart = std::abs(u[k] - expected);
        EXPECT_LT(std::min(apart, 1 - apart), 3e-7L) << n;
      }
    }
  }
}

// Independent points have uniform counts; nets have counts that are too even, which the upper limit allows.
// Over seeds, every single sample number is uniform in the square, and two pairs of it are independent.
TEST(SamplePair, IsUniformOverSeedsAndPairsAreIndependent) {
  constexpr int cells = 8, seeds = 64000;
  for (const DirectionSequence sequence : sequences)
    for (const std::uint32_t sample : {0u, 1u, 37u, 99u}) {
      std::vector<double> square(cells * cells), joint(cells * cells * 4), last(cells * cells);
      for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        const glm::vec2 a = samplePair(sequence, seed, sample, 0), b = samplePair(sequence, seed, sample, 1);
        const float one = sampleOne(sequence, seed, sample, 0);
        const auto cell = [&](float v, int n) { return static_cast<int>(v * static_cast<float>(n)); };
        square[cell(a.x, cells) * cells + cell(a.y, cells)]++;
        joint[((cell(a.x, 4) * 4 + cell(a.y, 4)) * 4 + cell(b.x, 4)) * 4 + cell(b.y, 4)]++;
        last[cell(one, cells) * cells + cell(b.y, cells)]++;
      }
      for (const auto& counts : {square, joint, last}) {
        double chi = 0;
        const double expected = seeds / static_cast<double>(counts.size());
        for (const double c : counts) chi += (c - expected) * (c - expected) / expected;
        EXPECT_LT(chi, chiSquaredLimit(static_cast<int>(counts.size()) - 1));
      }
    }
}

// The pairs of one pattern must not be tied to one another: points of pair 0 and 1 with the same number, over
// one long pattern.
TEST(SamplePair, PairsOfOnePatternFillTheirProductSpace) {
  constexpr int samples = 1 << 16;
  for (const DirectionSequence sequence : sequences)
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
      for (int first = 0; first < 3; ++first)
        for (int second = 0; second < 2; ++second) {
          std::vector<double> counts(256);
          for (std::uint32_t i = 0; i < samples; ++i) {
            const glm::vec2 a = samplePair(sequence, seed, i, first == 2 ? 2 : 0);
            const glm::vec2 b = samplePair(sequence, seed, i, 1);
            counts[static_cast<int>(16 * a[first % 2]) * 16 + static_cast<int>(16 * b[second])]++;
          }
          double chi = 0;
          for (const double c : counts)
            chi += (c - samples / 256.0) * (c - samples / 256.0) / (samples / 256.0);
          EXPECT_LT(chi, chiSquaredLimit(255)) << static_cast<int>(sequence) << " " << first << second;
        }
    }
}

// The mean of smooth and of broken integrands over seeds is the integral (z-test), and scrambled points have
// far less variance than random ones at the same number of samples.
TEST(SamplePair, MeansAreUnbiasedAndLowDiscrepancyHasLessVariance) {
  struct Integrand {
    std::function<double(glm::vec2)> function;
    double integral;
  };
  const std::vector<Integrand> integrands{
      {[](glm::vec2 u) { return u.x * u.y; }, 0.25},
      {[](glm::vec2 u) { return std::sin(pi * u.x) * std::exp(u.y); }, 2.0 / pi * (std::numbers::e - 1.0)},
      {[](glm::vec2 u) { return u.x + 0.7 * u.y < 0.6 ? 1.0 : 0.0; }, 0.36 / 1.4}};
  constexpr std::uint32_t samples = 100, seeds = 2000;
  for (const Integrand& integrand : integrands)
    for (const std::uint32_t pair : {0u, 3u}) {
      std::array<double, 3> variance;
      for (std::size_t s = 0; s < sequences.size(); ++s) {
        Moments means;
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
          double sum = 0;
          for (std::uint32_t i = 0; i < samples; ++i)
            sum += integrand.function(samplePair(sequences[s], seed, i, pair));
          means.add(sum / samples);
        }
        EXPECT_LT(std::abs(means.z(integrand.integral)), 4.5) << s;
        variance[s] = means.variance();
      }
      // The ratio of two estimated variances of 2000 values each has a standard error of about 4.5 %.
      EXPECT_LT(variance[0], variance[2] * (1 - 5 * 0.045));
      EXPECT_LT(variance[1], variance[2] * (1 - 5 * 0.045));
    }
}

TEST(ConcentricDisk, KeepsAreasAndRadii) {
  std::vector<double> counts(100);
  constexpr int samples = 100000;
  for (int i = 0; i < samples; ++i) {
    const glm::vec2 u = randomPair(i), p = concentricDisk(u);
    const double radius = glm::length(p);
    ASSERT_NEAR(radius, std::max(std::abs(2 * u.x - 1), std::abs(2 * u.y - 1)), 2e-7);
    const int ring = std::min(9, static_cast<int>(10 * radius * radius));
    const int sector = std::min(9, static_cast<int>(10 * (std::atan2(p.y, p.x) / (2 * pi) + 0.5)));
    counts[ring * 10 + sector]++;
  }
  double chi = 0;
  for (const double c : counts) chi += (c - samples / 100.0) * (c - samples / 100.0) / (samples / 100.0);
  EXPECT_LT(chi, chiSquaredLimit(99));
  EXPECT_EQ(concentricDisk({0.5f, 0.5f}), glm::vec2(0.0f));
}

// Each map against its density: counts in bands of z of equal probability times sectors of azimuth.
TEST(DirectionMaps, FollowTheirDensities) {
  struct Map {
    std::function<glm::vec3(glm::vec2)> direction;
    std::function<double(double)> below;  // probability of a smaller 1 - z, from 1 - z
  };
  const std::vector<Map> maps{
      {cosineHemisphere, [](double t) { return t * (2 - t); }},
      {test::uniformSphere, [](double t) { return t / 2; }},
      {[](glm::vec2 u) { return uniformCone(u, 1.0f); }, [](double t) { return t; }},
      {[](glm::vec2 u) { return uniformCone(u, 0.01f); }, [](double t) { return t / 0.01; }}};
  constexpr int samples = 100000;
  for (const Map& map : maps) {
    std::vector<double> counts(100);
    for (int i = 0; i < samples; ++i) {
      const glm::dvec3 d(map.direction(randomPair(i)));
      ASSERT_NEAR(glm::length(d), 1.0, 3e-7);
      const double t = (d.x * d.x + d.y * d.y) / (1 + d.z);  // 1 - z with all its digits
      const int band = std::clamp(static_cast<int>(10 * map.below(d.z > -0.9 ? t : 1 - d.z)), 0, 9);
      const int sector = std::min(9, static_cast<int>(10 * (std::atan2(d.y, d.x) / (2 * pi) + 0.5)));
      counts[band * 10 + sector]++;
    }
    double chi = 0;
    for (const double c : counts) chi += (c - samples / 100.0) * (c - samples / 100.0) / (samples / 100.0);
    EXPECT_LT(chi, chiSquaredLimit(99));
  }
}

TEST(DirectionMaps, HoldAtTheirEnds) {
  const float end = 1.0f - 0x1p-24f;
  for (const glm::vec2& u :
       {glm::vec2(0), glm::vec2(end), glm::vec2(0, end), glm::vec2(0.5f), glm::vec2(0x1p-24f)})
    for (const glm::vec3& d :
         {cosineHemisphere(u), test::uniformSphere(u), uniformCone(u, 0.0f), uniformCone(u, 1e-12f)})
      EXPECT_NEAR(glm::length(d), 1.0f, 3e-7f);
  EXPECT_EQ(uniformCone({0.3f, 0.9f}, 0.0f), glm::vec3(0, 0, 1));
  // No sample lies in the surface: every cosine is above 0.
  EXPECT_GT(cosineHemisphere(glm::vec2(0x1p-24f)).z, 0.0f);
  EXPECT_GT(cosineHemisphere(glm::vec2(1 - 0x1p-24f)).z, 0.0f);
}

TEST(Ball, ConeIsThatOfItsTangents) {
  for (const double distance : {1.0001, 1.5, 3.0, 1e3, 1e6}) {
    const double sine = 1.0 / distance;
    const double expected = sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
    EXPECT_NEAR(oneMinusCosineOfBall(1.0f, static_cast<float>(distance)) / expected, 1.0, 1e-4) << distance;
  }
  EXPECT_EQ(oneMinusCosineOfBall(1.0f, 1.0f), 2.0f);
  EXPECT_EQ(oneMinusCosineOfBall(1.0f, 0.0f), 2.0f);
}

TEST(Frame, IsRightHandedAndOrthonormalForEveryNormal) {
  std::vector<glm::vec3> normals{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {0, -1, 0}, {0, 0, -0.0f}};
  normals.back() = glm::normalize(glm::vec3(1e-20f, 1e-5f, -1.0f));
  for (int i = 0; i < 10000; ++i) normals.push_back(test::uniformSphere(randomPair(i)));
  for (int i = 0; i < 1000; ++i) {
    const glm::vec2 u = 1e-4f * randomPair(i);
    normals.push_back(glm::normalize(glm::vec3(u.x, u.y, -1.0f)));
  }
  for (const glm::vec3& n : normals) {
    const Frame f = Frame::about(n);
    EXPECT_NEAR(glm::dot(f.tangent, f.bitangent), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(f.tangent, n), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::dot(f.bitangent, n), 0.0f, 1e-6f);
    EXPECT_NEAR(glm::length(f.tangent), 1.0f, 1e-6f);
    EXPECT_NEAR(glm::distance(glm::cross(f.tangent, f.bitangent), n), 0.0f, 1e-6f);
    const glm::vec3 d(0.3f, -0.5f, 0.7f);
    const glm::vec3 w = f.toWorld(d);
    EXPECT_NEAR(glm::distance({glm::dot(w, f.tangent), glm::dot(w, f.bitangent), glm::dot(w, n)}, d), 0.0f,
                1e-6f);
    EXPECT_EQ(f.toWorld({0, 0, 1}), n);
  }
}

}  // namespace
}  // namespace isolux::gi
