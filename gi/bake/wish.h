// What a bake is asked for: texels, and how urgent they are.
#pragma once

#include <bitset>
#include <cstdint>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// Texels of one block.
struct WantedBlock {
  std::uint32_t block = 0;
  std::bitset<kTexelsOfBlock> texels;
  bool operator==(const WantedBlock&) const = default;
};

// In the order in which they are served.
enum class Wish { visible, nearby, band, rest };

}  // namespace isolux::gi
