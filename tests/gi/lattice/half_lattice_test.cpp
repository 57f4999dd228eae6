#include "gi/lattice/half_lattice.h"

#include <memory>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

namespace isolux::gi {
namespace {

// Fills a lattice of 20 x 9 x 8 texels; `normal` of 0: not lit.
template <class Light, class Normal>
std::shared_ptr<LightLattice> latticeOf(const Light& light, const Normal& normal) {
  auto made = std::make_shared<LightLattice>(LatticeGeometry::make({20, 9, 8}, 1.0),
                                             LightContent{LightContent::Kind::irradiance, 1, 0}, "");
  LightLattice& lattice = *made;
  for (std::uint32_t b = 0; b < lattice.geometry().blockCount(); ++b) {
    LatticeBlock block = lattice.dark();
    for (int i = 0; i < kTexelsOfBlock; ++i) {
      const glm::ivec3 texel = lattice.geometry().texelOf(b, i);
      const auto at = static_cast<std::size_t>(i);
      if (!lattice.geometry().contains(texel) || normal(texel) == glm::vec3(0.0f)) continue;
      block.samples[at] = 7;
      block.normals[at] = normal(texel);
      block.means[at] = light(texel);
    }
    lattice.write(b, std::move(block));
  }
  return made;
}

float valueAt(const LightLattice& lattice, glm::ivec3 texel) {
  return lattice.at(lattice.geometry().blockOf(texel))
      ->means[static_cast<std::size_t>(LatticeGeometry::indexInBlock(texel))];
}

constexpr auto kUp = [](glm::ivec3) { return glm::vec3(0.0f, 0.0f, 1.0f); };
const std::vector<glm::ivec3> kInside{{1, 1, 1}, {7, 4, 3}, {8, 4, 3}, {15, 7, 6}, {16, 7, 6}, {18, 7, 6}};

TEST(HalfLattice, LightThatChangesEvenlyIsTheSameInBothHalves) {
  const std::shared_ptr<LightLattice> whole = latticeOf(
      [](glm::ivec3 t) { return 1.0f + 0.5f * static_cast<float>(t.x) - 0.25f * static_cast<float>(t.y); },
      kUp);
  for (const HalfOfTexels half : {HalfOfTexels::even, HalfOfTexels::odd})
    for (const glm::ivec3& texel : kInside)
      EXPECT_FLOAT_EQ(valueAt(*halfOf(*whole, half), texel), valueAt(*whole, texel));
}

TEST(HalfLattice, EachHalfKnowsItsOwnTexelsOnly) {
  const std::shared_ptr<LightLattice> whole =
      latticeOf([](glm::ivec3 t) { return (t.x + t.y + t.z) % 2 == 0 ? 3.0f : 5.0f; }, kUp);
  for (const glm::ivec3& texel : kInside) {
    EXPECT_EQ(valueAt(*halfOf(*whole, HalfOfTexels::even), texel), 3.0f);
    EXPECT_EQ(valueAt(*halfOf(*whole, HalfOfTexels::odd), texel), 5.0f);
  }
}

// Two walls back to back, with a gap of one texel in the first.
TEST(HalfLattice, WhatFacesAnotherWayOrIsNotLitCountsNothing) {
  const auto normal = [](glm::ivec3 t) {
    if (t == glm::ivec3(4, 4, 3)) return glm::vec3(0.0f);
    return glm::vec3(0.0f, 0.0f, t.z < 4 ? -1.0f : 1.0f);
  };
  const std::shared_ptr<LightLattice> whole =
      latticeOf([](glm::ivec3 t) { return t.z < 4 ? 1.0f : 100.0f; }, normal);
  for (const HalfOfTexels half : {HalfOfTexels::even, HalfOfTexels::odd}) {
    const auto halved = halfOf(*whole, half);
    for (const glm::ivec3& texel : {glm::ivec3(5, 4, 3), glm::ivec3(8, 4, 3), glm::ivec3(4, 3, 3)})
      EXPECT_EQ(valueAt(*halved, texel), 1.0f);
    EXPECT_EQ(valueAt(*halved, {4, 4, 4}), 100.0f);
    EXPECT_EQ(valueAt(*halved, {4, 4, 3}), 0.0f);  // stays dark
  }
}

TEST(HalfLattice, AloneATexelKeepsItsOwn) {
  const auto lonely = [](glm::ivec3 t) {
    return t == glm::ivec3(3, 3, 3) ? glm::vec3(1.0f, 0.0f, 0.0f) : glm::vec3(0.0f);
  };
  const std::shared_ptr<LightLattice> whole = latticeOf([](glm::ivec3) { return 2.0f; }, lonely);
  for (const HalfOfTexels half : {HalfOfTexels::even, HalfOfTexels::odd})
    EXPECT_EQ(valueAt(*halfOf(*whole, half), {3, 3, 3}), 2.0f);
}

}  // namespace
}  // namespace isolux::gi
