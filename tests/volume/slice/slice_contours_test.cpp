// Isocontours on planes: their points lie on the reconstruction, none is missed, and those of known solids
// are the circles that they should be.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/hidden_balls.h"
#include "tests/support/unwatched.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"
#include "volume/slice/slice_contours.h"

namespace isolux::test {
namespace {

using scene::Field;
using volume::Grid;
using volume::GridGeometry;
using volume::SliceCurve;
using volume::SliceCurves;
using volume::SliceField;
using volume::SlicePlane;

SlicePlane planeThrough(const Grid& grid, glm::dvec3 normal, glm::dvec3 voxel) {
  const auto frame = volume::sliceFrame(normal, scene::WorldAxes::zUp, scene::Convention::radiological);
  return nativeSlice(grid.geometry(), frame,
                     glm::dvec3(grid.geometry().worldFromVoxel * glm::dvec4(voxel, 1.0)));
}

SliceCurves contours(const SliceField& field, const SlicePlane& plane, double isovalue,
                     const volume::HiddenPieces& hidden = {}) {
  base::Progress progress;
  return sliceContours(field, plane, isovalue, hidden, progress);
}

Grid noiseGrid(const GridGeometry& geometry, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(-1.0f, 1.0f);
  std::vector<float> voxels(geometry.voxelCount());
  for (float& v : voxels) v = value(random);
  return Grid(geometry, std::move(voxels));
}

GridGeometry smallOblique() {
  GridGeometry geometry = obliqueLeftHandedGeometry(20);
  geometry.dims = {9, 8, 7};
  return geometry;
}

volume::FieldSample sampleOf(const SliceField& field, glm::dvec3 voxel) {
  if (field.field == Field::trilinear) return sampleTrilinear(field.grid, voxel);
  return field.coefficients ? sampleCubic(*field.coefficients, field.grid, voxel)
                            : sampleCubic(field.grid, voxel);
}

glm::dvec3 worldOf(const Grid& grid, glm::dvec3 voxel) {
  return glm::dvec3(grid.geometry().worldFromVoxel * glm::dvec4(voxel, 1.0));
}

// Segments, sorted into squares of a pixel so that those near a point are found.
class NearSegments {
 public:
  NearSegments(const SliceCurves& found, const SlicePlane& plane, const Grid& grid)
      : size_(plane.size + 2), squares_(static_cast<std::size_t>(size_.x * size_.y)) {
    for (const SliceCurve& curve : found.curves)
      for (std::size_t i = curve.closed ? 0 : 1; i < curve.points.size(); ++i) {
        const auto pixel = [&](std::size_t k) { return plane.pixelOf(worldOf(grid, curve.points[k])); };
        const glm::dvec2 p = pixel((i + curve.points.size() - 1) % curve.points.size()), q = pixel(i);
        const glm::ivec2 low(glm::floor(glm::min(p, q) - 0.5)), high(glm::floor(glm::max(p, q) + 0.5));
        for (int y = low.y; y <= high.y; ++y)
          for (int x = low.x; x <= high.x; ++x)
            if (x >= -1 && y >= -1 && x <= plane.size.x && y <= plane.size.y)
              squares_[index({x, y})].emplace_back(p, q);
      }
  }
  double distance(glm::dvec2 at) const {
    double least = 1e9;
    for (const auto& [p, q] : squares_[index(glm::ivec2(glm::floor(at)))]) {
      const glm::dvec2 way = q - p;
      const double t = std::clamp(glm::dot(at - p, way) / std::max(glm::dot(way, way), 1e-30), 0.0, 1.0);
      least = std::min(least, glm::distance(at, p + t * way));
    }
    return least;
  }

