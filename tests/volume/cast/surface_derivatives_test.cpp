// Every test runs on every target of this machine, against reconstruct.h in double precision.
#include "volume/cast/surface_derivatives.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/random.h"
#include "tests/support/unwatched.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {
namespace {

std::vector<TracerTarget> vectorTargets() {
  std::vector<TracerTarget> list = IsosurfaceTracer::availableTargets();
  std::erase(list, TracerTarget::scalar);
  return list;
}

GridGeometry obliqueGeometry(glm::ivec3 dims) {
  GridGeometry geometry = GridGeometry::make(dims, {0.7, 1.3, 2.1}, {3.0, -4.0, 5.0});
  geometry.worldFromVoxel[1][0] = 0.3;
  geometry.worldFromVoxel[2][1] = -0.4;
  return geometry;
}

double smooth(glm::dvec3 p) {
  return std::sin(0.31 * p.x) * std::cos(0.27 * p.y) + 0.02 * p.z * p.x + std::cos(0.4 * p.z);
}

struct Images {
  explicit Images(std::size_t count) : gradient(count), diagonal(count), mixed(count) {}
  std::vector<glm::vec4> gradient, diagonal, mixed;
};

// Points all over the volume, at its border, on voxels, and some that are none.
std::vector<glm::vec4> pointsIn(glm::ivec3 dims) {
  std::vector<glm::vec4> points;
  for (std::uint64_t i = 0; i < 600; ++i) {
    glm::vec4 p(base::uniformNoise(1, i), base::uniformNoise(2, i), base::uniformNoise(3, i), 1.0);
    p *= glm::vec4(glm::vec3(dims - 1), 1.0f);
    if (i % 5 == 0) p = glm::floor(p);
    if (i % 7 == 0) p.x = i % 2 ? 0.0f : static_cast<float>(dims.x - 1);
    if (i % 11 == 0) p.w = -1.0f;
    points.push_back(p);
  }
  return points;
}

// As an image of one row.
PictureArea all(const std::vector<glm::vec4>& points) {
  return PictureArea::whole({static_cast<int>(points.size()), 1});
}

// derive(points, images, target) against reference(position); `reach`: taps before and behind a cell that are
// samples, 0: what lies beyond is as good.
template <class Derive, class Reference>
void expectDerivatives(const Grid& grid, const Derive& derive, const Reference& reference, int reach,
                       double gradientError, double hessianError) {
  const std::vector<glm::vec4> points = pointsIn(grid.dims());
  for (const TracerTarget target : vectorTargets()) {
    Images images(points.size()), alone(points.size());
    derive(points, DerivativeImages{images.gradient, images.diagonal, images.mixed}, target);
    derive(points, DerivativeImages{alone.gradient, {}, {}}, target);
    double largest = 0.0, largestHessian = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(images.gradient[i].w, points[i].w < 0.0f ? 0.0f : 1.0f);
      if (points[i].w < 0.0f) continue;
      const FieldSample s = reference(glm::dvec3(points[i]));
      const glm::dvec3 g = worldGradient(grid.geometry(), s.gradient);
      const glm::dmat3 h = worldHessian(grid.geometry(), s.hessian);
      largest = std::max(largest, glm::distance(glm::dvec3(images.gradient[i]), g));
      largest = std::max(largest, glm::distance(glm::dvec3(alone.gradient[i]), g));
      const glm::dvec3 diagonal(h[0][0], h[1][1], h[2][2]), mixed(h[0][1], h[0][2], h[1][2]);
      largestHessian = std::max({largestHessian, glm::distance(glm::dvec3(images.diagonal[i]), diagonal),
                                 glm::distance(glm::dvec3(images.mixed[i]), mixed)});
      EXPECT_EQ(images.diagonal[i].w, 1.0f);
      const glm::vec3 cell = glm::min(glm::floor(glm::vec3(points[i])), glm::vec3(grid.dims() - 2)),
                      last(grid.dims() - 1);
      const auto beyond = static_cast<float>(reach);
      const bool within =
          reach == 0 || (glm::all(glm::greaterThanEqual(cell - (beyond - 1.0f), glm::vec3(0.0f))) &&
                         glm::all(glm::lessThanEqual(cell + beyond, last)));
      EXPECT_EQ(images.mixed[i].w, within ? 1.0f : 0.0f)
          << points[i].x << ' ' << points[i].y << ' ' << points[i].z;
    }
    EXPECT_LT(largest, gradientError);
    EXPECT_LT(largestHessian, hessianError);
  }
}

void expectReference(const Grid& grid, const DerivedField& field, double gradientError, double hessianError) {
  expectDerivatives(
      grid,
      [&](const std::vector<glm::vec4>& points, const DerivativeImages& images, TracerTarget target) {
        surfaceDerivatives(grid, field, points, all(points), images, target);
      },
      [&](glm::dvec3 p) {
        return field.trilinear      ? sampleTrilinear(grid, p)
               : field.coefficients ? sampleCubic(*field.coefficients, grid, p)
                                    : sampleCubic(grid, p);
      },
      field.trilinear ? 0 : 2, gradientError, hessianError);
}

void expectScaledReference(const Grid& grid, double scaleMm, double gradientError, double hessianError) {
  base::Progress progress;
  const ScaledField scaled = scaledField(grid, scene::Field::cubic_interpolating, scaleMm, progress);
  expectDerivatives(
      grid,
      [&](const std::vector<glm::vec4>& points, const DerivativeImages& images, TracerTarget target) {
        surfaceDerivatives(grid, {.scaled = &scaled}, points, all(points), images, target);
      },
      [&](glm::dvec3 p) { return sampleScaled(scaled, grid, p); }, 0, gradientError, hessianError);
}

