#include "volume/pieces/piece_sizes.h"

#include <atomic>
#include <bit>
#include <cmath>

#include <glm/matrix.hpp>

#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

// The voxels of the pieces in a row of blocks, handed on whenever another piece comes.
class VoxelCounts {
 public:
  VoxelCounts(const Pieces& pieces, std::vector<std::uint64_t>& all) : pieces_(pieces), all_(all) {}
  ~VoxelCounts() { handOn(); }
  VoxelCounts(const VoxelCounts&) = delete;
  VoxelCounts& operator=(const VoxelCounts&) = delete;

  void addBlock(glm::ivec3 b) {
    const PieceBlocks& blocks = pieces_.blocks();
    const PieceBlocks::View block = blocks.view(b);
    if (!block.bits) return;
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
        add(block.nodeOf({bit % 8, bit / 8, z}), 1);
      }
    }
  }

 private:
  void add(std::uint32_t node, int voxels) {
    const std::uint32_t piece = pieces_.ofNode(node);
    if (piece != piece_) {
      handOn();
      piece_ = piece;
    }
    sum_ += static_cast<std::uint64_t>(voxels);
  }
  void handOn() {
    if (sum_ != 0) std::atomic_ref(all_[piece_]).fetch_add(sum_, std::memory_order_relaxed);
    sum_ = 0;
  }

  const Pieces& pieces_;
  std::vector<std::uint64_t>& all_;
  std::uint32_t piece_ = Pieces::kNone;
  std::uint64_t sum_ = 0;
};

}  // namespace

std::vector<Piece> pieceSizes(const Pieces& pieces, std::size_t count, const NodeVolumes& nodeVolumes,
                              base::Progress& progress) {
  const glm::ivec3 dims = pieces.blocks().dims();
  std::vector<std::uint64_t> voxels(count), volumes(count);
  parallelSteps(static_cast<std::size_t>(dims.y) * static_cast<std::size_t>(dims.z), progress,
                {0.9, 1.0, "measuring pieces"}, [&](std::size_t row) {
                  VoxelCounts counts(pieces, voxels);
                  glm::ivec3 b(0, static_cast<int>(row) % dims.y, static_cast<int>(row) / dims.y);
                  for (; b.x < dims.x; ++b.x) counts.addBlock(b);
                });
  for (std::uint32_t node = 0; node < pieces.blocks().nodes(); ++node)
    volumes[pieces.ofNode(node)] += nodeVolumes[node];
  const double cellMm3 = std::abs(glm::determinant(glm::dmat3(pieces.grid().geometry().worldFromVoxel)));
  std::vector<Piece> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = {static_cast<double>(volumes[i]) / kVolumeUnits * cellMm3, voxels[i]};
  return result;
}

}  // namespace isolux::volume
