// Divides a lattice's texels into parts, for bakes that machines do independently of each other.
//
// Tiles are 4 x 4 x 4 blocks (32^3 texels; fewer at the upper border). Their order is the Morton order of
// their positions, with x in the lowest bit. Part i of n contains every tile whose number in that order is i
// modulo n. Neighbouring tiles belong to different parts, so that parts take about equally long. The parts of
// one n are disjoint and cover the lattice; with fewer tiles than parts, some are empty.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

inline constexpr int kTileBlocks = 4;  // per axis
inline constexpr int kMostParts = 1 << 20;

struct LatticePart {
  int index = 1, count = 1;  // 1 <= index <= count
  bool operator==(const LatticePart&) const = default;
};

std::string partWords(LatticePart part);  // "part 2 of 5"

// The number of tiles, and the number of each block's tile in Morton order.
struct LatticeTiles {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> ofBlock;
};
LatticeTiles tilesOf(const LatticeGeometry& lattice);

// Returns those of `blocks` that belong to the part, in their order.
std::vector<BlockRequest> blocksOfPart(const LatticeGeometry& lattice, LatticePart part,
                                       std::vector<BlockRequest> blocks);

}  // namespace isolux::gi
