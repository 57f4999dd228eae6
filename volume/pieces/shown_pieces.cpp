#include "volume/pieces/shown_pieces.h"

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

std::vector<bool> piecesAt(const Pieces& pieces, const std::vector<glm::dvec3>& pointsMm) {
  std::vector<bool> holds(pieces.list().size());
  for (const glm::dvec3& point : pointsMm) {
    const std::uint32_t piece = pieces.ofPoint(pieces.grid().geometry().voxelOf(point));
    if (piece != Pieces::kNone) holds[piece] = true;
  }
  return holds;
}

void hideBlock(const Pieces& pieces, const std::vector<bool>& shown, glm::ivec3 b, VoxelMask& hidden) {
  const PieceBlocks::View block = pieces.blocks().view(b);
  if (!block.bits) return;
  const auto isShown = [&](std::uint32_t label) { return shown[pieces.ofLabel(label)]; };
  const bool alike = !block.labels;
  if (alike && isShown(block.firstNode)) return;
  const bool whole = alike && pieces.blocks().inside(pieces.blocks().index(b));
  const glm::ivec3 first = b * kPieceBlock, end = glm::min(first + kPieceBlock, hidden.dims());
  for (int z = first.z; z < end.z; ++z)
    for (int y = first.y; y < end.y; ++y) {
      if (whole) {
        hidden.hide(first.x, end.x, y, z);
        continue;
      }
      const glm::ivec3 in(0, y - first.y, z - first.z);
      for (std::uint64_t row = (*block.bits)[static_cast<std::size_t>(in.z)] >> (8 * in.y) & 255u; row != 0;
           row &= row - 1) {
        const int x = std::countr_zero(row);
        if (!isShown(block.labelOf({x, in.y, in.z}))) hidden.hide(first.x + x, first.x + x + 1, y, z);
      }
    }
}

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
  // No other row of blocks along x has voxels in the words of its rows.
  parallelEach(blocks.rows(), [&](std::size_t row) {
    for (glm::ivec3 b = blocks.firstOfRow(row); b.x < blocks.dims.x; ++b.x)
      hideBlock(pieces, shown, b, hidden);
  });
  return hidden;
}

}  // namespace isolux::volume
