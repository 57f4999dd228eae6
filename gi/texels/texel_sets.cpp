#include "gi/texels/texel_sets.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "gi/lattice/texel_bits.h"

namespace isolux::gi {

namespace {

constexpr std::uint32_t kNone = 0xffffffff;

// Blocks in the order in which they come up.
class Collector {
 public:
  explicit Collector(const LatticeGeometry& lattice)
      : lattice_(&lattice), place_(lattice.blockCount(), kNone) {}

  TexelWords& at(std::uint32_t block) {
    if (place_[block] == kNone) {
      place_[block] = static_cast<std::uint32_t>(blocks_.size());
      blocks_.push_back(block);
      words_.emplace_back();
    }
    return words_[place_[block]];
  }
  bool has(std::uint32_t block) const { return place_[block] != kNone; }
  const TexelWords& existing(std::uint32_t block) const { return words_[place_[block]]; }
  const std::vector<std::uint32_t>& blocks() const { return blocks_; }

  // Texels from `from` to `to`, `to.x - from.x` below 8.
  void add(glm::ivec3 from, glm::ivec3 to) {
    const int low = from.x % kBlockTexels, count = to.x - from.x + 1;
    const std::uint64_t bits = ((std::uint64_t{1} << count) - 1) << low;
    for (int z = from.z; z <= to.z; ++z)
      for (int y = from.y; y <= to.y; ++y) {
        const auto slice = static_cast<std::size_t>(z % kBlockTexels);
        const int row = y % kBlockTexels * kBlockTexels;
        at(lattice_->blockOf({from.x, y, z}))[slice] |= (bits & 0xff) << row;
        if (bits > 0xff) at(lattice_->blockOf({to.x, y, z}))[slice] |= (bits >> kBlockTexels) << row;
      }
  }

