// Volume and area in single cells: closed forms, and the same cell cut into small ones.
#include "volume/measure/cell_measure.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace isolux::test {
namespace {

using volume::CellCorners;
using volume::CellMeasure;
using volume::CellMetric;
using volume::CellPoint;
using volume::measureCell;

const CellMetric kUnit{glm::dmat3(1.0)};
const CellMetric kOblique{
    glm::dmat3(glm::dvec3(0.4, 0.1, 0.0), glm::dvec3(-0.05, 0.4, 0.2), glm::dvec3(0.1, 0.3, -2.5))};

template <class Field>
CellCorners cornersOf(const Field& field) {
  CellCorners corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = field(glm::dvec3(i & 1, i >> 1 & 1, i >> 2));
  return corners;
}

CellMeasure inParts(const CellCorners& corners, const CellMetric& metric, int parts) {
  CellMeasure sum;
  for (int z = 0; z < parts; ++z)
    for (int y = 0; y < parts; ++y)
      for (int x = 0; x < parts; ++x) {
        const glm::dvec3 low = glm::dvec3(x, y, z) / static_cast<double>(parts);
        sum += measureCellPart(corners, metric, low, low + 1.0 / parts);
      }
  return sum;
}

TEST(CellMeasureTest, PlanesAreExact) {
  const CellMeasure hexagon =
      measureCell(cornersOf([](glm::dvec3 p) { return p.x + p.y + p.z - 1.5; }), kUnit);
  EXPECT_NEAR(hexagon.volume, 0.5, 1e-12);
  EXPECT_NEAR(hexagon.area, 0.75 * std::sqrt(3.0), 1e-12);
  EXPECT_NEAR(hexagon.sensitivity, 0.75, 1e-12);
  const CellMeasure corner =
      measureCell(cornersOf([](glm::dvec3 p) { return 0.5 - p.x - p.y - p.z; }), kUnit);
  EXPECT_NEAR(corner.volume, 0.125 / 6.0, 1e-12);
  EXPECT_NEAR(corner.area, std::sqrt(3.0) / 8.0, 1e-12);
  for (int axis = 0; axis < 3; ++axis) {
    const CellMeasure flat = measureCell(cornersOf([&](glm::dvec3 p) { return p[axis] - 0.25; }), kUnit);
    EXPECT_NEAR(flat.volume, 0.75, 1e-12);
    EXPECT_NEAR(flat.area, 1.0, 1e-12);
  }
}

// {x y >= c} of a cell whose field does not depend on z: volume 1 - c + c ln c.
TEST(CellMeasureTest, AHyperbolaHasItsArea) {
  const double c = 0.2;
  const CellMeasure cell = measureCell(cornersOf([&](glm::dvec3 p) { return p.x * p.y - c; }), kUnit);
  EXPECT_NEAR(cell.volume, 1.0 - c + c * std::log(c), 1e-5);
  EXPECT_NEAR(cell.sensitivity, -std::log(c), 1e-4);
}

// Two cells that share a plateau at the isovalue: its sheet counts once, in the cell that is below.
TEST(CellMeasureTest, APlateauAtTheIsovalueCountsOnce) {
  const CellMeasure below = measureCell(cornersOf([](glm::dvec3 p) { return p.z - 1.0; }), kUnit);
  const CellMeasure above = measureCell(cornersOf([](glm::dvec3 p) { return p.z; }), kUnit);
  EXPECT_NEAR(below.area, 1.0, 1e-7);  // a corner at the isovalue is a hair inside
  EXPECT_NEAR(below.volume, 0.0, 1e-7);
  EXPECT_EQ(above.area, 0.0);
  EXPECT_EQ(above.volume, 1.0);
}

// White noise in the corners: every topology, ambiguous faces and tunnels, in a cell that leans.
TEST(CellMeasureTest, RandomCellsAreTheSumsOfTheirParts) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  int beyond = 0, crossed = 0;
  for (int i = 0; i < 600; ++i) {
    const CellCorners corners = cornersOf([&](glm::dvec3) { return normal(random); });
    const CellMetric& metric = i % 2 == 0 ? kUnit : kOblique;
    const CellMeasure whole = measureCell(corners, metric), parts = inParts(corners, metric, 6);
    if (whole.area == 0.0) continue;
    ++crossed;
    EXPECT_NEAR(whole.volume, parts.volume, whole.volumeError + parts.volumeError + 1e-9 * metric.cellMm3)
        << i;
    EXPECT_NEAR(whole.area, parts.area, 2e-3 * metric.faceMm2) << i;
    EXPECT_NEAR(whole.sensitivity, parts.sensitivity, 0.01 * parts.sensitivity) << i;
    beyond += std::abs(whole.area - parts.area) > whole.areaError + parts.areaError + 1e-9 * metric.faceMm2;
    CellCorners negative = corners;
    for (double& value : negative) value = -value;
    EXPECT_NEAR(measureCell(negative, metric).volume, metric.cellMm3 - whole.volume, 2.0 * whole.volumeError);
  }
  EXPECT_GT(crossed, 550);
  EXPECT_LE(beyond, crossed / 200);
}

TEST(CellMeasureTest, PointsLieOnTheSurfaceAndCarryItsArea) {
  std::mt19937_64 random(2);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const CellCorners corners = cornersOf([&](glm::dvec3) { return normal(random); });
    std::vector<CellPoint> points;
    const CellMeasure cell = measureCell(corners, kOblique, &points);
    double area = 0.0;
    for (const CellPoint& point : points) {
      EXPECT_NEAR(volume::trilinear(corners, point.local), 0.0, 1e-9);
      area += point.area;
    }
    EXPECT_NEAR(area, cell.area, 1e-9 * kOblique.faceMm2);
  }
}

TEST(CellMeasureTest, SensitivityIsTheChangeOfVolume) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 slope(normal(random), normal(random), normal(random));
    const CellCorners corners =
        cornersOf([&](glm::dvec3 p) { return glm::dot(slope, p - 0.5) + 0.05 * normal(random); });
    CellCorners higher = corners, lower = corners;
    constexpr double step = 1e-3;
    for (std::size_t k = 0; k < 8; ++k) {
      higher[k] -= step;
      lower[k] += step;
    }
    const double change =
        (measureCell(lower, kOblique).volume - measureCell(higher, kOblique).volume) / (2.0 * step);
    EXPECT_NEAR(measureCell(corners, kOblique).sensitivity, change, 0.02 * change + 1e-6) << i;
  }
}

// Tiny and huge values have the same shape.
TEST(CellMeasureTest, AnyScaleOfValues) {
  const CellCorners corners = cornersOf([](glm::dvec3 p) { return p.x * p.y + 0.3 * p.z - 0.4; });
  const CellMeasure one = measureCell(corners, kUnit);
  for (const double scale : {1e-200, 1e-30, 1e30, 1e200}) {
    CellCorners scaled = corners;
    for (double& value : scaled) value *= scale;
    const CellMeasure cell = measureCell(scaled, kUnit);
    EXPECT_NEAR(cell.area, one.area, 1e-9);
    EXPECT_NEAR(cell.volume, one.volume, 1e-9);
    EXPECT_NEAR(cell.sensitivity * scale, one.sensitivity, 1e-9);
  }
}

}  // namespace
}  // namespace isolux::test
