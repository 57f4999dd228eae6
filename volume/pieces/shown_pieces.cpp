#include "volume/pieces/shown_pieces.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

std::vector<bool> piecesAt(const Pieces& pieces, const std::vector<glm::dvec3>& pointsMm) {
  std::vector<bool> holds(pieces.list().size());
  const glm::dmat4 voxelFromWorld = pieces.grid().geometry().voxelFromWorld();
  for (const glm::dvec3& point : pointsMm) {
    const std::uint32_t piece = pieces.ofPoint(glm::dvec3(voxelFromWorld * glm::dvec4(point, 1.0)));
    if (piece != Pieces::kNone) holds[piece] = true;
  }
  return holds;
}

// A row of blocks along x: no other row of blocks has voxels in the words of its rows.
class RowOfHidden {
 public:
  RowOfHidden(const Pieces& pieces, const std::vector<bool>& shown, VoxelMask& hidden)
      : pieces_(pieces), shown_(shown), hidden_(hidden) {}

  void block(glm::ivec3 b) {
    const PieceBlocks::View block = pieces_.blocks().view(b);
    if (!block.bits) return;
    const glm::ivec3 first = b * kPieceBlock, end = glm::min(first + kPieceBlock, hidden_.dims());
    const bool alike = !block.labels;
    if (alike && isShown(block.firstNode)) return;
    for (int z = first.z; z < end.z; ++z)
      for (int y = first.y; y < end.y; ++y)
        if (alike && pieces_.blocks().inside(pieces_.blocks().index(b)))
          hidden_.hide(first.x, end.x, y, z);
        else
          hideRow(block, first, y, z);
  }

 private:
  bool isShown(std::uint32_t node) const { return shown_[pieces_.ofLabel(node)]; }

  void hideRow(const PieceBlocks::View& block, glm::ivec3 first, int y, int z) {
    unsigned row =
        static_cast<unsigned>((*block.bits)[static_cast<std::size_t>(z - first.z)] >> (8 * (y - first.y))) &
        255u;
    for (; row != 0; row &= row - 1) {
      const int x = std::countr_zero(row);
      if (!isShown(block.labelOf({x, y - first.y, z - first.z})))
        hidden_.hide(first.x + x, first.x + x + 1, y, z);
    }
  }

  const Pieces& pieces_;
  const std::vector<bool>& shown_;
  VoxelMask& hidden_;
};

}  // namespace

bool hidesStrays(const scene::Pieces& choice) {
  return choice.keep > 0 || choice.smallest > 0.0 || !choice.only.empty() || choice.within;
}

bool hidesPieces(const scene::Pieces& choice) {
  return hidesStrays(choice) || !choice.hidden.empty();
}

std::vector<bool> shownPieces(const Pieces& pieces, const scene::Pieces& choice, const Body* body) {
  if (choice.within && !body) throw std::logic_error("pieces within a body that was not computed");
  const std::vector<std::uint64_t> voxelsWithin =
      choice.within ? voxelsInBody(pieces, *body, choice.depth) : std::vector<std::uint64_t>{};
  const std::vector<bool> hidden = piecesAt(pieces, choice.hidden), only = piecesAt(pieces, choice.only);
  std::vector<bool> shown(pieces.list().size());
  for (std::size_t i = 0; i < shown.size(); ++i)
    shown[i] = (choice.keep == 0 || i < static_cast<std::size_t>(choice.keep)) &&
               pieces.list()[i].volumeMm3 >= choice.smallest && !hidden[i] &&
               (choice.only.empty() || only[i]) &&
               (!choice.within || 2 * voxelsWithin[i] >= pieces.list()[i].voxels);
  return shown;
}

VoxelMask hiddenVoxels(const Pieces& pieces, const std::vector<bool>& shown, bool hidesStrays) {
  VoxelMask hidden(pieces.grid().dims(), hidesStrays);
  if (std::find(shown.begin(), shown.end(), false) == shown.end()) return hidden;
  const Extent3 blocks{pieces.blocks().dims()};
  parallelEach(blocks.rows(), [&](std::size_t row) {
    RowOfHidden hide(pieces, shown, hidden);
    for (glm::ivec3 b = blocks.firstOfRow(row); b.x < blocks.dims.x; ++b.x) hide.block(b);
  });
  return hidden;
}

}  // namespace isolux::volume
