// Shares of a lattice's texels, for bakes that machines do without knowing of each other.
//
// Tiles are 4 x 4 x 4 blocks (32^3 texels; fewer at the upper border), in Morton order of their places (the
// lowest bit is x's). Part i of n has every tile whose number in that order is i modulo n: neighbouring tiles
// belong to different parts, so that parts take about equally long. Parts of one n are disjoint, and together
// they are the whole; where there are fewer tiles than parts, some are empty.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gi/bake/wish.h"
#include "gi/lattice/lattice_geometry.h"

namespace isolux::gi {

inline constexpr int kTileBlocks = 4;  // per axis
inline constexpr int kMostParts = 1 << 20;

struct LatticePart {
  int index = 1, count = 1;  // 1 <= index <= count
  bool operator==(const LatticePart&) const = default;
};

std::string partWords(LatticePart part);  // "part 2 of 5"

// The number of tiles, and of each block its tile's number in Morton order.
struct LatticeTiles {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> ofBlock;
};
LatticeTiles tilesOf(const LatticeGeometry& lattice);

// Those of `blocks` that belong to the part, in their order.
std::vector<WantedBlock> blocksOfPart(const LatticeGeometry& lattice, LatticePart part,
                                      std::vector<WantedBlock> blocks);

}  // namespace isolux::gi
