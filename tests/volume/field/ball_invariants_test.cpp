#include "tests/support/ball_invariants.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/analytic_fields.h"
#include "tests/support/volumes.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
#include "volume/field/scaled_field.h"
#include "volume/statistics/visible_points.h"

namespace isolux::volume {
namespace {

constexpr double kRadius = 6.0;  // of balls, voxels

std::vector<glm::dvec3> pointsOf(const Grid& grid, std::size_t wanted) {
  base::Progress progress;
  std::vector<glm::dvec3> points;
  for (const VisiblePoint& p : visiblePoints(grid, MinMaxBlocks(grid, 8, progress), 0.0, wanted))
    points.push_back(p.voxel);
  return points;
}

PrincipalCurvature curvatureAt(const ScaledField& scaled, const Grid& grid, glm::dvec3 voxel) {
  const FieldSample s = sampleScaled(scaled, grid, voxel);
  return principalCurvature(worldGradient(grid.geometry(), s.gradient),
                            worldHessian(grid.geometry(), s.hessian));
}

// The oracle itself, by closed forms.
TEST(BallInvariants, GiveTheCurvatureOfABallAndATorus) {
  const GridGeometry geometry = test::isotropicGeometry(96);
  const Grid ball = test::phantomGrid("ball", geometry);
  const double k = 1.0 / (0.35 * 95.0);
  for (const glm::dvec3& point : pointsOf(ball, 10)) {
    const test::BallCurvature found = test::ballCurvature(ball, 0.0, point, kRadius);
    EXPECT_NEAR(found.mean, k, 0.05 * k);
    EXPECT_NEAR(found.kappa1, k, 0.15 * k);
    EXPECT_NEAR(found.kappa2, k, 0.15 * k);
  }
  const Grid torus = test::phantomGrid("torus", geometry);
  const auto field = test::analyticField("torus", geometry);
  for (const glm::dvec3& point : pointsOf(torus, 10)) {
    const test::Curvature reference =
        field->curvature(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(point, 1.0)));
    const test::BallCurvature found = test::ballCurvature(torus, 0.0, point, kRadius);
    EXPECT_NEAR(found.mean, 0.5 * (reference.kappa1 + reference.kappa2), 0.1 * reference.kappa1);
    EXPECT_NEAR(found.kappa1, reference.kappa1, 0.15 * reference.kappa1);
    EXPECT_NEAR(found.kappa2, reference.kappa2, 0.15 * reference.kappa1);
  }
}

// Root mean squares of what field and oracle differ by, in parts of the largest curvature: two ways that see
// the same noise differently. At points of the noise-free surface: a ball round a displaced one would take
// the displacement for curvature.
void expectAgreement(const Grid& clean, double scaleVoxels, double curvature, double tolerance) {
  base::Progress progress;
  const Grid noisy = test::withNoise(clean, 0.3, glm::dvec3(0.0), 7);
  const ScaledField scaled =
      scaledField(noisy, scene::Field::cubic, scaleVoxels * noisy.geometry().spacingMm().x, progress);
  double mean = 0.0, kappas = 0.0;
  const std::vector<glm::dvec3> points = pointsOf(clean, 60);
  for (const glm::dvec3& point : points) {
    const PrincipalCurvature found = curvatureAt(scaled, noisy, point);
    const test::BallCurvature oracle = test::ballCurvature(noisy, 0.0, point, kRadius);
    const auto count = static_cast<double>(points.size());
    mean += std::pow(0.5 * (found.kappa1 + found.kappa2) - oracle.mean, 2) / count;
    kappas += (std::pow(found.kappa1 - oracle.kappa1, 2) + std::pow(found.kappa2 - oracle.kappa2, 2)) / count;
  }
  EXPECT_LT(std::sqrt(mean), tolerance * curvature);
  EXPECT_LT(std::sqrt(0.5 * kappas), tolerance * curvature);
}

TEST(ScaledField, AgreesWithIntegralInvariantsUnderNoise) {
  const GridGeometry geometry = test::isotropicGeometry(96);
  expectAgreement(test::phantomGrid("ball", geometry), 3.0, 1.0 / (0.35 * 95.0), 0.25);
  expectAgreement(test::phantomGrid("torus", geometry), 3.0, 1.0 / (0.12 * 95.0), 0.15);
  // An ellipsoid of half axes 30, 24, 18: its largest curvature is 30 / 18^2.
  const glm::dvec3 axes(30.0, 24.0, 18.0);
  const Grid ellipsoid = test::gridOfVoxels(geometry, [&](glm::dvec3 p) {
    const glm::dvec3 q = p - glm::dvec3(47.5);
    return (1.0 - glm::length(q / axes)) * glm::length(q / axes) / glm::length(q / axes / axes);
  });
  expectAgreement(ellipsoid, 3.0, 30.0 / (18.0 * 18.0), 0.15);
}

}  // namespace
}  // namespace isolux::volume
