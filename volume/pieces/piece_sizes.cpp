#include "volume/pieces/piece_sizes.h"

#include <bit>
#include <cmath>

#include <glm/matrix.hpp>

#include "volume/parallel/parallel_steps.h"
#include "volume/pieces/running_sums.h"

namespace isolux::volume {

namespace {

// The voxels of the pieces in a row of blocks.
class VoxelCounts {
 public:
  VoxelCounts(const Pieces& pieces, std::vector<std::uint64_t>& all) : pieces_(pieces), counts_(all) {}

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
        add(block.labelOf({bit % 8, bit / 8, z}), 1);
      }
    }
  }

 private:
  void add(std::uint32_t node, int voxels) {
    counts_.add(pieces_.ofLabel(node), static_cast<std::uint64_t>(voxels));
  }

  const Pieces& pieces_;
  RunningSums counts_;
};

}  // namespace

std::vector<Piece> pieceSizes(const Pieces& pieces, std::size_t count, const NodeVolumes& nodeVolumes,
                              base::Progress& progress) {
  const Extent3 blocks{pieces.blocks().dims()};
  std::vector<std::uint64_t> voxels(count), volumes(count);
  parallelSteps(blocks.rows(), progress, {0.9, 1.0, "measuring pieces"}, [&](std::size_t row) {
    VoxelCounts counts(pieces, voxels);
    for (glm::ivec3 b = blocks.firstOfRow(row); b.x < blocks.dims.x; ++b.x) counts.addBlock(b);
  });
  for (std::uint32_t node = 0; node < pieces.blocks().nodes(); ++node)
    volumes[pieces.ofLabel(node)] += nodeVolumes[node];
  const double cellMm3 = pieces.grid().geometry().voxelMm3();
  std::vector<Piece> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = {static_cast<double>(volumes[i]) / kVolumeUnits * cellMm3, voxels[i]};
  return result;
}

}  // namespace isolux::volume
