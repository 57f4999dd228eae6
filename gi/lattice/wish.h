// Defines requests to a bake: texels and their priority.
#pragma once

#include <bitset>
#include <cstdint>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// Requested texels of one block.
struct WantedBlock {
  std::uint32_t block = 0;
  std::bitset<kTexelsOfBlock> texels;
  bool operator==(const WantedBlock&) const = default;
};

// Priorities, in the order in which they are served.
enum class Wish { visible, nearby, band, rest };

}  // namespace isolux::gi
