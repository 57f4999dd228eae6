// The connected pieces of the inside of an isosurface: components of {f >= isovalue} (inside = below: of
// {f <= isovalue}) of the trilinear interpolant, exactly, in cells with ambiguous corners too.
//
// A piece holds at least one voxel, so that a voxel's piece says all. Voxels that are neighbours along an
// axis hang together; cells whose corners do not hang together along their edges are decided by cellPieces().
// Missing voxels belong to no piece, and a cell with one joins nothing and has no volume.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/choices.h"
#include "volume/grid.h"
#include "volume/pieces/piece_blocks.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

class ConcurrentUnionFind;

struct Piece {
  double volumeMm3 = 0.0;  // an estimate; piece_measure.h has it with its error
  std::size_t voxels = 0;  // inside
};

class Pieces {
 public:
  static constexpr std::uint32_t kNone = 0xffffffffu;

  // `blocks`: of the grid's trilinear field, blocks of 8. Multithreaded. Throws Error: interrupted, memory.
  Pieces(std::shared_ptr<const Grid> grid, const MinMaxBlocks& blocks, double isovalue, scene::Inside inside,
         base::Progress& progress);

  double isovalue() const { return isovalue_; }
  scene::Inside inside() const { return inside_; }
  // The largest first; a piece's index is its id. Equal ones: in the order of their first blocks.
  const std::vector<Piece>& list() const { return list_; }

  // The piece of a voxel, and of a point in voxel coordinates; kNone where it is outside, or missing.
  std::uint32_t ofVoxel(glm::ivec3 voxel) const { return ofLabel(blocks_->labelOf(voxel)); }
  std::uint32_t ofPoint(glm::dvec3 voxel) const;

  // Of what they are made: the blocks, and the piece of each of their components.
  const PieceBlocks& blocks() const { return *blocks_; }
  std::uint32_t ofLabel(std::uint32_t node) const {
    return node == PieceBlocks::kNoLabel ? kNone : pieceOfNode_[node];
  }
  InsideLevel level() const { return level_; }
  const Grid& grid() const { return *grid_; }
  bool hasVolume() const;  // not along an axis of one voxel
  std::size_t bytes() const;

 private:
  std::size_t numberRoots(ConcurrentUnionFind& sets);
  void sortBySize();

  std::shared_ptr<const Grid> grid_;
  double isovalue_;
  scene::Inside inside_;
  InsideLevel level_;
  std::unique_ptr<const PieceBlocks> blocks_;
  std::vector<std::uint32_t> pieceOfNode_;
  std::vector<Piece> list_;
  base::MemoryBudget::Held held_;  // all but the blocks
};

// Of a point on the isosurface, up to the rounding of hits; Pieces::kNone where there is none.
std::uint32_t pieceOfSurface(const Pieces& pieces, const glm::dvec3& voxel);

}  // namespace isolux::volume
