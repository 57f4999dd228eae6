#include "gi/lattice/half_lattice.h"

#include <algorithm>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

namespace isolux::gi {

namespace {

constexpr float kLeastAgreement = 1e-3f;  // of all neighbours together: less is none

class HalvedBlock {
 public:
  HalvedBlock(const LightLattice& lattice, std::uint32_t index, const LatticeBlock& block)
      : lattice_(lattice),
        index_(index),
        block_(block),
        components_(static_cast<std::size_t>(lattice.content().components())),
        sum_(components_) {}

  // Overwrites `mean`, of the texel `i` of the block, where neighbours say what it is.
  void interpolate(std::size_t i, std::span<float> mean) {
    const glm::ivec3 texel = lattice_.geometry().texelOf(index_, static_cast<int>(i));
    std::fill(sum_.begin(), sum_.end(), 0.0f);
    float agreement = 0.0f, whole = 0.0f;
    for (int n = 0; n < 6; ++n) {
      glm::ivec3 other = texel;
      other[n / 2] += n % 2 == 0 ? -1 : 1;
      if (lattice_.geometry().contains(other)) add(other, block_.normals[i], agreement, whole);
    }
    if (agreement < kLeastAgreement) return;
    for (std::size_t c = 0; c < components_; ++c) mean[c] = sum_[c] / whole;
  }

 private:
  void add(glm::ivec3 texel, glm::vec3 normal, float& agreement, float& whole) {
    const std::uint32_t index = lattice_.geometry().blockOf(texel);
    const LatticeBlock* block = &block_;
    if (index != index_) {
      if (!neighbour_ || index != neighbourIndex_) neighbour_ = lattice_.at(index);
      neighbourIndex_ = index;
      block = neighbour_.get();
    }
    if (!block) return;
    const auto i = static_cast<std::size_t>(LatticeGeometry::indexInBlock(texel));
    if (block->samples[i] == 0) return;
    const float cosine = std::max(glm::dot(block->normals[i], normal), 0.0f), c2 = cosine * cosine;
    const float weight = c2 * c2 * static_cast<float>(block->samples[i]);
    agreement += c2 * c2;
    whole += weight;
    for (std::size_t c = 0; c < components_; ++c) sum_[c] += weight * block->means[i * components_ + c];
  }

  const LightLattice& lattice_;
  std::uint32_t index_;
  const LatticeBlock& block_;
  std::size_t components_;
  std::vector<float> sum_;
  std::uint32_t neighbourIndex_ = 0;
  std::shared_ptr<const LatticeBlock> neighbour_;
};

bool isOf(HalfOfTexels half, glm::ivec3 texel) {
  return ((texel.x + texel.y + texel.z) & 1) == (half == HalfOfTexels::odd ? 1 : 0);
}

}  // namespace

std::shared_ptr<LightLattice> halfOf(const LightLattice& lattice, HalfOfTexels half) {
  auto result = std::make_shared<LightLattice>(lattice.geometry(), lattice.content(), lattice.key());
  const auto components = static_cast<std::size_t>(lattice.content().components());
  for (std::uint32_t b = 0; b < lattice.geometry().blockCount(); ++b) {
    const std::shared_ptr<const LatticeBlock> block = lattice.at(b);
    if (!block) continue;
    LatticeBlock halved = result->dark();
    halved.samples = block->samples;
    halved.normals = block->normals;
    halved.places = block->places;
    halved.unlit = block->unlit;
    halved.means = block->means;
    HalvedBlock interpolated(lattice, b, *block);
    for (std::size_t i = 0; i < static_cast<std::size_t>(kTexelsOfBlock); ++i)
      if (block->samples[i] > 0 && !isOf(half, lattice.geometry().texelOf(b, static_cast<int>(i))))
        interpolated.interpolate(i, {halved.means.data() + i * components, components});
    result->write(b, std::move(halved));
  }
  return result;
}

}  // namespace isolux::gi
