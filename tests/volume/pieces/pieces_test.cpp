#include "volume/pieces/pieces.h"

#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/flooded_pieces.h"
#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "volume/read/reader.h"

namespace isolux::volume {
namespace {

using scene::Inside;

Pieces piecesOf(std::shared_ptr<const Grid> grid, double isovalue, Inside inside = Inside::above) {
  base::Progress progress;
  const MinMaxBlocks blocks(*grid, 8, progress);
  return {std::move(grid), blocks, isovalue, inside, progress};
}

// Where all of label's voxels are of one number of `ofVoxel`.
template <class OfVoxel>
void expectRefines(const Grid& grid, const std::vector<std::uint32_t>& label, const OfVoxel& ofVoxel) {
  std::map<std::uint32_t, std::uint32_t> number;
  const glm::ivec3 n = grid.dims();
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x) {
        const std::uint32_t expected = label[grid.index(x, y, z)], found = ofVoxel(glm::ivec3(x, y, z));
        ASSERT_EQ(found == Pieces::kNone, expected == 0xffffffffu) << x << " " << y << " " << z;
        ASSERT_EQ(number.emplace(expected, found).first->second, found) << x << " " << y << " " << z;
      }
}

// All that the flood says is joined is, and nothing else; voxels are counted; the largest comes first.
// Returns how many pieces the flood is not sure of.
std::size_t check(const Grid& grid, double isovalue, Inside inside) {
  const test::FloodedBounds reference = test::floodedPieces(grid, isovalue, inside);
  const Pieces pieces = piecesOf(std::make_shared<const Grid>(grid), isovalue, inside);
  const auto found = [&](glm::ivec3 voxel) { return pieces.ofVoxel(voxel); };
  expectRefines(grid, reference.joined.label, found);
  std::vector<std::uint32_t> label;
  std::vector<std::size_t> voxels(pieces.list().size());
  const glm::ivec3 n = grid.dims();
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x) {
        label.push_back(found({x, y, z}));
        if (label.back() != Pieces::kNone) ++voxels.at(label.back());
      }
  expectRefines(grid, label,
                [&](glm::ivec3 v) { return reference.possible.label[grid.index(v.x, v.y, v.z)]; });
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    EXPECT_EQ(pieces.list()[i].voxels, voxels[i]) << "piece " << i;
    EXPECT_GE(pieces.list()[i ? i - 1 : 0].volumeMm3, pieces.list()[i].volumeMm3);
  }
  return reference.joined.voxels.size() - reference.possible.voxels.size();
}

template <class T>
Grid noiseGrid(glm::ivec3 dims, std::uint64_t seed, double low, double high, double slope = 1.0) {
  std::vector<T> voxels(test::unitGeometry(dims).voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = static_cast<T>(std::round(low + (high - low) * base::uniformNoise(seed, i)));
  return Grid(test::unitGeometry(dims), std::move(voxels), slope, 0.0);
}

// In binary data every saddle of a face is where a path of samples finds it, if the isovalue is not half-way.
TEST(Pieces, OfBinaryDataAreThoseOfAFlood) {
  for (const std::uint64_t seed : {1u, 2u, 3u})
    for (const double isovalue : {0.35, 0.7})
      EXPECT_EQ(check(noiseGrid<std::uint8_t>({21, 17, 19}, seed, 0.0, 1.0), isovalue, Inside::above), 0u);
}

TEST(Pieces, OfNoiseAreThoseOfAFlood) {
  for (const double isovalue : {40.0, 50.3, 71.5, 90.0})
    for (const Inside inside : {Inside::above, Inside::below})
      check(noiseGrid<std::int16_t>({18, 17, 9}, 5, 0.0, 100.0), isovalue, inside);
}

// Blocks that are inside as a whole, and an outside with a hole.
TEST(Pieces, OfLargeBallsAreThoseOfAFlood) {
  const Grid ball = test::phantomGrid("ball", 64);
  EXPECT_EQ(check(ball, 0.0, Inside::above), 0u);
  EXPECT_EQ(check(ball, 0.0, Inside::below), 0u);
  const Pieces pieces = piecesOf(std::make_shared<const Grid>(ball), 0.0);
  const double radius = 0.35 * 63.0;
  EXPECT_NEAR(pieces.list().at(0).volumeMm3 / (4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3)), 1.0,
              2e-3);
}

TEST(Pieces, ANegativeSlopeExchangesTheSides) {
  check(noiseGrid<std::int16_t>({17, 9, 11}, 7, 0.0, 100.0, -1.0), -40.0, Inside::above);
  check(noiseGrid<std::int16_t>({17, 9, 11}, 7, 0.0, 100.0, -1.0), -70.0, Inside::below);
}

