// Slices against an independent sampling, and slabs of fields whose mean and extremes are known.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/unwatched.h"
#include "tests/support/volumes.h"
#include "volume/slice/slice_values.h"

namespace isolux::test {
namespace {

using scene::Field;
using scene::SlabMode;
using volume::Grid;
using volume::GridGeometry;
using volume::SlicePlane;
using Real = long double;

// Cramer's rule on the columns of the matrix.
std::array<Real, 3> voxelAt(const GridGeometry& geometry, glm::dvec3 world) {
  const auto column = [&](int i) {
    return std::array<Real, 3>{geometry.worldFromVoxel[i][0], geometry.worldFromVoxel[i][1],
                               geometry.worldFromVoxel[i][2]};
  };
  const auto determinant = [](const auto& a, const auto& b, const auto& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
           c[0] * (a[1] * b[2] - a[2] * b[1]);
  };
  const auto a = column(0), b = column(1), c = column(2), o = column(3);
  const std::array<Real, 3> r{world.x - o[0], world.y - o[1], world.z - o[2]};
  const Real all = determinant(a, b, c);
  return {determinant(r, b, c) / all, determinant(a, r, c) / all, determinant(a, b, r) / all};
}

// The B-spline of a degree as a function of the distance.
Real bSpline(int degree, Real x) {
  x = std::abs(x);
  if (degree == 1) return std::max<Real>(0, 1 - x);
  if (x >= 2) return 0;
  return x >= 1 ? (2 - x) * (2 - x) * (2 - x) / 6 : (4 - 6 * x * x + 3 * x * x * x) / 6;
}

// A sum over all samples that a spline of this degree reaches; beyond the border they repeat.
template <class Sample>
Real splineAt(const std::array<Real, 3>& voxel, int degree, glm::ivec3 dims, const Sample& sample) {
  Real sum = 0;
  const auto from = [&](int axis) {
    return static_cast<int>(std::floor(voxel[static_cast<std::size_t>(axis)])) - 2;
  };
  for (int z = from(2); z <= from(2) + 5; ++z)
    for (int y = from(1); y <= from(1) + 5; ++y)
      for (int x = from(0); x <= from(0) + 5; ++x) {
        const Real weight =
            bSpline(degree, voxel[0] - x) * bSpline(degree, voxel[1] - y) * bSpline(degree, voxel[2] - z);
        if (weight != 0)
          sum += weight * sample(std::clamp(x, 0, dims.x - 1), std::clamp(y, 0, dims.y - 1),
                                 std::clamp(z, 0, dims.z - 1));
      }
  return sum;
}

Grid noiseGrid(const GridGeometry& geometry) {
  std::mt19937 random(7);
  std::vector<std::int16_t> voxels(geometry.voxelCount());
  for (std::int16_t& v : voxels) v = static_cast<std::int16_t>(static_cast<int>(random() % 4001) - 2000);
  return Grid(geometry, std::move(voxels), 0.5, -300.0);
}

GridGeometry obliqueGeometry() {
  GridGeometry geometry = obliqueLeftHandedGeometry(20);
  geometry.dims = {20, 17, 13};
  return geometry;
}

TEST(SliceValues, EqualAnIndependentSamplingInEveryFieldAndPlane) {
  const Grid grid = noiseGrid(obliqueGeometry());
  const volume::Coefficients coefficients = interpolatingCoefficients(grid);
  const glm::dvec3 middle(grid.geometry().worldFromVoxel *
                          glm::dvec4(0.5 * glm::dvec3(grid.dims() - 1), 1.0));
  const volume::SliceFrame frames[] = {
      sliceFrame(volume::SliceDirection::axial, scene::WorldAxes::anatomical,
                 scene::Convention::radiological),
      sliceFrame(volume::SliceDirection::coronal, scene::WorldAxes::anatomical,
                 scene::Convention::neurological),
      sliceFrame(volume::SliceDirection::sagittal, scene::WorldAxes::zUp, scene::Convention::radiological),
      volume::sliceFrame(glm::dvec3(0.3, -0.7, 0.4), scene::WorldAxes::zUp, scene::Convention::radiological)};
  base::Progress progress;
  for (const auto field : {Field::trilinear, Field::cubic, Field::cubic_interpolating})
    for (const volume::SliceFrame& frame : frames) {
      const SlicePlane plane = fittedSlice(grid.geometry(), frame, middle, {61, 47});
      const auto slice = sliceValues({grid, field, &coefficients}, plane, {}, progress);
      std::size_t inside = 0;
      for (int y = 0; y < plane.size.y; ++y)
        for (int x = 0; x < plane.size.x; ++x) {
          const float value = slice.values[static_cast<std::size_t>(y * plane.size.x + x)];
          const auto voxel =
              voxelAt(grid.geometry(), plane.originMm + double(x) * plane.rightMm + double(y) * plane.downMm);
          Real beyond = -1;
          for (std::size_t axis = 0; axis < 3; ++axis)
            beyond =
                std::max({beyond, -voxel[axis], voxel[axis] - (grid.dims()[static_cast<int>(axis)] - 1)});
          if (std::abs(beyond) < 1e-5L) continue;  // within rounding of the border
          ASSERT_EQ(std::isnan(value), beyond > 0) << x << ' ' << y;
          if (beyond > 0) continue;
          ++inside;
          const Real expected =
              splineAt(voxel, field == Field::trilinear ? 1 : 3, grid.dims(), [&](int i, int j, int k) {
                const Real stored =
                    field == Field::cubic_interpolating
                        ? Real(coefficients.offset) + Real(coefficients.values[grid.index(i, j, k)])
                        : Real(grid.stored(i, j, k));
                return stored * 0.5L - 300;
              });
          ASSERT_NEAR(value, static_cast<double>(expected), 2e-7 * 2000.0) << x << ' ' << y;
        }
      EXPECT_GT(inside, 500u);
    }
}

TEST(SliceValues, NativePixelsAreTheVoxelsThemselves) {
  const Grid grid = noiseGrid(GridGeometry::make({20, 17, 13}, {0.7, 0.7, 2.5}, {-12.3, 40.1, 7.7}));
  base::Progress progress;
  const auto frame =
      sliceFrame(volume::SliceDirection::axial, scene::WorldAxes::zUp, scene::Convention::radiological);
  const SlicePlane plane = nativeSlice(grid.geometry(), frame, {3.0, 4.0, 7.7 + 2.5 * 5});
  ASSERT_EQ(plane.size, glm::ivec2(20, 17));
  const auto slice = sliceValues({grid}, plane, {}, progress);
  for (int y = 0; y < 17; ++y)
    for (int x = 0; x < 20; ++x)
      ASSERT_NEAR(slice.values[static_cast<std::size_t>(y * 20 + x)], grid.value(x, y, 5), 1e-3);
}

// f = 2 z + x: a slab across z has the mean of its middle, and extremes at its ends.
TEST(SliceValues, SlabsOfARampHaveItsMeanAndItsEnds) {
  const Grid grid = gridOfWorld(GridGeometry::make({16, 16, 24}, {1.0, 1.0, 0.8}, {1.0, 2.0, 3.0}),
                                [](glm::dvec3 p) { return 2.0 * p.z + p.x; });
  const auto frame =
      sliceFrame(volume::SliceDirection::axial, scene::WorldAxes::zUp, scene::Convention::radiological);
  base::Progress progress;
  const glm::dvec3 point(5.0, 5.0, 12.3);
  const SlicePlane plane = nativeSlice(grid.geometry(), frame, point);
  const auto at = [&](double mm, SlabMode mode, const SlicePlane& where) {
    return sliceValues({grid}, where, {mm, mode}, progress).values[5 * 16 + 4];
  };
  const double middle = 2.0 * 12.3 + 5.0;
  EXPECT_NEAR(at(0.0, SlabMode::mean, plane), middle, 1e-5);
  for (const double mm : {0.3, 3.1, 10.0}) {
    EXPECT_NEAR(at(mm, SlabMode::mean, plane), middle, 1e-5) << mm;
    EXPECT_NEAR(at(mm, SlabMode::maximum, plane), middle + mm, 1e-5) << mm;
    EXPECT_NEAR(at(mm, SlabMode::minimum, plane), middle - mm, 1e-5) << mm;
  }
  // At the border the part beyond it does not count; a slab that only reaches in has what it reaches.
  const SlicePlane below = nativeSlice(grid.geometry(), frame, {5.0, 5.0, 2.0});
  EXPECT_TRUE(std::isnan(at(0.0, SlabMode::mean, below)));
  EXPECT_TRUE(std::isnan(at(1.9, SlabMode::maximum, below)));
  EXPECT_NEAR(at(4.0, SlabMode::maximum, below), 2.0 * 4.0 + 5.0, 1e-5);
  EXPECT_NEAR(at(4.0, SlabMode::minimum, below), 2.0 * 3.0 + 5.0, 1e-5);
  EXPECT_NEAR(at(1e6, SlabMode::mean, below), 2.0 * (3.0 + 0.5 * 23 * 0.8) + 5.0, 1e-4);
}

// |z - z0|: d / 4 over a slab of d about z0.
TEST(SliceValues, TheMeanIsThatOfTheLineThroughTheValues) {
  const Grid grid = gridOfWorld(GridGeometry::make({8, 8, 24}, {1.0, 1.0, 0.8}),
                                [](glm::dvec3 p) { return std::abs(p.z - 0.8 * 12); });
  const auto frame =
      sliceFrame(volume::SliceDirection::axial, scene::WorldAxes::zUp, scene::Convention::radiological);
  base::Progress progress;
  const SlicePlane plane = nativeSlice(grid.geometry(), frame, {3.0, 3.0, 0.8 * 12});
  for (const double mm : {1.6, 3.2, 8.0})
    EXPECT_NEAR(sliceValues({grid}, plane, {mm, SlabMode::mean}, progress).values[3 * 8 + 3], mm / 4.0, 1e-5);
}

TEST(SliceValues, MissingVoxelsAreNan) {
  const Grid grid = gridOfVoxels(unitGeometry({9, 9, 9}), [](glm::dvec3 p) {
    return p == glm::dvec3(4, 4, 4) ? std::numeric_limits<double>::quiet_NaN() : p.x;
  });
  base::Progress progress;
  const auto frame =
      sliceFrame(volume::SliceDirection::axial, scene::WorldAxes::zUp, scene::Convention::radiological);
  const SlicePlane plane = nativeSlice(grid.geometry(), frame, {4.0, 4.0, 4.0});
  const auto thin = sliceValues({grid}, plane, {}, progress);
  EXPECT_TRUE(std::isnan(thin.values[4 * 9 + 4]));
  EXPECT_EQ(thin.values[4 * 9 + 6], 6.0f);
  EXPECT_EQ(sliceValues({grid}, plane, {6.0, SlabMode::mean}, progress).values[4 * 9 + 4], 4.0f);
}

TEST(SliceValues, HeedAStop) {
  const Grid grid = noiseGrid(obliqueGeometry());
  base::Progress progress;
  progress.requestStop();
  const SlicePlane plane = nativeSlice(grid.geometry(), {}, glm::dvec3(0.0));
  try {
    sliceValues({grid}, plane, {}, progress);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
  }
}

}  // namespace
}  // namespace isolux::test
