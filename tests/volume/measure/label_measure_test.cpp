// Labels have their counted volumes, smoothed ones that errors explain, and areas of balls.
#include "volume/measure/label_measure.h"

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

using volume::Grid;
using volume::GridGeometry;
using volume::LabelMeasure;

std::vector<LabelMeasure> measuredLabels(const GridGeometry& geometry,
                                         const std::function<int(glm::ivec3)>& labelAt,
                                         double smoothing = 1.0) {
  std::vector<std::int16_t> voxels;
  volume::forEachIn(glm::ivec3(0), geometry.dims,
                    [&](glm::ivec3 p) { voxels.push_back(static_cast<std::int16_t>(labelAt(p))); });
  base::Progress progress;
  const volume::LabelBlocks blocks(std::make_shared<const Grid>(geometry, std::move(voxels)), "", progress);
  return measureLabels(blocks, smoothing, progress);
}

double lengthTo(glm::ivec3 p, glm::dvec3 centre) {
  return glm::length(glm::dvec3(p) - centre);
}

// Three balls, one of them negative and one in two places, in voxels of half a millimetre.
int ballsAt(glm::ivec3 p) {
  if (lengthTo(p, {14.3, 15.1, 15.4}) <= 10.0) return 7;
  if (lengthTo(p, {35.2, 12.4, 14.7}) <= 6.0 || lengthTo(p, {35.4, 26.2, 16.1}) <= 5.0) return -3;
  return lengthTo(p, {50.4, 16.3, 15.2}) <= 6.0 ? 300 : 0;
}

TEST(LabelMeasureTest, BallsHaveTheirSizes) {
  const auto geometry = GridGeometry::make({62, 36, 31}, glm::dvec3(0.5), {3.0, -4.0, 5.0});
  const std::vector<LabelMeasure> labels = measuredLabels(geometry, ballsAt);
  ASSERT_EQ(labels.size(), 3u);
  std::vector<std::size_t> counts(3);
  volume::forEachIn(glm::ivec3(0), geometry.dims, [&](glm::ivec3 p) {
    const int label = ballsAt(p);
    for (std::size_t i = 0; i < 3; ++i) counts[i] += labels[i].label == label ? 1 : 0;
  });
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(labels[i].voxels, counts[i]);
    EXPECT_DOUBLE_EQ(labels[i].countedMm3, 0.125 * static_cast<double>(counts[i]));
    EXPECT_LE(labels[i].thinVoxels, 1u);  // at the tip along an axis
    EXPECT_FALSE(labels[i].meetsBorder);
  }
  EXPECT_EQ(labels[0].label, -3);
  EXPECT_EQ(labels[0].pieces, 2u);
  const LabelMeasure& large = labels[1];
  EXPECT_EQ(large.label, 7);
  EXPECT_EQ(large.pieces, 1u);
  const double radius = 5.0, area = 4.0 * std::numbers::pi * radius * radius;
  EXPECT_NEAR(large.volumeMm3.value, area * radius / 3.0, large.volumeMm3.error);
  EXPECT_NEAR(large.areaMm2.value, area, large.areaMm2.error);
  EXPECT_LT(large.volumeMm3.error, 0.1 * large.volumeMm3.value);
  EXPECT_LT(large.areaMm2.error, 0.1 * large.areaMm2.value);
  EXPECT_NEAR(large.volumeMm3.value / large.countedMm3, 0.988, 0.004);  // balls shrink a little
  EXPECT_NEAR(large.bounds.lowMm.x, 3.0 + 0.5 * 14.3 - radius, 0.25);
  EXPECT_NEAR(large.bounds.highMm.z, 5.0 + 0.5 * 15.4 + radius, 0.25);
  EXPECT_EQ(labels[2].label, 300);
  EXPECT_NEAR(labels[2].volumeMm3.value / labels[2].countedMm3, 0.967, 0.01);
}

