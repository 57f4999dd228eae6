#include "gi/harmonics/sh_rotation.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "gi/sampling/directions.h"
#include "tests/support/spherical_functions.h"

namespace isolux::gi {
namespace {

using std::numbers::pi;

glm::dvec3 randomDirection(std::uint32_t i) {
  return glm::normalize(glm::dvec3(test::uniformSphere(samplePair(DirectionSequence::random, 5, i, 0))));
}

glm::dmat3 turn(double angle, glm::dvec3 axis) {
  return glm::mat3_cast(glm::angleAxis(angle, axis));
}

glm::dmat3 randomRotation(std::uint32_t i) {
  return turn(2 * pi * sampleOne(DirectionSequence::random, 5, i, 1), randomDirection(i));
}

std::vector<double> someCoefficients(int order) {
  std::vector<double> c(shTerms(order));
  for (std::size_t i = 0; i < c.size(); ++i) c[i] = std::sin(2.0 + 1.7 * static_cast<double>(i * i));
  return c;
}

// A function without symmetry and with every band: exp(a . d) (1 + b . d).
double someFunction(glm::dvec3 d) {
  return std::exp(glm::dot(glm::dvec3(0.4, -1.1, 0.8), d)) * (1 + glm::dot(glm::dvec3(0.3, 0.2, -0.9), d));
}

void expectRotationOf(const glm::dmat3& rotation, double tolerance) {
  for (const int order : {1, 2, 3, 5, maxShOrder}) {
    const auto projected = test::projectSh(order, someFunction, 60);
    const auto expected = test::projectSh(
        order, [&](glm::dvec3 d) { return someFunction(glm::transpose(rotation) * d); }, 60);
    const auto turned = test::turned(ShRotation(order, rotation), projected);
    for (std::size_t i = 0; i < turned.size(); ++i)
      ASSERT_NEAR(turned[i], expected[i], tolerance) << "order " << order << " term " << i;
  }
}

TEST(ShRotation, EqualsTheProjectionOfTheRotatedFunction) {
  for (std::uint32_t i = 0; i < 40; ++i) expectRotationOf(randomRotation(i), 1e-12);
}

TEST(ShRotation, EqualsItAtHalfTurnsAndQuarterTurnsAboutEveryAxis) {
  std::vector<glm::dvec3> axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, -1}, {0, 1, 1}, {1, 1, 1}};
  for (std::uint32_t i = 0; i < 10; ++i) axes.push_back(randomDirection(i));
  for (const glm::dvec3& axis : axes)
    for (const double angle : {pi, -pi, pi / 2, -pi / 2, 2 * pi, 1e-9})
      expectRotationOf(turn(angle, glm::normalize(axis)), 1e-12);
}

TEST(ShRotation, OfTheIdentityChangesNothing) {
  const ShRotation identity(maxShOrder, glm::dmat3(1.0));
  const auto in = someCoefficients(maxShOrder);
  const auto out = test::turned(identity, in);
  for (std::size_t i = 0; i < in.size(); ++i) EXPECT_NEAR(out[i], in[i], 1e-15);
}

TEST(ShRotation, MatricesAreOrthogonalAndComposeAsRotationsDo) {
  for (std::uint32_t i = 0; i < 20; ++i) {
    const glm::dmat3 a = randomRotation(i), b = randomRotation(i + 100);
    const ShRotation first(maxShOrder, a), second(maxShOrder, b), both(maxShOrder, b * a);
    for (int l = 0; l < maxShOrder; ++l)
      for (int s = -l; s <= l; ++s)
        for (int t = -l; t <= l; ++t) {
          double product = 0, gram = 0;
          for (int k = -l; k <= l; ++k) {
            product += second.element(l, s, k) * first.element(l, k, t);
            gram += first.element(l, s, k) * first.element(l, t, k);
          }
          EXPECT_NEAR(product, both.element(l, s, t), 1e-12);
          EXPECT_NEAR(gram, s == t ? 1.0 : 0.0, 1e-12);
        }
  }
}

// The coefficients turned a thousand times, and those turned once by the product of the thousand matrices,
// are those of the function turned as the product of quaternions says.
TEST(ShRotation, ThousandComposedRotationsStayExact) {
  const auto start = test::projectSh(maxShOrder, someFunction, 60);
  std::vector<double> stepped = start;
  glm::dmat3 product(1.0);
  glm::dquat exact(1, 0, 0, 0);
  for (std::uint32_t i = 0; i < 1000; ++i) {
    const glm::dquat step =
        glm::angleAxis(2 * pi * sampleOne(DirectionSequence::random, 8, i, 0), randomDirection(i));
    const glm::dmat3 rotation = glm::mat3_cast(step);
    stepped = test::turned(ShRotation(maxShOrder, rotation), stepped);
    product = rotation * product;
    exact = glm::normalize(step * exact);
  }
  const auto once = test::turned(ShRotation(maxShOrder, product), start);
  const glm::dmat3 inverse = glm::transpose(glm::mat3_cast(exact));
  const auto expected = test::projectSh(
      maxShOrder, [&](glm::dvec3 d) { return someFunction(inverse * d); }, 60);
  for (std::size_t i = 0; i < start.size(); ++i) {
    EXPECT_NEAR(stepped[i], expected[i], 1e-10);
    EXPECT_NEAR(once[i], expected[i], 1e-10);
  }
}

TEST(ShRotation, TurnsColorsAsItTurnsNumbers) {
  const ShRotation rotation(5, randomRotation(1));
  const auto in = someCoefficients(5);
  const auto out = test::turned(rotation, in);
  std::vector<glm::dvec3> color(in.size());
  for (std::size_t i = 0; i < in.size(); ++i) color[i] = in[i] * glm::dvec3(1, -2, 0.5);
  rotation.apply(color, color);
  for (std::size_t i = 0; i < in.size(); ++i)
    EXPECT_NEAR(glm::distance(color[i], out[i] * glm::dvec3(1, -2, 0.5)), 0.0, 1e-14);
}

// A matrix that came through float is not quite orthonormal: the result is a rotation nevertheless.
TEST(ShRotation, RoundedMatricesGiveOrthogonalOnes) {
  const ShRotation rotation(maxShOrder, glm::dmat3(glm::mat3(randomRotation(4))));
  for (int l = 0; l < maxShOrder; ++l)
    for (int s = -l; s <= l; ++s) {
      double norm = 0;
      for (int t = -l; t <= l; ++t) norm += rotation.element(l, s, t) * rotation.element(l, s, t);
      EXPECT_NEAR(norm, 1.0, 1e-12);
    }
}

}  // namespace
}  // namespace isolux::gi