 private:
  std::size_t index(glm::ivec2 square) const {
    return static_cast<std::size_t>((square.y + 1) * size_.x + square.x + 1);
  }
  glm::ivec2 size_;
  std::vector<std::vector<std::pair<glm::dvec2, glm::dvec2>>> squares_;
};

// The largest distance, voxels, of a sign change between samples 1/16 pixel apart from the nearest segment.
double farthestSignChange(const SliceField& field, const SlicePlane& plane, double isovalue,
                          const SliceCurves& found, std::size_t& changes) {
  constexpr int fine = 16;
  const NearSegments near(found, plane, field.grid);
  const glm::dmat4 voxelFromWorld = field.grid.geometry().voxelFromWorld();
  double farthest = 0.0;
  for (int y = 0; y <= (plane.size.y - 1) * fine; ++y) {
    double before = std::numeric_limits<double>::quiet_NaN();
    for (int x = 0; x <= (plane.size.x - 1) * fine; ++x) {
      const glm::dvec2 pixel = glm::dvec2(x, y) / double(fine);
      const double f = field.value(glm::dvec3(voxelFromWorld * glm::dvec4(plane.at(pixel), 1.0))) - isovalue;
      if (!std::isnan(f) && !std::isnan(before) && (f >= 0.0) != (before >= 0.0)) {
        ++changes;
        farthest = std::max(farthest, near.distance(pixel - glm::dvec2(0.5 / fine, 0.0)));
      }
      before = f;
    }
  }
  return farthest;
}

class NoiseContours : public testing::TestWithParam<Field> {};

// Noise is the hardest: every cell is crossed, with saddles and closed curves smaller than a voxel.
TEST_P(NoiseContours, LieOnTheReconstructionAndMissNothing) {
  const glm::dvec3 normals[] = {{0, 0, 1}, {1, 0, 0}, {0.4, -0.5, 0.77}, {1, 1, 1}};
  for (const bool oblique : {false, true})
    for (const glm::dvec3& normal : normals) {
      const Grid grid = noiseGrid(oblique ? smallOblique() : unitGeometry({9, 8, 7}), 3);
      const auto coefficients = interpolatingCoefficients(grid);
      const SliceField field{grid, GetParam(),
                             GetParam() == Field::cubic_interpolating ? &coefficients : nullptr};
      const SlicePlane plane = planeThrough(grid, normal, {4.1, 3.3, 2.9});
      const double isovalue = GetParam() == Field::cubic ? 0.03 : 0.11;
      const SliceCurves found = contours(field, plane, isovalue);
      double worst = 0.0;
      std::size_t points = 0;
      for (const SliceCurve& curve : found.curves)
        for (const glm::dvec3& voxel : curve.points) {
          const auto sample = sampleOf(field, voxel);
          worst = std::max(worst, std::abs(sample.value - isovalue) / glm::length(sample.gradient));
          EXPECT_NEAR(glm::dot(worldOf(grid, voxel) - plane.originMm, plane.frame().normal()), 0.0, 1e-9);
          ++points;
        }
      EXPECT_GT(points, 100u);
      EXPECT_LT(worst, 1e-6);
      std::size_t changes = 0;
      // Half a step, and how far a chord lies from its curve.
      EXPECT_LT(farthestSignChange(field, plane, isovalue, found, changes), 0.5 / 16 + 0.06);
      EXPECT_GT(changes, 200u);
    }
}
INSTANTIATE_TEST_SUITE_P(EachField, NoiseContours,
                         testing::Values(Field::trilinear, Field::cubic, Field::cubic_interpolating));

// Curves of the trilinear field end at the border of the volume only, and never twice in one point.
TEST(SliceContours, EndAtTheBorderOrNotAtAll) {
  for (const glm::dvec3& normal : {glm::dvec3(0, 0, 1), glm::dvec3(0.4, -0.5, 0.77)})
    for (const double at : {3.0, 3.4}) {  // in a layer of voxels, and between
      const Grid grid = noiseGrid(unitGeometry({24, 23, 8}), 5);
      const SliceCurves found = contours({grid}, planeThrough(grid, normal, {11, 11, at}), 0.2);
      std::size_t closed = 0, open = 0;
      for (const SliceCurve& curve : found.curves) {
        (curve.closed ? closed : open)++;
        if (curve.closed) continue;
        for (const glm::dvec3& end : {curve.points.front(), curve.points.back()}) {
          const glm::dvec3 inside = glm::min(end, glm::dvec3(grid.dims() - 1) - end);
          EXPECT_LT(std::min({inside.x, inside.y, inside.z}), 1e-9);
        }
      }
      EXPECT_GT(closed, 10u);
      EXPECT_GT(open, 2u);
    }
}

// xyz on x + y + z = 3/2 has its maximum, 1/8, in the middle of the cell: a closed curve that meets no face.
TEST(SliceContours, FindACurveWithinOneCell) {
  const Grid grid = gridOfVoxels(unitGeometry({2, 2, 2}), [](glm::dvec3 p) { return p.x * p.y * p.z; });
  const SliceCurves found = contours({grid}, planeThrough(grid, {1, 1, 1}, glm::dvec3(0.5)), 0.124);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_TRUE(found.curves[0].closed);
  EXPECT_GE(found.curves[0].points.size(), 3u);
  for (const glm::dvec3& p : found.curves[0].points) EXPECT_NEAR(p.x * p.y * p.z, 0.124, 1e-12);
}

// (x + a)(y + b)(z + c), wherever its maximum on the plane lies, mostly within one triangle: nothing on any
// edge tells of it.
TEST(SliceContours, FindACurveWithinOneTriangle) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0.3, 0.6);
  for (int i = 0; i < 100; ++i) {
    const glm::dvec3 top(place(random), place(random), place(random));
    const Grid grid = gridOfVoxels(unitGeometry({2, 2, 2}), [&](glm::dvec3 p) {
      const glm::dvec3 q = p - top + 1.0;
      return q.x * q.y * q.z;
    });
    // About 1 - |p - top|^2 / 2 on the plane: a circle of 0.03 voxels.
    const SliceCurves found = contours({grid}, planeThrough(grid, {1, 1, 1}, top), 1.0 - 0.5 * 0.03 * 0.03);
    ASSERT_EQ(found.curves.size(), 1u) << i;
    EXPECT_TRUE(found.curves[0].closed);
    for (const glm::dvec3& p : found.curves[0].points) EXPECT_NEAR(glm::distance(p, top), 0.03, 0.003);
  }
}