// A label's measures do not depend on its neighbours, nor on where it lies.
TEST(LabelMeasureTest, LabelsAreMeasuredByThemselves) {
  const auto geometry = unitGeometry({40, 33, 31});
  const auto ball = [](glm::ivec3 p) { return lengthTo(p, {14.3, 15.1, 15.4}) <= 9.0; };
  const auto alone = measuredLabels(geometry, [&](glm::ivec3 p) { return ball(p) ? 4 : 0; });
  const auto among = measuredLabels(geometry, [&](glm::ivec3 p) { return ball(p) ? 4 : 10 + p.x / 8; });
  const auto shifted = measuredLabels(unitGeometry({60, 50, 50}),
                                      [&](glm::ivec3 p) { return ball(p - glm::ivec3(11, 7, 13)) ? 4 : 9; });
  for (const LabelMeasure& same : {among[0], shifted[0]}) {
    EXPECT_EQ(same.label, 4);
    EXPECT_EQ(same.voxels, alone[0].voxels);
    EXPECT_NEAR(same.volumeMm3.value, alone[0].volumeMm3.value, 1e-9 * alone[0].volumeMm3.value);
    EXPECT_NEAR(same.areaMm2.value, alone[0].areaMm2.value, 1e-9 * alone[0].areaMm2.value);
  }
}

// A label that fills the volume is closed half a voxel beyond its border.
TEST(LabelMeasureTest, LabelsAtTheBorderAreClosedThere) {
  const auto full =
      measuredLabels(GridGeometry::make({20, 16, 12}, {1.0, 1.0, 2.0}), [](glm::ivec3) { return 1; });
  ASSERT_EQ(full.size(), 1u);
  EXPECT_TRUE(full[0].meetsBorder);
  EXPECT_EQ(full[0].countedMm3, 20.0 * 16.0 * 12.0 * 2.0);
  EXPECT_NEAR(full[0].volumeMm3.value, full[0].countedMm3, 0.02 * full[0].countedMm3);  // edges are rounded
  EXPECT_NEAR(full[0].areaMm2.value, 2.0 * (20.0 * 16.0 + 20.0 * 24.0 + 16.0 * 24.0),
              0.08 * full[0].areaMm2.value);
  const auto slice = measuredLabels(unitGeometry({20, 16, 1}), [](glm::ivec3 p) { return p.x / 10; });
  ASSERT_EQ(slice.size(), 1u);
  EXPECT_EQ(slice[0].voxels, 160u);
  EXPECT_GT(slice[0].volumeMm3.value, 0.5 * 160.0);
}

// What smoothing alone would lose keeps a part of its volume, and is said to be thin.
TEST(LabelMeasureTest, ThinLabelsStayAndAreCounted) {
  const auto geometry = unitGeometry(glm::ivec3(24));
  const auto labels = measuredLabels(geometry, [](glm::ivec3 p) {
    if (p == glm::ivec3(4, 4, 4)) return 1;
    if (p.y == 12 && p.z == 5) return 2;
    if (p.z == 16 && p.x > 5 && p.x < 18 && p.y > 5 && p.y < 18) return 3;
    return 0;
  });
  ASSERT_EQ(labels.size(), 3u);
  for (const LabelMeasure& label : labels) EXPECT_EQ(label.pieces, 1u);
  // Between a centre of 1 and ones of -1 around it the surface is (1 - x)(1 - y)(1 - z) = 1/2, along a line
  // (1 - x)(1 - y) = 1/2.
  const double log = std::numbers::ln2, lone = 4.0 - 4.0 * log - 2.0 * log * log, along = 2.0 - 2.0 * log;
  EXPECT_NEAR(labels[0].volumeMm3.value, lone, 1e-3);
  EXPECT_NEAR(labels[1].volumeMm3.value, 23.0 * along + lone, 1e-3);
  EXPECT_NEAR(labels[2].volumeMm3.value / labels[2].countedMm3, 0.73, 0.04);
  RecordProperty("sheet", std::to_string(labels[2].volumeMm3.value / labels[2].countedMm3));
  EXPECT_EQ(labels[0].thinVoxels, 1u);
  EXPECT_EQ(labels[1].thinVoxels, 24u);
  EXPECT_GT(labels[2].thinVoxels, 0u);
  EXPECT_LT(labels[2].thinVoxels, labels[2].voxels);
}

TEST(LabelMeasureTest, CanBeStopped) {
  base::Progress progress;
  const volume::LabelBlocks blocks(
      std::make_shared<const Grid>(unitGeometry(glm::ivec3(8)), std::vector<std::uint8_t>(512, 1)), "",
      progress);
  progress.requestStop();
  EXPECT_THROW(measureLabels(blocks, 1.0, progress), base::Error);
}

}  // namespace
}  // namespace isolux::test
