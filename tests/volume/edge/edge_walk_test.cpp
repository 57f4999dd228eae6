// The walk to the edge on fields of formulas: |g| = size exp(-(x - edge)^2 / 2) along x, in voxels of 1 mm.
#include "volume/edge/edge_walk.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/invalid_operations.h"

namespace isolux::volume {
namespace {

using test::InvalidOperations;

template <class Real>
struct Hill {
  Real edge, size = 1;
  Real bent = 0;                 // curvature of its level sets, 1/mm, of both principal directions
  Real noSlopeFrom = Real(1e6);  // from this x on the field is constant
  EdgeSample<Real> operator()(const glm::vec<3, Real>& p) const {
    EdgeSample<Real> at;
    at.known = true;
    if (p.x >= noSlopeFrom) return at;
    const Real x = p.x - edge, slope = -size * std::exp(-x * x / 2);
    at.gradient.x = slope;
    at.hessian[0][0] = -x * slope;
    at.hessian[1][1] = at.hessian[2][2] = slope * bent;
    return at;
  }
};

template <class Real>
EdgeSearch<Real> searchOf(Real mm) {
  EdgeSearch<Real> search;
  search.low = glm::vec<3, Real>(0);
  search.high = glm::vec<3, Real>(20);
  search.noise = glm::mat<3, 3, Real>(Real(1e-4));
  search.searchMm = mm;
  return search;
}

// Squares of the smallest and largest of these are beyond a float.
TEST(EdgeWalk, GradientsOfAnySizeHaveALength) {
  for (const float size : {1e-30f, 1e-12f, 1.0f, 1e12f, 1e30f}) {
    EXPECT_NEAR(edge::lengthOf(glm::vec3(2.0f, -3.0f, 6.0f) * size) / (7.0f * size), 1.0f, 1e-6f) << size;
    const FoundEdge<float> found =
        findEdge(searchOf(4.0f), Hill<float>{.edge = 9.3f, .size = size}, glm::vec3(8.0f));
    ASSERT_TRUE(found.found) << size;
    EXPECT_NEAR(found.offsetMm, 1.3f, 1e-4f) << size;
    EXPECT_NEAR(found.strength / (size * std::exp(-0.5f * 1.3f * 1.3f) / 1e-2f), 1.0f, 1e-4f) << size;
  }
  EXPECT_EQ(edge::lengthOf(glm::vec3(0.0f)), 0.0f);
}

// Steps are of half a voxel.
TEST(EdgeWalk, AnEdgeWhereAStepEndsIsFound) {
  for (int halves = -6; halves <= 6; ++halves) {
    const FoundEdge<float> found =
        findEdge(searchOf(4.0f), Hill<float>{.edge = 8.0f + 0.5f * halves}, glm::vec3(8.0f));
    ASSERT_TRUE(found.found) << halves;
    EXPECT_EQ(found.offsetMm, 0.5f * halves);
  }
}

TEST(EdgeWalk, APlaceWithoutASlopeIsPassedWithoutADirection) {
  const InvalidOperations invalid;
  const FoundEdge<double> found =
      findEdge(searchOf(4.0), Hill<double>{.edge = 6.0, .noSlopeFrom = 8.4}, glm::dvec3(8.0));
  EXPECT_TRUE(found.found);
  EXPECT_NEAR(found.offsetMm, -2.0, 1e-6);
  EXPECT_FALSE(invalid.met());
}

TEST(EdgeWalk, AHitWithoutASlopeHasNoEdgeAndNoStrength) {
  const InvalidOperations invalid;
  const FoundEdge<double> found =
      findEdge(searchOf(4.0), Hill<double>{.edge = 6.0, .noSlopeFrom = 7.0}, glm::dvec3(8.0));
  EXPECT_FALSE(found.found);
  EXPECT_EQ(found.strength, 0.0);
  EXPECT_FALSE(invalid.met());
}

// Noise of a gradient that cannot point along some directions: the form is 0 there, and by rounding less.
TEST(EdgeWalk, NoiseIsNeverTheRootOfLessThanNothing) {
  EdgeSearch<float> search;
  const glm::vec3 v = glm::normalize(glm::vec3(1.0f, 2.3f, -0.7f));
  search.noise = glm::outerProduct(v, v);
  for (int i = 0; i < 500; ++i) {
    const float angle = 0.0126f * static_cast<float>(i);
    const glm::vec3 a = glm::normalize(glm::cross(v, glm::vec3(0.0f, 0.0f, 1.0f))), b = glm::cross(v, a);
    const float noise = gradientNoise(search, std::cos(angle) * a + std::sin(angle) * b);
    EXPECT_GE(noise, 0.0f);
    EXPECT_LT(noise, 1e-3f);
  }
}

TEST(EdgeWalk, NothingIsLookedForOutsideTheField) {
  EdgeSearch<double> search = searchOf(6.0);
  search.high.x = 10.0;
  EXPECT_TRUE(findEdge(search, Hill<double>{.edge = 9.0}, glm::dvec3(8.0)).found);
  EXPECT_FALSE(findEdge(search, Hill<double>{.edge = 11.0}, glm::dvec3(8.0)).found);
  search.high.x = 20.0;
  EXPECT_TRUE(findEdge(search, Hill<double>{.edge = 11.0}, glm::dvec3(8.0)).found);
}

// A ball of radius R smoothed by s has its edge s^2 / R further in; of a radius below 2 s, half of s is taken
// back.
TEST(EdgeWalk, WhatCurvatureMovedIsTakenBackUpToHalfTheSmoothing) {
  EdgeSearch<double> search = searchOf(4.0);
  for (const double s : {0.5, 1.5})
    for (const double curvature : {0.02, -0.1, 1e3, -1e3}) {
      search.smoothing = glm::dmat3(s * s);
      const FoundEdge<double> found =
          findEdge(search, Hill<double>{.edge = 9.0, .bent = curvature}, glm::dvec3(8.0));
      ASSERT_TRUE(found.found);
      EXPECT_NEAR(found.offsetMm - 1.0, std::clamp(curvature * s * s, -0.5 * s, 0.5 * s), 1e-6)
          << s << ' ' << curvature;
    }
}

}  // namespace
}  // namespace isolux::volume