// f = R^2 - |p - m|^2: the spline through the samples has it exactly, but for what the border changes;
// trilinear interpolation lies at most 1/4 below for each axis.
TEST(SliceContours, OfABallAreCircles) {
  const double radius = 13.3;
  const GridGeometry geometry = obliqueLeftHandedGeometry(64);
  const double spacing = std::max({geometry.spacingMm().x, geometry.spacingMm().y, geometry.spacingMm().z});
  const double mm =
      radius * std::min({geometry.spacingMm().x, geometry.spacingMm().y, geometry.spacingMm().z});
  const glm::dvec3 middle(geometry.worldFromVoxel * glm::dvec4(31.3, 31.9, 30.6, 1.0));
  const Grid grid =
      gridOfWorld(geometry, [&](glm::dvec3 p) { return mm * mm - glm::dot(p - middle, p - middle); });
  const auto coefficients = interpolatingCoefficients(grid);
  for (const glm::dvec3& normal : {glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0), glm::dvec3(0.5, -0.3, 0.8)}) {
    const double beside = 0.4 * mm;
    const auto frame = volume::sliceFrame(normal, scene::WorldAxes::zUp, scene::Convention::radiological);
    const SlicePlane plane = nativeSlice(geometry, frame, middle + beside * frame.normal());
    const double expected = std::sqrt(mm * mm - beside * beside);
    for (const bool spline : {false, true}) {
      const SliceCurves found = contours(
          {grid, spline ? Field::cubic_interpolating : Field::trilinear, spline ? &coefficients : nullptr},
          plane, 0.0);
      ASSERT_EQ(found.curves.size(), 1u);
      EXPECT_TRUE(found.curves[0].closed);
      for (const glm::dvec3& voxel : found.curves[0].points) {
        const double r = glm::distance(worldOf(grid, voxel), middle + beside * frame.normal());
        ASSERT_LT(r, expected + 2e-4);
        ASSERT_GT(r, expected - (spline ? 2e-4 : 0.75 * spacing * spacing / (2.0 * expected) * 1.05));
      }
    }
  }
}