TEST(Pieces, OfScansAreThoseOfAFlood) {
  ISOLUX_NEEDS_DATA();
  base::Progress progress;
  const Grid engine =
      *readVolume((test::dataFolder() / "volumes/engine_crop.mhd").string(), {}, progress).grid;
  for (const double isovalue : {60.0, 80.0, 180.0}) {
    SCOPED_TRACE(isovalue);
    EXPECT_LT(check(engine, isovalue, Inside::above), 5u);
  }
}

TEST(Pieces, MissingVoxelsBelongToNoneAndJoinNothing) {
  Grid grid = noiseGrid<float>({19, 10, 17}, 9, 0.0, 100.0);
  std::vector<float> voxels = std::get<std::vector<float>>(grid.voxels());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    if (base::uniformNoise(10, i) < 0.1) voxels[i] = std::numeric_limits<float>::quiet_NaN();
  check(Grid(grid.geometry(), voxels), 55.0, Inside::above);
  // A ball that a missing layer cuts in two.
  const auto ball = [](glm::dvec3 p) {
    return std::round(p.x) == 12.0 ? std::nan("") : 9.0 - glm::length(p - 12.0);
  };
  const Pieces halves = piecesOf(
      std::make_shared<const Grid>(test::gridOfVoxels(test::unitGeometry(glm::ivec3(25)), ball)), 0.0);
  EXPECT_EQ(halves.list().size(), 2u);
}

TEST(Pieces, AxesOfOneVoxelAreJoinedAcrossFaces) {
  for (const glm::ivec3& dims :
       {glm::ivec3(40, 33, 1), glm::ivec3(1, 40, 20), glm::ivec3(30, 1, 1), glm::ivec3(1)})
    check(noiseGrid<std::int16_t>(dims, 12, 0.0, 100.0), 50.0, Inside::above);
}

TEST(Pieces, IsovaluesAtVoxelsAndBeyondThem) {
  const Grid grid = noiseGrid<std::uint8_t>({20, 18, 17}, 13, 10.0, 14.0);
  for (const double isovalue : {10.0, 11.0, 12.0, 13.0, 14.0})
    for (const Inside inside : {Inside::above, Inside::below}) check(grid, isovalue, inside);
  const auto shared = std::make_shared<const Grid>(grid);
  EXPECT_EQ(piecesOf(shared, 14.001).list().size(), 0u);
  EXPECT_EQ(piecesOf(shared, 9.0, Inside::below).list().size(), 0u);
  EXPECT_EQ(piecesOf(shared, std::nan("")).list().size(), 0u);
  const Pieces all = piecesOf(shared, 10.0);
  ASSERT_EQ(all.list().size(), 1u);
  EXPECT_EQ(all.list()[0].voxels, grid.geometry().voxelCount());
  EXPECT_NEAR(all.list()[0].volumeMm3, 19.0 * 17.0 * 16.0, 1e-6);
}

TEST(Pieces, VolumesAreThoseOfBalls) {
  const Grid grid = test::gridOfWorld(GridGeometry::make(glm::ivec3(30), {0.7, 1.1, 1.6}), [](glm::dvec3 p) {
    return std::max(7.0 - glm::length(p - glm::dvec3(9.0, 9.5, 12.0)),
                    4.5 - glm::length(p - glm::dvec3(14.0, 24.0, 36.0)));
  });
  const Pieces pieces = piecesOf(std::make_shared<const Grid>(grid), 0.0);
  ASSERT_EQ(pieces.list().size(), 2u);
  const double radii[] = {7.0, 4.5};
  for (std::size_t i = 0; i < 2; ++i) {
    const Piece& piece = pieces.list()[i];
    const double ball = 4.0 / 3.0 * std::numbers::pi * std::pow(radii[i], 3);
    EXPECT_NEAR(piece.volumeMm3, ball, 0.05 * ball);  // a chord's width less
  }
}

TEST(Pieces, PointsBelongToThePieceAroundThem) {
  const Grid grid = noiseGrid<std::int16_t>({20, 18, 17}, 21, 0.0, 100.0);
  const Pieces pieces = piecesOf(std::make_shared<const Grid>(grid), 55.0);
  for (std::uint64_t i = 0; i < 500; ++i) {
    const auto at = [&](std::uint64_t k) { return base::uniformNoise(22, 3 * i + k); };
    const glm::ivec3 voxel(at(0) * 20, at(1) * 18, at(2) * 17);
    EXPECT_EQ(pieces.ofPoint(glm::dvec3(voxel) + 1e-9), pieces.ofVoxel(voxel));
  }
  EXPECT_EQ(pieces.ofPoint(glm::dvec3(-0.1, 3.0, 3.0)), Pieces::kNone);
  EXPECT_EQ(pieces.ofPoint(glm::dvec3(std::nan(""))), Pieces::kNone);
}

}  // namespace
}  // namespace isolux::volume
