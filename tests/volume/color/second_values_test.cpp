#include "volume/color/second_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/rays.h"
#include "tests/support/unwatched.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {
namespace {

struct Uniform {
  std::uint64_t seed, drawn = 0;
  double operator()() { return base::uniformNoise(seed, drawn++); }
};

std::shared_ptr<const SecondVolume> secondOf(Grid grid, scene::Field field = scene::Field::trilinear) {
  auto second = std::make_shared<SecondVolume>();
  second->volume.grid = std::make_shared<const Grid>(std::move(grid));
  if (field == scene::Field::cubic_interpolating)
    second->coefficients = std::make_shared<const Coefficients>(interpolatingCoefficients(second->grid()));
  return second;
}

// Trilinear interpolation as scipy.ndimage.map_coordinates(order=1) defines it: a weighted sum of eight.
double mapCoordinates(const Grid& grid, const glm::dvec3& voxel) {
  const glm::ivec3 low = glm::min(glm::ivec3(glm::floor(voxel)), grid.dims() - 2);
  double sum = 0.0;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        double weight = 1.0;
        const glm::ivec3 corner(i, j, k);
        for (int axis = 0; axis < 3; ++axis) {
          const double t = voxel[axis] - low[axis];
          weight *= corner[axis] ? t : 1.0 - t;
        }
        sum += weight * grid.value(low.x + i, low.y + j, low.z + k);
      }
  return sum;
}

// The tensor product of cubic B-splines (cardinal formula) over coefficients, mirrored half a voxel beyond
// the border as the program's are: clamped.
double bspline(double x) {
  x = std::abs(x);
  return x < 1.0 ? 2.0 / 3.0 - x * x + 0.5 * x * x * x : x < 2.0 ? std::pow(2.0 - x, 3) / 6.0 : 0.0;
}
double splineSum(const Grid& grid, const glm::dvec3& voxel) {
  double sum = 0.0;
  const glm::ivec3 at(glm::floor(voxel)), last = grid.dims() - 1;
  for (int k = -1; k <= 2; ++k)
    for (int j = -1; j <= 2; ++j)
      for (int i = -1; i <= 2; ++i) {
        const glm::ivec3 n = at + glm::ivec3(i, j, k), s = glm::clamp(n, glm::ivec3(0), last);
        sum += bspline(voxel.x - n.x) * bspline(voxel.y - n.y) * bspline(voxel.z - n.z) *
               grid.value(s.x, s.y, s.z);
      }
  return sum;
}

Grid randomGrid(const GridGeometry& geometry) {
  Uniform random{5};
  return test::gridOfVoxels(geometry, [&](glm::dvec3) { return 100.0 * random() - 30.0; });
}

TEST(SecondValues, AreThoseOfAnIndependentLookupInAnyGeometry) {
  for (const GridGeometry& geometry :
       {test::isotropicGeometry(17), test::anisotropicGeometry(17), test::obliqueLeftHandedGeometry(17)}) {
    const Grid grid = randomGrid(geometry);
    Uniform random{6};
    for (int i = 0; i < 500; ++i) {
      const glm::dvec3 voxel = 16.0 * glm::dvec3(random(), random(), random());
      const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0));
      EXPECT_NEAR(SecondValues(secondOf(grid), scene::Field::trilinear).at(world)->value,
                  mapCoordinates(grid, voxel), 1e-9);
      EXPECT_NEAR(SecondValues(secondOf(grid), scene::Field::cubic).at(world)->value, splineSum(grid, voxel),
                  1e-9);
    }
    const SecondValues through(secondOf(grid, scene::Field::cubic_interpolating),
                               scene::Field::cubic_interpolating);
    for (const glm::ivec3& at : {glm::ivec3(3, 4, 5), glm::ivec3(0, 16, 8)})
      EXPECT_NEAR(through.at(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(at, 1.0)))->value,
                  grid.value(at.x, at.y, at.z), 1e-4);
  }
}

TEST(SecondValues, GradientsArePerMillimetreInTheWorld) {
  const GridGeometry geometry = test::obliqueLeftHandedGeometry(12);
  const glm::dvec3 slope(3.0, -2.0, 0.5);
  const Grid ramp = test::gridOfWorld(geometry, [&](glm::dvec3 p) { return glm::dot(slope, p); });
  for (const scene::Field field : {scene::Field::trilinear, scene::Field::cubic}) {
    const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(5.3, 6.1, 4.7, 1.0));
    EXPECT_LT(glm::distance(SecondValues(secondOf(ramp), field).at(world)->gradient, slope), 1e-4);
  }
}

TEST(SecondValues, ThereAreNoneOutsideAndWhereVoxelsAreMissing) {
  const Grid grid = test::gridOfVoxels(test::unitGeometry({6, 6, 6}), [](glm::dvec3 p) {
    return p == glm::dvec3(4, 4, 4) ? std::numeric_limits<double>::quiet_NaN() : p.x;
  });
  const SecondValues values(secondOf(grid), scene::Field::trilinear);
  EXPECT_FALSE(values.at({-0.1, 2, 2}));
  EXPECT_FALSE(values.at({2, 5.1, 2}));
  EXPECT_FALSE(values.at({3.5, 3.5, 3.5}));
  EXPECT_TRUE(values.at({0, 0, 0}));
  EXPECT_TRUE(values.at({5, 5, 2}));
}

TEST(SecondValues, TheLargestBelowIsThatOfDenseSamples) {
  const GridGeometry geometry = test::obliqueLeftHandedGeometry(20);
  const Grid grid = test::gridOfVoxels(geometry, [](glm::dvec3 p) {
    return 50.0 * std::sin(0.5 * p.x + 0.3 * p.y) + 30.0 * std::cos(0.6 * p.z);
  });
  const SecondValues values(secondOf(grid), scene::Field::cubic);
  Uniform random{9};
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 voxel = 3.0 + 13.0 * glm::dvec3(random(), random(), random());
    const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0));
    const glm::dvec3 inward = glm::normalize(glm::dvec3(random(), random(), random()) - 0.5);
    double most = -1e30;
    for (int s = 0; s <= 4000; ++s)
      if (const auto here = values.at(world + s / 4000.0 * 4.0 * inward)) most = std::max(most, here->value);
    const auto found = values.largestBelow(world, inward, 4.0);
    ASSERT_TRUE(found);
    EXPECT_LE(found->value, most + 1e-3);  // which is sampled, too
    EXPECT_GE(found->value, most - 0.2);   // of a range of 160
  }
  const auto outside = values.largestBelow(geometry.originMm() - 1000.0, {1, 0, 0}, 5.0);
  EXPECT_FALSE(outside);
}

}  // namespace
}  // namespace isolux::volume
