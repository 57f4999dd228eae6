#include "volume/statistics/scale_ladder.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"
#include "volume/field/reconstruct.h"
#include "volume/field/scaled_field.h"

namespace isolux::volume {
namespace {

std::vector<glm::dvec3> pointsIn(glm::ivec3 dims, double margin, std::size_t count) {
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 part;
    for (int axis = 0; axis < 3; ++axis)
      part[axis] = base::uniformNoise(static_cast<std::uint64_t>(7 + axis), i);
    points.push_back(glm::dvec3(margin) + part * (glm::dvec3(dims - 1) - 2.0 * margin));
  }
  return points;
}

double largest(const glm::dmat3& m) {
  double most = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(m[i][j]));
  return most;
}

TEST(PointsAtScale, AreTheSplineAtScaleZero) {
  const Grid head = test::phantomGrid("head", 48);
  const auto points = pointsIn(head.dims(), 2.0, 50);
  const auto found = derivativesAtScale(head, points, 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const FieldSample s = sampleCubic(head, points[i]);
    const glm::dvec3 gradient = worldGradient(head.geometry(), s.gradient);
    EXPECT_LT(glm::length(found[i].gradient - gradient), 1e-9 * (1.0 + glm::length(gradient)));
    const glm::dmat3 hessian = worldHessian(head.geometry(), s.hessian);
    EXPECT_LT(largest(found[i].hessian - hessian), 1e-9 * (1.0 + largest(hessian)));
  }
}

// The field that pictures are drawn with, but for the splines: a tenth at 1 voxel, less at larger scales.
TEST(PointsAtScale, AgreeWithTheScaledField) {
  for (const GridGeometry& geometry : {test::isotropicGeometry(40), test::obliqueLeftHandedGeometry(40)}) {
    const Grid grid = test::withNoise(test::phantomGrid("torus", geometry), 0.5, glm::dvec3(0.0), 3);
    const glm::dvec3 spacing = geometry.spacingMm();
    const double most = std::max({spacing.x, spacing.y, spacing.z});
    for (const double voxels : {1.0, 2.0, 3.0}) {
      base::Progress progress;
      const ScaledField scaled = scaledField(grid, scene::Field::cubic, voxels * most, progress);
      for (const double margin : {0.0, 8.0}) {  // the border, too
        const auto points = pointsIn(grid.dims(), margin, 60);
        const auto found = derivativesAtScale(grid, points, voxels * most);
        double error = 0.0, size = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
          const FieldSample s = sampleScaled(scaled, grid, points[i]);
          const glm::dmat3 hessian = worldHessian(geometry, s.hessian);
          error += std::pow(largest(found[i].hessian - hessian), 2);
          size += std::pow(largest(hessian), 2);
        }
        EXPECT_LT(std::sqrt(error / size), voxels < 1.5 ? 0.12 : 0.03) << voxels << ' ' << margin;
      }
    }
  }
}

TEST(PointsAtScale, NoiseIsWhatIsPredicted) {
  for (const glm::dvec3& blur : {glm::dvec3(0.0), glm::dvec3(1.0), glm::dvec3(0.0, 0.0, 1.0)}) {
    const glm::ivec3 dims(64);
    const Grid noise(test::unitGeometry(dims), test::blurredNoise(dims, blur, 11));
    const auto points = pointsIn(dims, 10.0, 3000);
    for (const double scale : {0.0, 0.7071, 1.0, 2.0}) {
      double gradient = 0.0, pure = 0.0;
      for (const PointDerivatives& d : derivativesAtScale(noise, points, scale)) {
        gradient += glm::dot(d.gradient, d.gradient) / 3.0 / static_cast<double>(points.size());
        // Mean over directions of the squared normal second derivative: 1/5, 1/15 as in curvature.cpp.
        const glm::dmat3& h = d.hessian;
        const double trace = h[0][0] + h[1][1] + h[2][2];
        double squares = 0.0;
        for (int i = 0; i < 3; ++i) squares += glm::dot(h[i], h[i]);
        pure += (trace * trace + 2.0 * squares) / 15.0 / static_cast<double>(points.size());
      }
      const PointNoise expected =
          pointNoise(noise.geometry(), smoothingAtScale(noise.geometry(), scale), blur);
      EXPECT_NEAR(gradient, expected.gradient, 0.2 * expected.gradient) << scale << ' ' << blur.x << blur.z;
      EXPECT_NEAR(pure, expected.hessian, 0.2 * expected.hessian) << scale << ' ' << blur.x << blur.z;
    }
  }
}

TEST(ScaleErrors, BalanceNoiseAndWhatIsLost) {
  // Noise falls with the fourth power of the scale, shape is lost with it; scales 1, 2, 4, 8.
  std::vector<ScaleStep> steps;
  const double noise = 0.3;
  for (const double scale : {1.0, 2.0, 4.0, 8.0}) {
    const double next = 2.0 * scale, ofNoise = std::pow(scale, -4.0) - std::pow(next, -4.0);
    steps.push_back({std::pow(scale, -4.0), noise * ofNoise + 1e-3 * scale, ofNoise});
  }
  const ScaleErrors errors = scaleErrors(steps, noise);
  EXPECT_EQ(errors.best, 2u);         // 0.3 / 256 + 3e-3
  EXPECT_GT(errors.lost[2], 1.5e-3);  // 3e-3, of which noise hides a part
  EXPECT_LT(errors.lost[2], 4.5e-3);
  EXPECT_NEAR(errors.noise[2], noise / 256.0, 1e-12);
  EXPECT_EQ(scaleErrors(steps, 0.0).best, 0u);
}

TEST(ScaleErrors, TheSurfaceTellsOfItsNoise) {
  const auto stepsOf = [](double noise, double shape) {
    std::vector<ScaleStep> steps;
    double ofNoise = 1.0;
    for (int i = 0; i < 6; ++i, ofNoise *= 0.2) steps.push_back({ofNoise, noise * ofNoise + shape, ofNoise});
    return steps;
  };
  EXPECT_DOUBLE_EQ(surfaceNoise(stepsOf(1.0, 0.0), 1.0), 1.0);
  EXPECT_NEAR(surfaceNoise(stepsOf(0.01, 0.0), 1.0), 0.01, 1e-9);  // no more than it shows
  EXPECT_NEAR(surfaceNoise(stepsOf(4.0, 1e-6), 1.0), 4.0, 0.1);    // rougher than its voxels
  EXPECT_DOUBLE_EQ(surfaceNoise(stepsOf(0.0, 1.0), 1e-3), 1e-3);   // shape alone is no noise
}

}  // namespace
}  // namespace isolux::volume
