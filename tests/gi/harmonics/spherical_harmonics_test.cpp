#include "gi/harmonics/spherical_harmonics.h"

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "gi/sampling/directions.h"
#include "tests/support/spherical_functions.h"
#include "tests/support/statistics.h"

namespace isolux::gi {
namespace {

using std::numbers::pi;
constexpr int allTerms = shTerms(maxShOrder);

glm::dvec3 sphereDirection(std::uint32_t i) {
  return glm::normalize(glm::dvec3(test::uniformSphere(samplePair(DirectionSequence::random, 3, i, 0))));
}

TEST(GaussLegendre, IsExactForPolynomials) {
  for (const int count : {1, 2, 3, 8, 24, 64}) {
    const GaussLegendre rule(count);
    for (int power = 0; power < 2 * count; ++power) {
      double sum = 0;
      for (int i = 0; i < count; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], power);
      EXPECT_NEAR(sum, power % 2 == 0 ? 2.0 / (power + 1) : 0.0, 1e-13) << count << " " << power;
    }
  }
}

// The functions as polynomials, from tables of the literature (Ramamoorthi & Hanrahan 2001 eq. 3; the bands
// after them from the definition with the Legendre functions of the standard library).
TEST(SphericalHarmonics, AreThoseOfEquation12) {
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 d = i == 0   ? glm::dvec3(0, 0, 1)
                         : i == 1 ? glm::dvec3(0, 0, -1)
                         : i == 2 ? glm::dvec3(-1, 0, 0)
                                  : sphereDirection(i);
    std::array<double, allTerms> y;
    evaluateSh(maxShOrder, d, y.data());
    EXPECT_NEAR(y[0], 0.282095, 1e-6);
    EXPECT_NEAR(y[1], 0.488603 * d.y, 1e-6);
    EXPECT_NEAR(y[2], 0.488603 * d.z, 1e-6);
    EXPECT_NEAR(y[3], 0.488603 * d.x, 1e-6);
    EXPECT_NEAR(y[4], 1.092548 * d.x * d.y, 1e-6);
    EXPECT_NEAR(y[5], 1.092548 * d.y * d.z, 1e-6);
    EXPECT_NEAR(y[6], 0.315392 * (3 * d.z * d.z - 1), 1e-6);
    EXPECT_NEAR(y[7], 1.092548 * d.x * d.z, 1e-6);
    EXPECT_NEAR(y[8], 0.546274 * (d.x * d.x - d.y * d.y), 1e-6);
    const double phi = std::atan2(d.y, d.x);
    for (int l = 0; l < maxShOrder; ++l)
      for (int m = -l; m <= l; ++m) {
        const unsigned a = std::abs(m);
        const double n = std::sqrt((2 * l + 1) / (4 * pi) * std::tgamma(l - static_cast<int>(a) + 1) /
                                   std::tgamma(l + static_cast<int>(a) + 1));
        // std::assoc_legendre has no Condon-Shortley factor.
        const double p = std::assoc_legendre(static_cast<unsigned>(l), a, d.z);
        const double expected = n * p *
                                (m > 0   ? std::sqrt(2.0) * std::cos(m * phi)
                                 : m < 0 ? std::sqrt(2.0) * std::sin(a * phi)
                                         : 1.0);
        EXPECT_NEAR(y[l * (l + 1) + m], expected, 1e-12) << l << " " << m;
      }
  }
}

// The integral of x^a y^b z^c over the sphere is 4 pi (a-1)!! (b-1)!! (c-1)!! / (a+b+c+1)!!, of odd powers 0.
TEST(SphereQuadrature, IsExactForMonomialsOfItsDegree) {
  const auto odd = [](int n) {  // n!!
    double product = 1.0;
    for (; n > 1; n -= 2) product *= n;
    return product;
  };
  for (int degree = 0; degree <= 15; ++degree) {
    const test::SphereQuadrature quadrature(degree);
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; a + b <= degree; ++b)
        for (int c = 0; a + b + c <= degree; ++c) {
          double sum = 0.0;
          for (const auto& [direction, weight] : quadrature.points())
            sum += weight * std::pow(direction.x, a) * std::pow(direction.y, b) * std::pow(direction.z, c);
          const bool isOdd = a % 2 == 1 || b % 2 == 1 || c % 2 == 1;
          const double expected =
              isOdd ? 0.0 : 4 * pi * odd(a - 1) * odd(b - 1) * odd(c - 1) / odd(a + b + c + 1);
          ASSERT_NEAR(sum, expected, 1e-13) << degree << ": " << a << ' ' << b << ' ' << c;
        }
  }
}

