// What a bake is asked for, tile by tile (gi/lattice/lattice_part.h): the same on every rank.
#pragma once

#include <cstdint>
#include <vector>

#include "gi/lattice/lattice_geometry.h"
#include "gi/lattice/wish.h"

namespace isolux::app {

struct TileWish {
  std::vector<gi::WantedBlock> sky, lamps;  // each block once
  bool empty() const { return sky.empty() && lamps.empty(); }
};

struct TileWishes {
  std::vector<TileWish> of;                  // by the tile's number
  std::vector<std::uint32_t> tiles() const;  // those that have any, in their order
};

TileWishes tileWishes(const gi::LatticeGeometry& lattice, const std::vector<gi::WantedBlock>& sky,
                      const std::vector<gi::WantedBlock>& lamps);

}  // namespace isolux::app