TEST(SurfaceDerivatives, AreThoseOfTheFields) {
  const Grid grid = test::gridOfVoxels(obliqueGeometry({23, 19, 21}), smooth);
  const Coefficients coefficients = interpolatingCoefficients(grid);
  expectReference(grid, {}, 2e-6, 2e-6);
  expectReference(grid, {&coefficients}, 2e-6, 2e-6);
  expectReference(grid, {.trilinear = true}, 2e-6, 2e-6);
}

TEST(SurfaceDerivatives, AtAScaleAreThoseOfTheFieldAtThatScale) {
  expectScaledReference(test::gridOfVoxels(obliqueGeometry({23, 19, 21}), smooth), 0.9, 2e-6, 2e-6);
  expectScaledReference(test::gridOfVoxels(obliqueGeometry({23, 19, 21}), smooth), 0.1, 2e-6, 2e-6);
  expectScaledReference(
      test::gridOfVoxels(obliqueGeometry({16, 16, 16}),
                         [](glm::dvec3 p) { return 1e6 + std::round(16.0 * smooth(p)) / 16.0; }),
      1.0, 1e-5, 1e-5);
}

TEST(SurfaceDerivatives, AtAScaleManageAxesShorterThanTheSpline) {
  for (const glm::ivec3& dims : {glm::ivec3(1, 2, 3), glm::ivec3(4, 5, 6), glm::ivec3(7, 1, 4),
                                 glm::ivec3(2, 7, 1), glm::ivec3(8, 3, 5), glm::ivec3(1, 1, 1)})
    expectScaledReference(test::gridOfVoxels(obliqueGeometry(dims), smooth), 0.8, 2e-6, 2e-6);
}

TEST(SurfaceDerivatives, ReadEveryTypeOfVoxels) {
  const glm::ivec3 dims(14, 13, 12);
  const auto grid = [&]<class T>(T, double factor) {
    std::vector<T> voxels;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x)
          voxels.push_back(static_cast<T>(std::lround(factor * (smooth({x, y, z}) + 2.0))));
    return Grid(obliqueGeometry(dims), VoxelArray(std::move(voxels)), 0.25, 7.0);
  };
  const auto expectAll = [](const Grid& of, double error) {
    expectReference(of, {}, error, error);
    expectReference(of, {.trilinear = true}, error, error);
  };
  expectAll(grid(std::int8_t{}, 15.0), 2e-5);
  expectAll(grid(std::uint8_t{}, 30.0), 2e-5);
  expectAll(grid(std::int16_t{}, 4000.0), 3e-3);
  expectAll(grid(std::uint16_t{}, 9000.0), 6e-3);
}

TEST(SurfaceDerivatives, LoseNothingOfValuesLikeAMillionAndSome) {
  const Grid near = test::gridOfVoxels(
      obliqueGeometry({16, 16, 16}), [](glm::dvec3 p) { return 1e6 + std::round(16.0 * smooth(p)) / 16.0; });
  expectReference(near, {}, 1e-5, 1e-5);
  expectReference(near, {.trilinear = true}, 1e-5, 1e-5);
}

// Where a sample of the spline is missing: the trilinear gradient and no Hessian; where a corner is: nothing.
TEST(SurfaceDerivatives, SayWhereSamplesAreMissing) {
  const glm::ivec3 dims(16);
  const Grid grid = test::gridOfVoxels(GridGeometry::make(dims, glm::dvec3(1.0)), [](glm::dvec3 p) {
    return p == glm::dvec3(8, 8, 8) ? std::nan("") : smooth(p);
  });
  const std::vector<glm::vec4> points = {
      {6.5f, 8.2f, 8.3f, 1.0f}, {7.5f, 7.5f, 7.5f, 1.0f}, {3.5f, 3.5f, 3.5f, 1.0f}};
  for (const TracerTarget target : vectorTargets()) {
    Images images(points.size());
    surfaceDerivatives(grid, {}, points, all(points), {images.gradient, images.diagonal, images.mixed},
                       target);
    const glm::dvec3 trilinear = sampleTrilinear(grid, glm::dvec3(points[0])).gradient;
    EXPECT_LT(glm::distance(glm::dvec3(images.gradient[0]), trilinear), 1e-6);
    EXPECT_EQ(images.diagonal[0].w, 0.0f);
    EXPECT_EQ(images.mixed[0], glm::vec4(0.0f));
    EXPECT_EQ(images.gradient[1], glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(images.diagonal[1].w, 0.0f);
    EXPECT_EQ(images.diagonal[2].w, 1.0f);
  }
}

TEST(SurfaceDerivatives, AreMadeInTheAreaAlone) {
  const Grid grid = test::gridOfVoxels(obliqueGeometry({23, 19, 21}), smooth);
  const std::vector<glm::vec4> points = pointsIn(grid.dims());
  const glm::ivec2 size(20, 30);
  ASSERT_EQ(points.size(), 600u);
  const PictureArea area = PictureArea::of(size, {{5, 16}, {9, 3}});
  Images whole(points.size()), part(points.size());
  surfaceDerivatives(grid, {}, points, PictureArea::whole(size), {whole.gradient, {}, {}});
  surfaceDerivatives(grid, {}, points, area, {part.gradient, {}, {}});
  for (int i = 0; i < 600; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const bool within = i / size.x >= 16 && i % size.x >= 5 && i % size.x < 14;
    EXPECT_EQ(part.gradient[at], within ? whole.gradient[at] : glm::vec4(0.0f)) << i;
  }
}

}  // namespace
}  // namespace isolux::volume
