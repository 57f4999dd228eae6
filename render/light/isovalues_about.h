// Caches the isovalues of the texels around a block of the light lattice, and computes the field's shape at
// the block's texels and their neighbours. No GL.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "gi/lattice/lattice_geometry.h"
#include "render/light/light_filter.h"

namespace isolux::render {

class IsovaluesAbout {
 public:
  // Returns the isovalue of a texel within the lattice, NaN if a voxel is missing.
  using IsovalueOf = std::function<float(glm::ivec3)>;
  IsovaluesAbout(const gi::LatticeGeometry& lattice, std::uint32_t block, IsovalueOf isovalueOf)
      : lattice_(lattice), first_(lattice.firstTexelOf(block) - kReach), isovalueOf_(std::move(isovalueOf)) {}

  float at(glm::ivec3 texel) {  // NaN outside the lattice
    const glm::ivec3 step = texel - first_;
    const std::size_t i = volume::Extent3{glm::ivec3(kEdge)}.index(step);
    if (!known_[i]) {
      isovalues_[i] = lattice_.contains(texel) ? isovalueOf_(texel) : std::numeric_limits<float>::quiet_NaN();
      known_[i] = true;
    }
    return isovalues_[i];
  }
  FieldShape shapeAt(glm::ivec3 t) {
    const glm::ivec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    return fieldShape(at(t), {at(t - x), at(t - y), at(t - z)}, {at(t + x), at(t + y), at(t + z)});
  }

 private:
  static constexpr int kReach = kFilterBorder + 1, kEdge = gi::kBlockTexels + 2 * kReach;
  static constexpr std::size_t kTexels = std::size_t{kEdge} * kEdge * kEdge;

  const gi::LatticeGeometry& lattice_;
  glm::ivec3 first_;
  IsovalueOf isovalueOf_;
  std::vector<bool> known_ = std::vector<bool>(kTexels);
  std::array<float, kTexels> isovalues_;
};

}  // namespace isolux::render
