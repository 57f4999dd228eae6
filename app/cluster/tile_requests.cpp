#include "app/cluster/tile_requests.h"

#include "gi/lattice/lattice_part.h"
#include "gi/lattice/texel_bits.h"

namespace isolux::app {

std::vector<std::uint32_t> TileRequests::tiles() const {
  std::vector<std::uint32_t> list;
  for (std::uint32_t tile = 0; tile < of.size(); ++tile)
    if (!of[tile].empty()) list.push_back(tile);
  return list;
}

TileRequests tileRequests(const gi::LatticeGeometry& lattice, const std::vector<gi::BlockRequest>& sky,
                          const std::vector<gi::BlockRequest>& lamps) {
  const gi::LatticeTiles tiles = gi::tilesOf(lattice);
  TileRequests requests;
  requests.of.resize(tiles.count);
  const auto add = [&](const std::vector<gi::BlockRequest>& blocks,
                       std::vector<gi::BlockRequest> TileRequest::*to) {
    for (const gi::BlockRequest& wanted : blocks) {
      const auto texels = wanted.texels & gi::texelsWithin(lattice, wanted.block);
      if (texels.any()) (requests.of[tiles.ofBlock.at(wanted.block)].*to).push_back({wanted.block, texels});
    }
  };
  add(sky, &TileRequest::sky);
  add(lamps, &TileRequest::lamps);
  return requests;
}

}  // namespace isolux::app
