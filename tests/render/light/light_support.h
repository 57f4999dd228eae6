// Stored light by formulas, for tests of the passes that read it.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "gi/picture_light.h"

namespace isolux::test {

// What a texel holds: samples 0 is not baked.
struct TexelLight {
  std::uint32_t samples = 100;
  glm::vec3 normal{0.0f, 0.0f, 1.0f};
  std::vector<float> means;
  bool unlit = false;
};
using TexelFormula = std::function<TexelLight(glm::ivec3 texel)>;

inline std::shared_ptr<gi::LightLattice> emptyLattice(glm::ivec3 volumeDims, double scale,
                                                      gi::LightContent content = {}) {
  return std::make_shared<gi::LightLattice>(gi::LatticeGeometry::make(volumeDims, scale), content, "test");
}

// Writes one block by the formula.
inline void writeBlock(gi::LightLattice& lattice, std::uint32_t block, const TexelFormula& formula) {
  const auto components = static_cast<std::size_t>(lattice.content().components());
  gi::LatticeBlock out = lattice.dark();
  for (int i = 0; i < gi::kTexelsOfBlock; ++i) {
    const glm::ivec3 texel = lattice.geometry().texelOf(block, i);
    if (!lattice.geometry().contains(texel)) continue;
    const auto at = static_cast<std::size_t>(i);
    const TexelLight light = formula(texel);
    out.samples[at] = light.samples;
    out.normals[at] = light.samples > 0 ? light.normal : glm::vec3(0.0f);
    out.unlit[at] = light.unlit;
    if (!out.places.empty()) out.places[at] = lattice.geometry().voxelOf(texel);
    // A lattice of one channel takes the first.
    std::copy_n(light.means.begin(), std::min(components, light.means.size()),
                out.means.begin() + static_cast<std::ptrdiff_t>(at * components));
  }
  lattice.write(block, out);
}

inline void writeAll(gi::LightLattice& lattice, const TexelFormula& formula) {
  for (std::uint32_t block = 0; block < lattice.geometry().blockCount(); ++block)
    writeBlock(lattice, block, formula);
}

inline std::shared_ptr<gi::PictureLight> pictureLight(std::shared_ptr<const gi::LightLattice> sky,
                                                      std::uint64_t version = 1) {
  auto light = std::make_shared<gi::PictureLight>();
  light->sky = std::move(sky);
  light->version = version;
  return light;
}

}  // namespace isolux::test