 private:
  const LatticeGeometry* lattice_;
  std::vector<std::uint32_t> place_;  // of blocks in words_
  std::vector<std::uint32_t> blocks_;
  std::vector<TexelWords> words_;
};

bool isSet(const TexelWords& words, glm::ivec3 texel) {
  return words[static_cast<std::size_t>(texel.z % kBlockTexels)] >>
             (texel.y % kBlockTexels * kBlockTexels + texel.x % kBlockTexels) &
         1;
}

// Texels of a block's neighbour that a step of `texels` (1 to 8) along an axis brings into the block, and
// the block's own. `before`, `self`, `after`: words of the three blocks in a row along the axis.
TexelWords widened(const TexelWords& before, const TexelWords& self, const TexelWords& after, int axis,
                   int texels) {
  constexpr int n = kBlockTexels;
  // Bits of a slice whose coordinate along x is below k.
  const auto below = [](int k) { return 0x0101010101010101u * ((std::uint64_t{1} << k) - 1); };
  TexelWords out = self;
  for (int step = 1; step <= texels; ++step)
    for (int z = 0; z < n; ++z) {
      const auto s = static_cast<std::size_t>(z);
      if (axis == 0) {
        if (step < n) {
          out[s] |= (self[s] & below(n - step)) << step | (self[s] & ~below(step)) >> step;
          out[s] |= (before[s] & ~below(n - step)) >> (n - step) | (after[s] & below(step)) << (n - step);
        } else {
          out[s] |= before[s] | after[s];
        }
      } else if (axis == 1) {
        if (step < n)
          out[s] |= self[s] << (n * step) | self[s] >> (n * step) | before[s] >> (n * (n - step)) |
                    after[s] << (n * (n - step));
        else
          out[s] |= before[s] | after[s];
      } else {
        const int low = z - step, high = z + step;
        out[s] |=
            low >= 0 ? self[static_cast<std::size_t>(low)] : before[s + n - static_cast<std::size_t>(step)];
        out[s] |= high < n ? self[static_cast<std::size_t>(high)] : after[static_cast<std::size_t>(high - n)];
      }
    }
  return out;
}

Collector widenedAlong(const LatticeGeometry& lattice, const Collector& in, int axis, int texels) {
  const glm::ivec3 blocks = lattice.blockDims();
  const volume::Extent3 extent{blocks};
  const auto stride = static_cast<std::uint32_t>(axis == 0 ? 1 : axis == 1 ? extent.row() : extent.slice());
  const TexelWords none{};
  Collector out(lattice);
  const auto wordsOrNone = [&](std::uint32_t block, int at) -> const TexelWords& {
    return at >= 0 && at < blocks[axis] && in.has(block) ? in.existing(block) : none;
  };
  const auto fill = [&](std::uint32_t block, int at) {
    if (at < 0 || at >= blocks[axis] || out.has(block)) return;
    const TexelWords wide = widened(wordsOrNone(block - stride, at - 1), wordsOrNone(block, at),
                                    wordsOrNone(block + stride, at + 1), axis, texels);
    if (wide != none) out.at(block) = wide;
  };
  for (const std::uint32_t block : in.blocks()) {
    const int at = lattice.firstTexelOf(block)[axis] / kBlockTexels;
    fill(block, at);
    fill(block - stride, at - 1);
    fill(block + stride, at + 1);
  }
  return out;
}

}  // namespace

std::vector<BlockRequest> texelsAround(const LatticeGeometry& lattice, std::span<const glm::vec3> hits,
                                       int reach) {
  const auto scale = glm::vec3(lattice.texelOf(glm::dvec3(1.0)));
  const glm::ivec3 lastBase = glm::max(lattice.dims - 2, 0), last = lattice.dims - 1;
  Collector bases(lattice), texels(lattice);
  glm::ivec3 previous(-1);
  for (const glm::vec3& hit : hits) {
    if (!(std::isfinite(hit.x) && std::isfinite(hit.y) && std::isfinite(hit.z))) continue;
    // The lowest of the texels that a trilinear lookup reads. Clamped before it is an integer.
    const glm::ivec3 base(glm::clamp(hit * scale, glm::vec3(0.0f), glm::vec3(lastBase)));
    if (base == previous) continue;
    previous = base;
    TexelWords& seen = bases.at(lattice.blockOf(base));
    if (isSet(seen, base)) continue;
    bases.add(base, base);
    const glm::ivec3 from = glm::max(base - (reach - 1), 0), to = glm::min(base + reach, last);
    texels.add(from, to);
  }
  std::vector<BlockRequest> wanted;
  wanted.reserve(texels.blocks().size());
  for (const std::uint32_t block : texels.blocks()) wanted.push_back({block, bitsOf(texels.existing(block))});
  return wanted;
}

std::vector<BlockRequest> texelsBeside(const LatticeGeometry& lattice, const std::vector<BlockRequest>& inner,
                                       int texels) {
  Collector start(lattice);
  for (const BlockRequest& wanted : inner) start.at(wanted.block) = wordsOf(wanted.texels);
  Collector wide = start;
  for (int axis = 0; axis < 3; ++axis)
    for (int left = texels; left > 0; left -= kBlockTexels)
      wide = widenedAlong(lattice, wide, axis, std::min(left, kBlockTexels));
  std::vector<BlockRequest> wanted;
  for (const std::uint32_t block : wide.blocks()) {
    std::bitset<kTexelsOfBlock> beside = bitsOf(wide.existing(block)) & texelsWithin(lattice, block);
    if (start.has(block)) beside &= ~bitsOf(start.existing(block));
    if (beside.any()) wanted.push_back({block, beside});
  }
  return wanted;
}

std::vector<BlockRequest> allTexels(const LatticeGeometry& lattice) {
  std::vector<BlockRequest> wanted(lattice.blockCount());
  for (std::uint32_t block = 0; block < wanted.size(); ++block)
    wanted[block] = {block, texelsWithin(lattice, block)};
  return wanted;
}

}  // namespace isolux::gi
