#include "volume/pieces/pieces.h"

#include <algorithm>
#include <numeric>

#include "volume/hit/cell_pieces.h"
#include "volume/hit/surface_voxel.h"
#include "volume/pieces/concurrent_union_find.h"
#include "volume/pieces/join_blocks.h"
#include "volume/pieces/piece_sizes.h"

namespace isolux::volume {

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
