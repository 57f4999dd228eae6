#include "volume/pieces/pieces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "volume/hit/cell_pieces.h"
#include "volume/hit/surface_voxel.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/pieces/block_cells.h"
#include "volume/pieces/cell_volumes.h"
#include "volume/pieces/concurrent_union_find.h"
#include "volume/pieces/running_sums.h"

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

// Joins the components of blocks: across the faces of blocks, and inside the cells whose inside corners do
// not hang together along edges; and adds up what the cells enclose, which are looked at once for both.
// `sets`: of blocks.nodes(). Returns the volume of each node, 0 where the grid has none. Multithreaded;
// throws Error: interrupted, memory.
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
  grid.visit([&](const auto& voxels) {
    parallelSteps(extent.rows(), progress, {0.3, 0.9, "finding pieces"},
                  [&](std::size_t row) { joinRow(voxels, row); });
  });
  return volumes;
}

// Counts the voxels of the pieces in a block.
void countPieceVoxels(const Pieces& pieces, glm::ivec3 b, RunningSums& counts) {
  const PieceBlocks& blocks = pieces.blocks();
  const PieceBlocks::View block = blocks.view(b);
  if (!block.bits) return;
  const auto add = [&](std::uint32_t label, int voxels) {
    counts.add(pieces.ofLabel(label), static_cast<std::uint64_t>(voxels));
  };
  if (blocks.inside(blocks.index(b))) {
    const glm::ivec3 size = glm::min(blocks.voxelDims() - b * kPieceBlock, kPieceBlock);
    add(block.firstNode, size.x * size.y * size.z);
    return;
  }
  for (int z = 0; z < kPieceBlock; ++z) {
    std::uint64_t bits = (*block.bits)[static_cast<std::size_t>(z)];
    if (!block.labels) {
      add(block.firstNode, std::popcount(bits));
      continue;
    }
    for (; bits != 0; bits &= bits - 1) {
      const int bit = std::countr_zero(bits);
      add(block.labelOf({bit % 8, bit / 8, z}), 1);
    }
  }
}

// One for each of `count` pieces, which pieces.ofLabel() tells. `volumes`: of joinBlocks(). Multithreaded;
// the same whatever the threads.
std::vector<Piece> pieceSizes(const Pieces& pieces, std::size_t count, const NodeVolumes& nodeVolumes,
                              base::Progress& progress) {
  const Extent3 blocks{pieces.blocks().dims()};
  std::vector<std::uint64_t> voxels(count), volumes(count);
  parallelSteps(blocks.rows(), progress, {0.9, 1.0, "measuring pieces"}, [&](std::size_t row) {
    RunningSums counts(voxels);
    for (glm::ivec3 b = blocks.firstOfRow(row); b.x < blocks.dims.x; ++b.x)
      countPieceVoxels(pieces, b, counts);
  });
  for (std::uint32_t node = 0; node < pieces.blocks().nodes(); ++node)
    volumes[pieces.ofLabel(node)] += nodeVolumes[node];
  const double cellMm3 = pieces.grid().geometry().voxelMm3();
  std::vector<Piece> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = {static_cast<double>(volumes[i]) / kVolumeUnits * cellMm3, voxels[i]};
  return result;
}

}  // namespace

Pieces::Pieces(std::shared_ptr<const Grid> grid, const MinMaxBlocks& blocks, double isovalue,
               scene::Inside inside, base::Progress& progress)
    : grid_(std::move(grid)),
      isovalue_(isovalue),
      inside_(inside),
      level_(InsideLevel::of(*grid_, isovalue, inside)),
      blocks_(std::make_unique<const PieceBlocks>(*grid_, blocks, level_, progress)) {
  constexpr std::size_t ofLabel = 2 * sizeof(std::uint32_t) + sizeof(NodeVolumes::value_type) + sizeof(Piece);
  held_ = reserveForPieces(blocks_->nodes() * ofLabel);
  ConcurrentUnionFind sets(blocks_->nodes());
  const NodeVolumes volumes = joinBlocks(*grid_, *blocks_, level_, sets, progress);
  const std::size_t count = numberRoots(sets);
  list_ = pieceSizes(*this, count, volumes, progress);
  sortBySize();
  held_.shrinkTo(bytes() - blocks_->bytes());
}

// Pieces in the order of their first nodes.
std::size_t Pieces::numberRoots(ConcurrentUnionFind& sets) {
  pieceOfNode_.resize(sets.count());
  std::uint32_t count = 0;
  for (std::uint32_t node = 0; node < sets.count(); ++node) {
    const std::uint32_t root = sets.root(node);  // the smallest node of its set
    pieceOfNode_[node] = root == node ? count++ : pieceOfNode_[root];
  }
  return count;
}

void Pieces::sortBySize() {
  std::vector<std::uint32_t> order(list_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return list_[a].volumeMm3 != list_[b].volumeMm3 ? list_[a].volumeMm3 > list_[b].volumeMm3
                                                    : list_[a].voxels > list_[b].voxels;
  });
  std::vector<std::uint32_t> id(list_.size());
  std::vector<Piece> sorted(list_.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    id[order[i]] = i;
    sorted[i] = list_[order[i]];
  }
  list_ = std::move(sorted);
  for (std::uint32_t& piece : pieceOfNode_) piece = id[piece];
}

bool Pieces::hasVolume() const {
  const glm::ivec3 dims = grid_->dims();
  return std::min({dims.x, dims.y, dims.z}) > 1;
}

std::uint32_t Pieces::ofPoint(glm::dvec3 voxel) const {
  const glm::ivec3 dims = grid_->dims();
  constexpr double near = 1e-6;  // a voxel's own position, carried through the world
  const glm::dvec3 nearest = glm::round(voxel);
  if (!glm::all(
          glm::lessThanEqual(glm::abs(2.0 * voxel - glm::dvec3(dims - 1)), glm::dvec3(dims - 1) + near)))
    return kNone;
  if (glm::all(glm::lessThan(glm::abs(voxel - nearest), glm::dvec3(near))))
    return ofVoxel(glm::ivec3(nearest));
  const glm::ivec3 cell = grid_->geometry().cellOf(voxel);
  const Extent3 extent{dims};
  CellCorners values;
  for (std::size_t i = 0; i < 8; ++i) values[i] = level_.depth(grid_->stored(extent.corner(cell, i)));
  const glm::dvec3 local = glm::clamp(voxel - glm::dvec3(cell), 0.0, 1.0);
  if (!(trilinear(values, local) >= 0.0)) return kNone;
  return ofVoxel(extent.corner(cell, cornerAbove(values, local)));
}

std::size_t Pieces::bytes() const {
  return blocks_->bytes() + pieceOfNode_.size() * sizeof(std::uint32_t) + list_.size() * sizeof(Piece);
}

std::uint32_t pieceOfSurface(const Pieces& pieces, const glm::dvec3& voxel) {
  const auto inside = surfaceVoxel(pieces.grid(), pieces.level(), voxel);
  return inside ? pieces.ofVoxel(*inside) : Pieces::kNone;
}

}  // namespace isolux::volume