TEST(SphericalHarmonics, AreOrthonormalToOrder8) {
  const test::SphereQuadrature quadrature(2 * (maxShOrder - 1));  // the degree of their products
  std::vector<double> gram(allTerms * allTerms, 0.0);
  double area = 0;
  for (const auto& [direction, weight] : quadrature.points()) {
    std::array<double, allTerms> y;
    evaluateSh(maxShOrder, direction, y.data());
    area += weight;
    for (int i = 0; i < allTerms; ++i)
      for (int j = 0; j < allTerms; ++j) gram[i * allTerms + j] += weight * y[i] * y[j];
  }
  EXPECT_NEAR(area, 4 * pi, 1e-12);
  for (int i = 0; i < allTerms; ++i)
    for (int j = 0; j < allTerms; ++j) EXPECT_NEAR(gram[i * allTerms + j], i == j ? 1.0 : 0.0, 1e-12);
}

TEST(SphericalHarmonics, EveryOrderIsABeginningOfTheNextAndFloatFollowsDouble) {
  for (int i = 0; i < 500; ++i) {
    const glm::dvec3 d = sphereDirection(i);
    std::array<double, allTerms> all;
    evaluateSh(maxShOrder, d, all.data());
    for (int order = 1; order <= maxShOrder; ++order) {
      std::array<double, allTerms + 1> some;
      std::array<float, allTerms + 1> single;
      some.fill(777.0);
      single.fill(777.0f);
      evaluateSh(order, d, some.data());
      evaluateSh(order, glm::vec3(d), single.data());
      for (int k = 0; k < shTerms(order); ++k) {
        EXPECT_NEAR(some[k], all[k], 1e-15);
        // A float direction is off by 6e-8; the steepest of these functions grows by less than 20 a radian.
        EXPECT_NEAR(single[k], all[k], 4e-6);
      }
      EXPECT_EQ(some[shTerms(order)], 777.0);  // nothing is written past the end
      EXPECT_EQ(single[shTerms(order)], 777.0f);
    }
  }
}

TEST(SphericalHarmonics, ProjectionReturnsTheCoefficientsOfABandLimitedFunction) {
  std::vector<double> coefficients(allTerms);
  for (int i = 0; i < allTerms; ++i) coefficients[i] = std::sin(1.0 + i);
  const auto projected = test::projectSh(
      maxShOrder, [&](glm::dvec3 d) { return test::reconstructSh(maxShOrder, coefficients, d); }, 14);
  for (int i = 0; i < allTerms; ++i) EXPECT_NEAR(projected[i], coefficients[i], 1e-12);
}

TEST(SphericalHarmonics, DotIsTheIntegralOfTheProduct) {
  for (const int order : {1, 3, 5, 8}) {
    std::vector<double> a(shTerms(order)), b(shTerms(order));
    for (int i = 0; i < shTerms(order); ++i) {
      a[i] = std::cos(3.0 * i);
      b[i] = std::sin(1.0 + i * i);
    }
    const test::SphereQuadrature quadrature(2 * (order - 1));
    double integral = 0;
    for (const auto& [direction, weight] : quadrature.points())
      integral +=
          weight * test::reconstructSh(order, a, direction) * test::reconstructSh(order, b, direction);
    EXPECT_NEAR(std::inner_product(a.begin(), a.end(), b.begin(), 0.0), integral, 1e-11);
  }
}

TEST(ClampedCosine, IsTheIntegralWithTheLegendrePolynomial) {
  const GaussLegendre rule(32);  // over cos in (0, 1): polynomials
  for (int l = 0; l < 20; ++l) {
    double integral = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double z = 0.5 + 0.5 * rule.nodes[i];
      integral += 0.5 * rule.weights[i] * 2 * pi * z * std::legendre(static_cast<unsigned>(l), z);
    }
    EXPECT_NEAR(clampedCosine(l), integral, 1e-12) << l;
  }
  EXPECT_NEAR(clampedCosine(2), pi / 4, 1e-15);
  EXPECT_NEAR(clampedCosine(4), -pi / 24, 1e-15);
}

TEST(CosineLobe, IsTheProjectionOfTheClampedCosine) {
  std::array<double, allTerms> up;
  evaluateSh(maxShOrder, glm::dvec3(0, 0, 1), up.data());
  // The integrand has a kink at z = 0: the halves are integrated each by itself.
  const GaussLegendre rule(32);
  for (int l = 0; l < maxShOrder; ++l) {
    double integral = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
      const double z = 0.5 + 0.5 * rule.nodes[i];
      std::array<double, allTerms> y;
      evaluateSh(maxShOrder, glm::dvec3(std::sqrt(1 - z * z), 0, z), y.data());
      integral += 0.5 * rule.weights[i] * 2 * pi * z * y[l * (l + 1)];
    }
    EXPECT_NEAR(clampedCosine(l) * up[l * (l + 1)], integral, 1e-12);
    for (int m = 1; m <= l; ++m) {
      EXPECT_NEAR(up[l * (l + 1) + m], 0.0, 1e-12);
      EXPECT_NEAR(up[l * (l + 1) - m], 0.0, 1e-12);
    }
  }
}

