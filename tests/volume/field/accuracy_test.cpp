// The accuracy that the project promises, on the CPU: hits and normals of the ball and torus phantoms at
// 128^3 against their closed forms. Each test prints its figures.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/unwatched.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_hit.h"

namespace isolux::volume {
namespace {

struct Figures {
  int hits = 0, misses = 0;
  double offSurfaceMm = 0.0;      // RMS distance of the hit from the true surface
  double offSurfaceVoxels = 0.0;  // the same in voxel coordinates, along the surface's normal there
  double alongRayMm = 0.0;        // RMS distance to the true hit
  double cubicDegrees = 0.0;      // RMS angle between the normals at the hit and at the true hit
  double interpolatingDegrees = 0.0;
};

double degreesBetween(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

// Rays from anywhere in the domain in all directions, whose true first hit lies three voxels inside it and is
// not seen at a grazing angle (there the distance along the ray says nothing about the surface).
Figures measure(const std::string& name, const GridGeometry& geometry, double isovalue = 0.0) {
  base::Progress progress;
  const Grid grid = test::phantomGrid(name, geometry);
  const MinMaxBlocks blocks(grid, 8, progress);
  const Coefficients coefficients = interpolatingCoefficients(grid);
  const auto field = test::analyticField(name, geometry);
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  const glm::dmat3 linear(voxelFromWorld);
  const glm::dvec3 last(geometry.dims - 1);
  const glm::dvec3 spacing = geometry.spacingMm();
  const double coarsest = std::max({spacing.x, spacing.y, spacing.z});
  const auto square = [](double x) { return x * x; };
  Figures sum;
  for (std::uint64_t i = 0; sum.hits < 4000 && i < 400000; ++i) {
    const auto random = [i](std::uint64_t stream) { return base::uniformNoise(stream, i); };
    const glm::dvec3 start = last * glm::dvec3(random(4), random(5), random(6));
    const glm::dvec3 o(geometry.worldFromVoxel * glm::dvec4(start, 1.0));
    const glm::dvec3 d = glm::normalize(glm::dvec3(random(1), random(2), random(3)) - 0.5);
    if (std::abs(field->at(o).value - isovalue) < 0.5 * coarsest)
      continue;  // between true and sampled surface
    const auto t = field->firstHit(o, d, isovalue);
    if (!t) continue;
    const glm::dvec3 reference = o + *t * d, truthVoxel(voxelFromWorld * glm::dvec4(reference, 1.0));
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
      inside = inside && truthVoxel[axis] > 3.0 && truthVoxel[axis] < last[axis] - 3.0;
    const glm::dvec3 normal = field->normal(reference);
    if (!inside || std::abs(glm::dot(normal, d)) < 0.1) continue;
    const auto hit = firstHit(grid, blocks, isovalue, {start, linear * d});
    if (!hit) {
      ++sum.misses;
      continue;
    }
    ++sum.hits;
    const double off = field->at(o + hit->t * d).value - isovalue;
    sum.offSurfaceMm += square(off);
    sum.offSurfaceVoxels += square(off * glm::length(linear * normal));
    sum.alongRayMm += square(hit->t - *t);
    const auto angle = [&](const FieldSample& s) {
      return square(degreesBetween(-worldGradient(geometry, s.gradient), normal));
    };
    sum.cubicDegrees += angle(sampleCubic(grid, hit->voxel));
    sum.interpolatingDegrees += angle(sampleCubic(coefficients, grid, hit->voxel));
  }
  for (double* figure : {&sum.offSurfaceMm, &sum.offSurfaceVoxels, &sum.alongRayMm, &sum.cubicDegrees,
                         &sum.interpolatingDegrees})
    *figure = std::sqrt(*figure / sum.hits);
  std::printf(
      "%-6s isovalue %6.1f: %.5f voxel and %.5f mm off the surface, %.5f mm along the ray; normals %.4f "
      "degrees "
      "cubic, %.4f interpolating (%d hits, %d missed)\n",
      name.c_str(), isovalue, sum.offSurfaceVoxels, sum.offSurfaceMm, sum.alongRayMm, sum.cubicDegrees,
      sum.interpolatingDegrees, sum.hits, sum.misses);
  return sum;
}

void expectPromised(const Figures& figures, const char* what) {
  EXPECT_GE(figures.hits, 2000) << what;
  EXPECT_EQ(figures.misses, 0) << what;
  EXPECT_LT(figures.offSurfaceVoxels, 0.01) << what;
  EXPECT_LT(figures.cubicDegrees, 0.1) << what;
  EXPECT_LT(figures.interpolatingDegrees, 0.1) << what;
}

TEST(Accuracy, BallAndTorusOfUnitSpacing) {
  expectPromised(measure("ball", test::isotropicGeometry(128)), "ball");
  expectPromised(measure("torus", test::isotropicGeometry(128)), "torus");
}

TEST(Accuracy, BallAndTorusUnderAnObliqueLeftHandedAffine) {
  expectPromised(measure("ball", test::obliqueLeftHandedGeometry(128)), "ball");
  expectPromised(measure("torus", test::obliqueLeftHandedGeometry(128)), "torus");
}

TEST(Accuracy, BallOfAnisotropicSpacing) {
  const GridGeometry geometry = test::anisotropicGeometry(128);
  // The box is 51 x 51 x 318 mm. A ball that fits into it has 17.8 mm, 7 slices: between two of them a chord
  // lies up to h^2/(8R) = 0.044 mm under the ball, which no trilinear hit can do better than. A ball of 100
  // mm (the box cuts it) is sampled well enough.
  const double radius = 0.35 * 127.0 * 0.4;
  const Figures small = measure("ball", geometry);
  EXPECT_LT(small.offSurfaceMm, 2.5 * 2.5 / (8.0 * radius));
  EXPECT_LT(small.interpolatingDegrees, 0.3);
  expectPromised(measure("ball", geometry, radius - 100.0), "ball of 100 mm");
}

TEST(Accuracy, TorusOfAnisotropicSpacingIsLimitedByItsSampling) {
  // Its tube of 6.1 mm radius has 2.4 slices: the figures are what the samples hold, not a promise.
  const Figures figures = measure("torus", test::anisotropicGeometry(128));
  EXPECT_LT(figures.offSurfaceMm, 2.5 * 2.5 / (8.0 * 0.12 * 127.0 * 0.4));
  EXPECT_LT(figures.interpolatingDegrees, figures.cubicDegrees);
}

}  // namespace
}  // namespace isolux::volume
