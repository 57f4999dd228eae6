#include "gi/lattice/lattice_part.h"

#include <algorithm>
#include <numeric>

namespace isolux::gi {

namespace {

// Bit b of the result is bit b / 3 of the place along axis b % 3.
std::uint64_t mortonCode(glm::ivec3 place) {
  std::uint64_t code = 0;
  constexpr int bits = 21;
  for (int bit = 0; bit < bits; ++bit)
    for (int a = 0; a < 3; ++a) code |= (static_cast<std::uint64_t>(place[a]) >> bit & 1u) << (3 * bit + a);
  return code;
}

}  // namespace

std::string partWords(LatticePart part) {
  return "part " + std::to_string(part.index) + " of " + std::to_string(part.count);
}

LatticeTiles tilesOf(const LatticeGeometry& lattice) {
  const glm::ivec3 blocks = lattice.blockDims(), tiles = (blocks + (kTileBlocks - 1)) / kTileBlocks;
  std::vector<std::uint64_t> codes;
  volume::forEachIn(glm::ivec3(0), tiles, [&](glm::ivec3 tile) { codes.push_back(mortonCode(tile)); });
  std::vector<std::uint32_t> order(codes.size()), number(codes.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;

  LatticeTiles result{static_cast<std::uint32_t>(codes.size()), {}};
  result.ofBlock.reserve(lattice.blockCount());
  volume::forEachIn(glm::ivec3(0), blocks, [&](glm::ivec3 block) {
    result.ofBlock.push_back(number[volume::Extent3{tiles}.index(block / kTileBlocks)]);
  });
  return result;
}

std::vector<BlockRequest> blocksOfPart(const LatticeGeometry& lattice, LatticePart part,
                                       std::vector<BlockRequest> blocks) {
  if (part.count <= 1) return blocks;
  const LatticeTiles tiles = tilesOf(lattice);
  const auto count = static_cast<std::uint32_t>(part.count), index = static_cast<std::uint32_t>(part.index);
  std::erase_if(blocks, [&](const BlockRequest& wanted) {
    return wanted.block >= tiles.ofBlock.size() || tiles.ofBlock[wanted.block] % count != index % count;
  });
  return blocks;
}

}  // namespace isolux::gi