TEST(Irradiance, OfAConstantSkyIsPi) {
  for (int order = 1; order <= maxShOrder; ++order) {
    const auto sky = test::projectSh(order, [](glm::dvec3) { return 1.0; });
    for (int i = 0; i < 100; ++i) EXPECT_NEAR(test::irradianceSh(order, sky, sphereDirection(i)), pi, 1e-12);
  }
}

// Radiance 1 above the plane through the origin, 0 below: E = pi (1 + cos) / 2. Above band 1 the odd bands
// meet clampedCosine = 0, and the even bands of the half sky are 0: the result is exact from order 2 on.
TEST(Irradiance, OfAHalfBrightSkyIsExact) {
  const glm::dvec3 up = glm::normalize(glm::dvec3(1, -2, 0.5));
  for (int order = 2; order <= maxShOrder; ++order) {
    std::vector<double> sky(shTerms(order), 0.0);
    const GaussLegendre rule(32);
    std::array<double, allTerms> y;
    evaluateSh(order, up, y.data());
    for (int l = 0; l < order; ++l) {
      double zonal = 0;  // of the half sky about its own axis
      for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        zonal += 0.5 * rule.weights[i] * 2 * pi *
                 std::legendre(static_cast<unsigned>(l), 0.5 + 0.5 * rule.nodes[i]);
      for (int i = l * l; i < (l + 1) * (l + 1); ++i) sky[i] = zonal * y[i];
    }
    std::vector<glm::dvec3> color(sky.size());
    for (std::size_t i = 0; i < sky.size(); ++i) color[i] = sky[i] * glm::dvec3(1, 10, 0);
    for (int i = 0; i < 100; ++i) {
      const glm::dvec3 normal = sphereDirection(i);
      const double expected = pi * (1 + glm::dot(up, normal)) / 2;
      EXPECT_NEAR(test::irradianceSh(order, sky, normal), expected, 1e-12);
      EXPECT_NEAR(test::irradianceSh(order, color, normal).g, 10 * expected, 1e-11);
    }
  }
}

TEST(Window, LeavesEverythingAtZeroAndFallsMonotonically) {
  for (int order = 1; order <= maxShOrder; ++order) {
    for (int l = 0; l < order; ++l) EXPECT_EQ(shWindow(order, 0.0, l), 1.0);
    for (const double strength : {0.1, 0.5, 1.0}) {
      EXPECT_EQ(shWindow(order, strength, 0), 1.0);  // the mean stays
      for (int l = 1; l < order; ++l) {
        EXPECT_LT(shWindow(order, strength, l), shWindow(order, strength, l - 1));
        EXPECT_GT(shWindow(order, strength, l), 0.0);
        EXPECT_LT(shWindow(order, strength, l), shWindow(order, 0.5 * strength, l));
      }
    }
    EXPECT_NEAR(shWindow(order, 1.0, order), 0.0, 1e-15);
  }
  std::vector<glm::dvec3> color(25, glm::dvec3(1, 2, 3));
  windowSh(5, 0.7, color);
  for (int l = 0; l < 5; ++l)
    for (int m = -l; m <= l; ++m)
      EXPECT_EQ(color[l * (l + 1) + m], shWindow(5, 0.7, l) * glm::dvec3(1, 2, 3));
}

// What the header says of one light in one direction at order 5.
TEST(Window, UndershootOfALightIsAsDocumented) {
  const auto undershoot = [](double strength, bool ofIrradiance) {
    std::array<double, 25> y;
    evaluateSh(5, glm::dvec3(0, 0, 1), y.data());
    std::vector<glm::dvec3> light(y.begin(), y.end());
    windowSh(5, strength, light);
    double lowest = 0, highest = 0;
    for (int i = 0; i <= 1000; ++i) {
      const glm::dvec3 d(std::sin(pi * i / 1000), 0, std::cos(pi * i / 1000));
      const double value =
          (ofIrradiance ? test::irradianceSh(5, light, d) : test::reconstructSh(5, light, d)).x;
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    return -lowest / highest;
  };
  EXPECT_NEAR(undershoot(0.0, false), 0.15, 0.005);
  EXPECT_NEAR(undershoot(1.0, false), 0.06, 0.005);
  EXPECT_NEAR(undershoot(0.0, true), 0.032, 0.0005);
  EXPECT_NEAR(undershoot(1.0, true), 0.014, 0.0005);
}

}  // namespace
}  // namespace isolux::gi
