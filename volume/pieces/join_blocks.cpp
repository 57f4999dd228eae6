#include "volume/pieces/join_blocks.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <variant>

#include "volume/hit/cell_pieces.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/pieces/block_cells.h"

namespace isolux::volume {

namespace {

constexpr std::uint64_t kFirstColumn = 0x0101010101010101u;

// The voxels x + 8 y of one slice of `low` whose neighbours on the next block along an axis are inside too.
// Along z there is one slice, the last.
std::uint64_t facePairs(const VoxelBits& low, const VoxelBits& high, int axis, std::size_t z) {
  if (axis == 0) return low[z] >> 7 & high[z] & kFirstColumn;
  if (axis == 1) return low[z] >> 56 & high[z] & 255u;
  return low[7] & high[0];
}

void joinAcrossFace(const PieceBlocks::View& low, const PieceBlocks::View& high, int axis,
                    ConcurrentUnionFind& sets) {
  const std::size_t slices = axis == 2 ? 1 : 8;
  const bool single = low.components == 1 && high.components == 1;
  std::uint32_t lastLow = PieceBlocks::kNoLabel, lastHigh = PieceBlocks::kNoLabel;
  for (std::size_t z = 0; z < slices; ++z)
    for (std::uint64_t pairs = facePairs(*low.bits, *high.bits, axis, z); pairs != 0; pairs &= pairs - 1) {
      const int bit = std::countr_zero(pairs);
      glm::ivec3 inHigh(bit % 8, bit / 8, static_cast<int>(z));
      glm::ivec3 inLow = inHigh;
      inLow[axis] = kPieceBlock - 1;
      inHigh[axis] = 0;
      const std::uint32_t a = low.labelOf(inLow), b = high.labelOf(inHigh);
      if (a != lastLow || b != lastHigh) sets.join(a, b);
      if (single) return;
      lastLow = a;
      lastHigh = b;
    }
}

void joinToNext(const PieceBlocks& blocks, glm::ivec3 b, ConcurrentUnionFind& sets) {
  const PieceBlocks::View low = blocks.view(b);
  if (!low.bits) return;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 next = b;
    if (++next[axis] == blocks.dims()[axis]) continue;
    const PieceBlocks::View high = blocks.view(next);
    if (high.bits) joinAcrossFace(low, high, axis, sets);
  }
}

// What an ambiguous cell joins. A cell with a missing corner holds no field and joins nothing.
void joinInCell(const Grid& grid, const PieceBlocks& blocks, InsideLevel level, glm::ivec3 cell,
                ConcurrentUnionFind& sets) {
  std::array<double, 8> values;
  std::array<glm::ivec3, 8> voxels;
  for (std::size_t corner = 0; corner < 8; ++corner) {
    voxels[corner] = grid.extent().corner(cell, corner);
    values[corner] = level.depth(grid.stored(voxels[corner]));
    if (std::isnan(values[corner])) return;
  }
  const auto pieces = cellPieces(values);
  for (std::size_t corner = 0; corner < 8; ++corner)
    if (pieces[corner] < corner)
      sets.join(blocks.labelOf(voxels[corner]), blocks.labelOf(voxels[pieces[corner]]));
}

}  // namespace

NodeVolumes joinBlocks(const Grid& grid, const PieceBlocks& blocks, InsideLevel level,
                       ConcurrentUnionFind& sets, base::Progress& progress) {
  const Extent3 extent{blocks.dims()};
  const bool hasVolume = std::min({grid.dims().x, grid.dims().y, grid.dims().z}) > 1;
  NodeVolumes volumes(blocks.nodes());
  const auto joinRow = [&](const auto& voxels, std::size_t row) {
    BlockCells cells;
    CellVolumes enclosed(blocks, grid.missingCount() > 0, volumes);
    for (glm::ivec3 b = extent.firstOfRow(row); b.x < extent.dims.x; ++b.x) {
      joinToNext(blocks, b, sets);
      if (!blocks.crossed(blocks.index(b))) {
        enclosed.addUncrossed(b);
        continue;
      }
      cells.load(voxels, grid.dims(), b, level);
      for (int z = 0; z < cells.count().z; ++z) {
        const BlockCells::Slice slice = cells.slice(z);
        const std::uint64_t ambiguous = slice.ambiguous();
        for (std::uint64_t left = ambiguous; left != 0; left &= left - 1) {
          const int bit = std::countr_zero(left);
          joinInCell(grid, blocks, level, kPieceBlock * b + glm::ivec3(bit % 8, bit / 8, z), sets);
        }
        if (hasVolume) enclosed.addSlice(b, cells, slice, z, ambiguous);
      }
    }
  };
  std::visit(
      [&](const auto& voxels) {
        parallelSteps(extent.rows(), progress, {0.3, 0.9, "finding pieces"},
                      [&](std::size_t row) { joinRow(voxels, row); });
      },
      grid.voxels());
  return volumes;
}

}  // namespace isolux::volume
