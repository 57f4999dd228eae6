#include "volume/pieces/cell_volumes.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "volume/hit/cell_pieces.h"
#include "volume/skip/row_lanes.h"

namespace isolux::volume {

namespace {

constexpr int kColumns = 4;  // of a cell, along y and along z
constexpr std::uint64_t kWholeCell = 1ull << 32;

// Cells x + 8 y of a slice of which the corner on that side is a voxel of their own block.
constexpr std::uint64_t kNotLastX = 0x7f7f7f7f7f7f7f7fu, kNotLastY = 0x00ffffffffffffffu;

// The length of the part of [0, 1] where a + (b - a) x >= 0.
FourFloats lengthInside(FourFloats a, FourFloats b) {
  constexpr float tiny = 1e-30f;  // against 0 / 0
  const FourFloats none = {};
  const FourFloats outside = (a < 0.0f ? a : none) + (b < 0.0f ? b : none);  // negative
  return 1.0f + outside / ((a + b) - 2.0f * outside + tiny);                 // |a| + |b|
}

std::uint64_t unitsOf(float cells) {
  if (!(cells > 0.0f)) return 0;  // NaN of values whose differences overflow
  return static_cast<std::uint64_t>(static_cast<double>(std::min(cells, 1.0f)) * kVolumeUnits + 0.5);
}

}  // namespace

// Lanes are the columns along z.
float partInside(const std::array<float, 8>& d) {
  const FourFloats z = {0.125f, 0.375f, 0.625f, 0.875f};
  const auto along = [&](std::size_t corner) { return d[corner] + z * (d[corner + 4] - d[corner]); };
  const FourFloats near = along(0), far = along(1), nearRise = along(2) - near, farRise = along(3) - far;
  FourFloats sum = {};
  for (int i = 0; i < kColumns; ++i) {
    const float y = (static_cast<float>(i) + 0.5f) / kColumns;
    sum += lengthInside(near + y * nearRise, far + y * farRise);
  }
  return (sum[0] + sum[1] + sum[2] + sum[3]) / (kColumns * kColumns);
}

std::array<double, 8> cornerShares(const CellCorners& values) {
  std::array<double, 8> shares{};
  for (int z = 0; z < kColumns; ++z)
    for (int y = 0; y < kColumns; ++y) {
      const glm::dvec3 near(0.0, (y + 0.5) / kColumns, (z + 0.5) / kColumns), far(1.0, near.y, near.z);
      const double a = trilinear(values, near), b = trilinear(values, far), most = std::max(a, b);
      if (most < 0.0) continue;
      const double length = std::min(a, b) >= 0.0 ? 1.0 : most / std::abs(a - b);
      shares[static_cast<std::size_t>(cornerAbove(values, a >= b ? near : far))] +=
          length / (kColumns * kColumns);
    }
  return shares;
}

void CellVolumes::addUncrossed(glm::ivec3 block) {
  const PieceBlocks::View view = blocks_.view(block);
  if (!view.bits) return;
  const glm::ivec3 cells = glm::max(glm::min(blocks_.voxelDims() - 1 - block * kPieceBlock, kPieceBlock), 0);
  volumes_.add(view.firstNode, static_cast<std::uint64_t>(cells.x * cells.y * cells.z) * kWholeCell);
}

void CellVolumes::addSlice(glm::ivec3 block, const BlockCells& cells, const BlockCells::Slice& slice, int z,
                           std::uint64_t ambiguous) {
  const PieceBlocks::View view = blocks_.view(block);
  addWhole(view, slice.whole, z);
  std::uint64_t left = slice.crossed & ~ambiguous;
  for (int corner = 0; left != 0 && corner < 8; ++corner) {
    const std::uint64_t first = left & slice.corners[static_cast<std::size_t>(corner)];
    left &= ~first;
    addCrossed(block, view, cells, corner, first, z);
  }
  for (std::uint64_t at = ambiguous; at != 0; at &= at - 1) {
    const int bit = std::countr_zero(at);
    const glm::ivec3 cell(bit % 8, bit / 8, z);
    const std::array<float, 8> depths = cells.depths(cell);
    if (!hasMissing(depths)) addAmbiguous(kPieceBlock * block + cell, depths);
  }
}

bool CellVolumes::hasMissing(const std::array<float, 8>& depths) const {
  return anyMissing_ &&
         std::any_of(depths.begin(), depths.end(), [](float depth) { return std::isnan(depth); });
}

void CellVolumes::addWhole(const PieceBlocks::View& view, std::uint64_t whole, int z) {
  if (whole == 0) return;
  if (!view.labels) {
    volumes_.add(view.firstNode, static_cast<std::uint64_t>(std::popcount(whole)) * kWholeCell);
    return;
  }
  for (; whole != 0; whole &= whole - 1) {
    const int bit = std::countr_zero(whole);
    volumes_.add(view.labelOf({bit % 8, bit / 8, z}), kWholeCell);
  }
}

// All inside corners of these cells are of one piece: that of the first, `corner`.
void CellVolumes::addCrossed(glm::ivec3 block, const PieceBlocks::View& view, const BlockCells& cells,
                             int corner, std::uint64_t crossed, int z) {
  const glm::ivec3 step = cornerStep(corner);
  std::uint64_t within = z + step.z < kPieceBlock ? ~std::uint64_t{0} : 0;
  if (step.x != 0) within &= kNotLastX;
  if (step.y != 0) within &= kNotLastY;
  for (; crossed != 0; crossed &= crossed - 1) {
    const int bit = std::countr_zero(crossed);
    const glm::ivec3 cell(bit % 8, bit / 8, z);
    const std::array<float, 8> depths = cells.depths(cell);
    if (hasMissing(depths)) continue;
    const bool own = (within >> bit & 1u) != 0;
    const glm::ivec3 voxel = Extent3{blocks_.voxelDims()}.corner(kPieceBlock * block + cell, corner);
    const std::uint32_t node = own ? view.labelOf(cell + step) : blocks_.labelOf(voxel);
    volumes_.add(node, unitsOf(partInside(depths)));
  }
}

void CellVolumes::addAmbiguous(glm::ivec3 cell, const std::array<float, 8>& depths) {
  CellCorners values;
  for (std::size_t corner = 0; corner < 8; ++corner) values[corner] = depths[corner];
  const std::array<double, 8> shares = cornerShares(values);
  for (std::size_t corner = 0; corner < 8; ++corner) {
    if (!(shares[corner] > 0.0)) continue;
    const glm::ivec3 voxel = Extent3{blocks_.voxelDims()}.corner(cell, corner);
    volumes_.add(blocks_.labelOf(voxel), unitsOf(static_cast<float>(shares[corner])));
  }
}

}  // namespace isolux::volume
