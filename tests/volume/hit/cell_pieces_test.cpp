// Connectivity within a cell, against a lattice of samples that is flooded.
#include "volume/hit/cell_pieces.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/flooded_pieces.h"

namespace isolux::volume {
namespace {

// Returns whether the lattice decided.
bool checkAgainstLattice(const CellCorners& f) {
  const test::FloodedCorners reference = test::floodedCorners(f);
  const auto found = cellPieces(f);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const auto smallest = static_cast<std::size_t>(reference.joined[corner]);
    EXPECT_EQ(found[corner] == 8, smallest == 8);
    if (smallest == 8) continue;
    EXPECT_EQ(found[corner], found[smallest]) << "corner " << corner;
    EXPECT_EQ(reference.possible[corner], reference.possible[found[corner]]) << "corner " << corner;
  }
  return reference.joined == reference.possible;
}

// Magnitudes over two decades push saddles to either side.
CellCorners cornersOf(unsigned pattern, std::uint64_t trial) {
  CellCorners f;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    const double u = base::uniformNoise(11 + pattern, 8 * trial + corner);
    f[corner] = (pattern >> corner & 1u ? 1.0 : -1.0) * std::pow(10.0, 2.0 * u - 1.0);
  }
  return f;
}

int components(const CellCorners& f) {
  const auto pieces = cellPieces(f);
  int found = 0;
  for (std::uint8_t corner = 0; corner < 8; ++corner) found += pieces[corner] == corner ? 1 : 0;
  return found;
}

// Corners that hang together along edges.
int componentsAlongEdges(unsigned pattern) {
  CellCorners steep;  // so much deeper outside that no saddle is inside
  for (std::size_t corner = 0; corner < 8; ++corner) steep[corner] = pattern >> corner & 1u ? 1.0 : -1e6;
  return components(steep);
}

TEST(CellPieces, EverySignPatternIsConnectedAsDenseSamplesAre) {
  int decided = 0, all = 0, ambiguous = 0;
  for (unsigned pattern = 0; pattern < 256; ++pattern) {
    const bool apart = componentsAlongEdges(pattern) > 1;
    std::set<int> seen;
    for (std::uint64_t trial = 0; trial < (apart ? 25u : 3u); ++trial, ++all) {
      const CellCorners f = cornersOf(pattern, trial);
      decided += checkAgainstLattice(f) ? 1 : 0;
      seen.insert(components(f));
      ASSERT_FALSE(HasFailure()) << "pattern " << pattern << " trial " << trial;
    }
    if (!apart) continue;
    ++ambiguous;
    EXPECT_GT(seen.size(), 1u) << "saddles of pattern " << pattern << " were on one side only";
  }
  EXPECT_GT(decided, all * 80 / 100);
  EXPECT_EQ(ambiguous, 88);  // of the 255 sets of a cube's corners 167 hang together along edges
}

// The other two axes of the sweep must say the same.
TEST(CellPieces, TheAxisOfTheSweepDoesNotMatter) {
  for (unsigned pattern = 0; pattern < 256; ++pattern)
    for (std::uint64_t trial = 0; trial < 200; ++trial) {
      const CellCorners f = cornersOf(pattern, trial);
      CellCorners turned;  // x -> y -> z -> x
      const auto turn = [](std::size_t c) { return (c << 1 & 7u) | c >> 2; };
      for (std::size_t corner = 0; corner < 8; ++corner) turned[turn(corner)] = f[corner];
      const auto a = cellPieces(f), b = cellPieces(turned);
      for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t j = 0; j < 8; ++j)
          ASSERT_EQ(a[i] == a[j], b[turn(i)] == b[turn(j)]) << "pattern " << pattern << " trial " << trial;
    }
}

// A saddle that is the isovalue itself joins: the inside is closed.
TEST(CellPieces, ASaddleOnTheIsovalueJoins) {
  const CellCorners onFace{1, -1, -1, 1, -9, -9, -9, -9};
  EXPECT_EQ(cellPieces(onFace)[3], 0);
  const CellCorners apart{1, -1, -1.001, 1, -9, -9, -9, -9};
  EXPECT_EQ(cellPieces(apart)[3], 3);
  const CellCorners across{1, -9, -1, -9, -1, -9, 1, -9};  // the same face, along the sweep
  EXPECT_EQ(cellPieces(across)[6], 0);
  const CellCorners touching{0, -1, -1, 0, -1, -1, -1, -1};
  EXPECT_EQ(cellPieces(touching)[3], 3);
}

TEST(CellPieces, TheAscentStaysInsideItsPiece) {
  for (unsigned pattern = 1; pattern < 255; ++pattern)
    for (std::uint64_t trial = 0; trial < 40; ++trial) {
      const CellCorners f = cornersOf(pattern, trial);
      const auto pieces = cellPieces(f);
      for (std::uint64_t i = 0; i < 20; ++i) {
        const auto at = [&](std::uint64_t k) { return base::uniformNoise(3, 60 * trial + 3 * i + k); };
        glm::dvec3 p(at(0), at(1), at(2));
        if (trilinear(f, p) < 0.0) continue;
        const auto corner = static_cast<std::size_t>(cornerAbove(f, p));
        ASSERT_LT(pieces[corner], 8);
        double before = trilinear(f, p);
        for (int axis = 0; axis < 3; ++axis) {  // the way, axis after axis
          p[axis] = static_cast<double>(corner >> axis & 1u);
          const double now = trilinear(f, p);
          ASSERT_GE(now, before - 1e-9);
          before = now;
        }
      }
    }
}

}  // namespace
}  // namespace isolux::volume
