#include "app/cluster/tile_wishes.h"

#include "gi/lattice/lattice_part.h"
#include "gi/lattice/texel_bits.h"

namespace isolux::app {

std::vector<std::uint32_t> TileWishes::tiles() const {
  std::vector<std::uint32_t> list;
  for (std::uint32_t tile = 0; tile < of.size(); ++tile)
    if (!of[tile].empty()) list.push_back(tile);
  return list;
}

TileWishes tileWishes(const gi::LatticeGeometry& lattice, const std::vector<gi::WantedBlock>& sky,
                      const std::vector<gi::WantedBlock>& lamps) {
  const gi::LatticeTiles tiles = gi::tilesOf(lattice);
  TileWishes wishes;
  wishes.of.resize(tiles.count);
  const auto add = [&](const std::vector<gi::WantedBlock>& blocks,
                       std::vector<gi::WantedBlock> TileWish::*to) {
    for (const gi::WantedBlock& wanted : blocks) {
      const auto texels = wanted.texels & gi::texelsWithin(lattice, wanted.block);
      if (texels.any()) (wishes.of[tiles.ofBlock.at(wanted.block)].*to).push_back({wanted.block, texels});
    }
  };
  add(sky, &TileWish::sky);
  add(lamps, &TileWish::lamps);
  return wishes;
}

}  // namespace isolux::app
