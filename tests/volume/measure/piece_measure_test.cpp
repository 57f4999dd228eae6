// Pieces are as large as the solids that they are, and add up to the whole.
#include "volume/measure/piece_measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

struct MeasuredPieces {
  volume::PieceMeasures pieces;
  volume::SurfaceMeasure whole;
};

MeasuredPieces measured(volume::Grid of, double isovalue, const std::vector<bool>& shown = {}) {
  base::Progress progress;
  const auto grid = std::make_shared<const volume::Grid>(std::move(of));
  const volume::MinMaxBlocks blocks(*grid, 8, progress);
  const volume::SurfaceQuestion question{.isovalue = isovalue};
  const volume::Pieces pieces(grid, blocks, isovalue, scene::Inside::above, progress);
  return {measurePieces(pieces, blocks, question, shown, progress),
          measureSurface(*grid, blocks, question, progress)};
}

volume::Grid threeBalls() {
  return gridOfVoxels(unitGeometry({64, 32, 32}), [](glm::dvec3 p) {
    return std::max({6.0 - glm::length(p - glm::dvec3(9.3, 15.2, 15.1)),
                     9.0 - glm::length(p - glm::dvec3(30.1, 15.7, 15.4)),
                     4.0 - glm::length(p - glm::dvec3(52.2, 15.3, 15.9))});
  });
}

TEST(PieceMeasureTest, BallsHaveTheirSizes) {
  const MeasuredPieces balls = measured(threeBalls(), 0.0);
  ASSERT_EQ(balls.pieces.pieces.size(), 3u);
  const double radii[] = {9.0, 6.0, 4.0}, middles[] = {30.1, 9.3, 52.2};
  for (std::size_t i = 0; i < 3; ++i) {
    const volume::PieceMeasure& piece = balls.pieces.pieces[i];
    const double r = radii[i];
    EXPECT_NEAR(piece.surface.volumeMm3.value, 4.0 / 3.0 * std::numbers::pi * r * r * r,
                piece.surface.volumeMm3.error);
    EXPECT_NEAR(piece.surface.areaMm2.value, 4.0 * std::numbers::pi * r * r, piece.surface.areaMm2.error);
    EXPECT_NEAR(piece.bounds.lowMm.x, middles[i] - r, 0.1);
    EXPECT_NEAR(piece.bounds.highMm.x, middles[i] + r, 0.1);
    EXPECT_FALSE(piece.surface.open());
  }
}

TEST(PieceMeasureTest, OnlyShownOnesCount) {
  const MeasuredPieces balls = measured(threeBalls(), 0.0, {false, true, false});
  EXPECT_NEAR(balls.pieces.whole.volumeMm3.value, balls.pieces.pieces[1].surface.volumeMm3.value, 1e-9);
}

// Noise has cells of every kind, among them some that hold several pieces.
TEST(PieceMeasureTest, PiecesAddUp) {
  for (const double isovalue : {0.0, 0.8}) {
    const MeasuredPieces noise = measured(
        gridOfVoxels(unitGeometry({15, 12, 13}),
                     [](glm::dvec3 p) { return std::sin(131.0 * p.x + 17.0 * p.y * p.y + 7.3 * p.z * p.x); }),
        isovalue);
    double volume = 0.0, area = 0.0;
    for (const volume::PieceMeasure& piece : noise.pieces.pieces) {
      volume += piece.surface.volumeMm3.value;
      area += piece.surface.areaMm2.value;
    }
    EXPECT_NEAR(volume, noise.pieces.whole.volumeMm3.value, 1e-9 * volume);
    EXPECT_NEAR(area, noise.pieces.whole.areaMm2.value, 1e-9 * area);
    EXPECT_NEAR(volume, noise.whole.volumeMm3.value, 1e-3 * volume);
    EXPECT_NEAR(area, noise.whole.areaMm2.value, 1e-3 * area);
    EXPECT_EQ(noise.pieces.whole.open(), noise.whole.open());
  }
}

}  // namespace
}  // namespace isolux::test
