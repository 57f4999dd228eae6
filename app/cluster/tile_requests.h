// Lists the texels requested of a bake by tile (gi/lattice/lattice_part.h); the list is the same on every
// rank.
#pragma once

#include <cstdint>
#include <vector>

#include "gi/lattice/light_lattice.h"

namespace isolux::app {

struct TileRequest {
  std::vector<gi::BlockRequest> sky, lamps;  // each block once
  bool empty() const { return sky.empty() && lamps.empty(); }
};

struct TileRequests {
  std::vector<TileRequest> of;               // by the tile's number
  std::vector<std::uint32_t> tiles() const;  // those that have any, in their order
};

TileRequests tileRequests(const gi::LatticeGeometry& lattice, const std::vector<gi::BlockRequest>& sky,
                          const std::vector<gi::BlockRequest>& lamps);

}  // namespace isolux::app