// r^2 - (sqrt(x^2 + y^2) - R)^2 - z^2: across its axis two circles about it, through it two of the tube.
TEST(SliceContours, OfATorusAreTwoCircles) {
  const double ring = 18.0, tube = 7.0, z = 2.5;
  const Grid grid = gridOfVoxels(unitGeometry({56, 56, 24}), [&](glm::dvec3 p) {
    const glm::dvec3 at = p - glm::dvec3(27.4, 27.7, 11.6);
    const double from = std::hypot(at.x, at.y) - ring;
    return tube * tube - from * from - at.z * at.z;
  });
  const auto radii = [&](const SliceCurves& found, auto distance, double expectedA, double expectedB) {
    ASSERT_EQ(found.curves.size(), 2u);
    for (const SliceCurve& curve : found.curves) {
      EXPECT_TRUE(curve.closed);
      for (const glm::dvec3& p : curve.points) {
        const double r = distance(p - glm::dvec3(27.4, 27.7, 11.6));
        ASSERT_LT(std::min(std::abs(r - expectedA), std::abs(r - expectedB)), 0.06);
      }
    }
  };
  const double reach = std::sqrt(tube * tube - z * z);
  radii(
      contours({grid}, planeThrough(grid, {0, 0, 1}, {0, 0, 11.6 + z}), 0.0),
      [](glm::dvec3 p) { return std::hypot(p.x, p.y); }, ring + reach, ring - reach);
  radii(
      contours({grid}, planeThrough(grid, {0.6, 0.8, 0}, {27.4, 27.7, 0}), 0.0),
      [&](glm::dvec3 p) { return std::hypot(std::hypot(p.x, p.y) - ring, p.z); }, tube, tube);
}

TEST(SliceContours, OfHiddenPiecesAreLeftOut) {
  const Grid grid = gridOfVoxels(unitGeometry({40, 20, 20}), [](glm::dvec3 p) {
    return std::max(5.0 - glm::distance(p, {9.3, 9.4, 9.2}), 6.0 - glm::distance(p, {28.3, 9.4, 9.2}));
  });
  volume::VoxelMask hidden(grid.dims());
  for (int z = 0; z < 20; ++z)
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 18; ++x)
        if (grid.value(x, y, z) >= 0.0) hidden.hide(x, x + 1, y, z);
  const SlicePlane plane = planeThrough(grid, {0, 0, 1}, {0, 0, 9.0});
  EXPECT_EQ(contours({grid}, plane, 0.0).curves.size(), 2u);
  const SliceCurves shown = contours({grid}, plane, 0.0, {&hidden, scene::Inside::above});
  ASSERT_EQ(shown.curves.size(), 1u);
  EXPECT_TRUE(shown.curves[0].closed);
  EXPECT_GT(shown.curves[0].points[0].x, 18.0);
}

TEST(SliceContours, EndBesideMissingVoxels) {
  const Grid grid = gridOfVoxels(unitGeometry({20, 20, 20}), [](glm::dvec3 p) {
    if (glm::distance(p, {15, 10, 10}) < 1.5) return std::numeric_limits<double>::quiet_NaN();
    return 5.0 - glm::distance(p, glm::dvec3(9.7));
  });
  const SliceCurves found = contours({grid}, planeThrough(grid, {0, 0, 1}, {0, 0, 9.7}), 0.0);
  ASSERT_EQ(found.curves.size(), 1u);
  EXPECT_FALSE(found.curves[0].closed);
}

TEST(SliceContours, NeedCellsAndHeedAStop) {
  const Grid flat = gridOfVoxels(unitGeometry({9, 1, 9}), [](glm::dvec3 p) { return p.x; });
  EXPECT_TRUE(contours({flat}, planeThrough(flat, {0, 0, 1}, {0, 0, 4}), 3.5).curves.empty());
  EXPECT_EQ(contours({flat}, planeThrough(flat, {0, 1, 0}, {0, 0, 4}), 3.5).curves.size(), 1u);
  base::Progress progress;
  progress.requestStop();
  EXPECT_THROW(sliceContours({flat}, planeThrough(flat, {0, 1, 0}, {0, 0, 4}), 3.5, {}, progress),
               base::Error);
}

}  // namespace
}  // namespace isolux::test
