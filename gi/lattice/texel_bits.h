// Sets of texels of a block as eight words of 64 bits: word z holds the slice z, bit 8 y + x of it a texel.
#pragma once

#include <array>
#include <bit>
#include <bitset>
#include <cstdint>

#include "gi/lattice/lattice_geometry.h"

namespace isolux::gi {

using TexelWords = std::array<std::uint64_t, kBlockTexels>;
static_assert(sizeof(TexelWords) == sizeof(std::bitset<kTexelsOfBlock>));

// std::bitset keeps its bits in words from the lowest on, in every standard library we build with; a test
// holds it to that.
inline TexelWords wordsOf(const std::bitset<kTexelsOfBlock>& texels) {
  return std::bit_cast<TexelWords>(texels);
}
inline std::bitset<kTexelsOfBlock> bitsOf(const TexelWords& words) {
  return std::bit_cast<std::bitset<kTexelsOfBlock>>(words);
}

// Calls visit(index in the block) for each texel, in rising order.
template <typename Visit>
void forEachTexel(const std::bitset<kTexelsOfBlock>& texels, Visit visit) {
  const TexelWords words = wordsOf(texels);
  for (std::size_t z = 0; z < words.size(); ++z)
    for (std::uint64_t word = words[z]; word != 0; word &= word - 1)
      visit(z * 64 + static_cast<std::size_t>(std::countr_zero(word)));
}

// Texels of the block that are within the lattice.
std::bitset<kTexelsOfBlock> texelsWithin(const LatticeGeometry& lattice, std::uint32_t block);

}  // namespace isolux::gi
