#include "app/cluster/tile_bytes.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "gi/lattice/texel_bits.h"
#include "volume/read/process/wire.h"

namespace isolux::app {

namespace {

using Texels = std::bitset<gi::kTexelsOfBlock>;

void appendRaw(std::string& to, const void* bytes, std::size_t count) {
  to.append(static_cast<const char*>(bytes), count);
}

void appendBits(std::string& to, const Texels& bits) {
  const gi::TexelWords words = gi::wordsOf(bits);
  appendRaw(to, words.data(), sizeof words);
}

// Texels that hold anything.
Texels texelsOf(const gi::LatticeBlock& block) {
  Texels texels;
  for (std::size_t i = 0; i < texels.size(); ++i)
    texels[i] = block.samples[i] > 0 || block.normals[i] != glm::vec3(0.0f);
  return texels;
}

class RawReader {
 public:
  explicit RawReader(std::string_view bytes) : rest_(bytes) {}
  bool done() const { return rest_.empty(); }
  void take(void* to, std::size_t count) {
    if (count > rest_.size()) volume::throwBadAnswer("a tile is cut off");
    std::memcpy(to, rest_.data(), count);
    rest_.remove_prefix(count);
  }
  Texels bits() {
    gi::TexelWords words{};
    take(words.data(), sizeof words);
    return gi::bitsOf(words);
  }

 private:
  std::string_view rest_;
};

}  // namespace

std::string tileBytes(const gi::LightLattice& lattice, std::span<const gi::BlockRequest> blocks) {
  const auto components = static_cast<std::size_t>(lattice.content().components());
  std::string bytes;
  for (const gi::BlockRequest& wanted : blocks) {
    const auto block = lattice.at(wanted.block);
    if (!block) continue;
    const Texels texels = texelsOf(*block);
    appendRaw(bytes, &wanted.block, sizeof wanted.block);
    appendBits(bytes, block->unlit);
    appendBits(bytes, texels);
    gi::forEachTexel(texels, [&](std::size_t i) {
      appendRaw(bytes, &block->samples[i], sizeof block->samples[i]);
      appendRaw(bytes, &block->normals[i], sizeof block->normals[i]);
      if (!block->places.empty()) appendRaw(bytes, &block->places[i], sizeof block->places[i]);
      appendRaw(bytes, block->means.data() + i * components, components * sizeof(float));
    });
  }
  return bytes;
}

void takeTileBytes(std::string_view bytes, std::span<const gi::BlockRequest> blocks, gi::LightLattice& into) {
  const auto components = static_cast<std::size_t>(into.content().components());
  std::vector<std::pair<std::uint32_t, gi::LatticeBlock>> read;
  for (RawReader in(bytes); !in.done();) {
    std::uint32_t number = 0;
    in.take(&number, sizeof number);
    if (std::ranges::none_of(blocks, [&](const auto& b) { return b.block == number; }))
      volume::throwBadAnswer("a tile has a block of another one");
    gi::LatticeBlock block = into.dark();
    block.unlit = in.bits();
    gi::forEachTexel(in.bits(), [&](std::size_t i) {
      in.take(&block.samples[i], sizeof block.samples[i]);
      in.take(&block.normals[i], sizeof block.normals[i]);
      if (!block.places.empty()) in.take(&block.places[i], sizeof block.places[i]);
      in.take(block.means.data() + i * components, components * sizeof(float));
    });
    read.emplace_back(number, std::move(block));
  }
  for (auto& [number, block] : read) into.write(number, std::move(block));
}

std::uint64_t pathsOf(const gi::LightLattice& lattice, std::span<const gi::BlockRequest> blocks) {
  std::uint64_t paths = 0;
  for (const gi::BlockRequest& wanted : blocks)
    if (const auto block = lattice.at(wanted.block))
      gi::forEachTexel(wanted.texels, [&](std::size_t i) { paths += block->samples[i]; });
  return paths;
}

}  // namespace isolux::app
