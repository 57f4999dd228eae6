// Converts sets of a block's texels to eight 64-bit words: word z holds slice z, bit 8 y + x one texel.
#pragma once

#include <array>
#include <bit>
#include <bitset>
#include <cstdint>

#include "gi/lattice/lattice_geometry.h"

namespace isolux::gi {

using TexelWords = std::array<std::uint64_t, kBlockTexels>;
static_assert(sizeof(TexelWords) == sizeof(std::bitset<kTexelsOfBlock>));

// Relies on std::bitset storing its bits in words from the lowest on, as every supported standard library
// does; a test checks it.
inline TexelWords wordsOf(const std::bitset<kTexelsOfBlock>& texels) {
  return std::bit_cast<TexelWords>(texels);
}
inline std::bitset<kTexelsOfBlock> bitsOf(const TexelWords& words) {
  return std::bit_cast<std::bitset<kTexelsOfBlock>>(words);
}

// Calls visit(index in the block) for each texel, in ascending order.
template <typename Visit>
void forEachTexel(const std::bitset<kTexelsOfBlock>& texels, Visit visit) {
  const TexelWords words = wordsOf(texels);
  for (std::size_t z = 0; z < words.size(); ++z)
    for (std::uint64_t word = words[z]; word != 0; word &= word - 1)
      visit(z * 64 + static_cast<std::size_t>(std::countr_zero(word)));
}

// Returns the texels of the block that are within the lattice.
std::bitset<kTexelsOfBlock> texelsWithin(const LatticeGeometry& lattice, std::uint32_t block);

}  // namespace isolux::gi
