// Defines requests to a bake: texels and their priority.
#pragma once

#include <bitset>
#include <cstdint>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// Requested texels of one block.
struct BlockRequest {
  std::uint32_t block = 0;
  std::bitset<kTexelsOfBlock> texels;
  bool operator==(const BlockRequest&) const = default;
};

// Priorities, in the order in which they are served.
enum class Priority { visible, nearby, band, rest };

}  // namespace isolux::gi
