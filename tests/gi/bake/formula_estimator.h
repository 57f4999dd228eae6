// Light that is a formula of texel and sample, and the lattice it must give.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "gi/bake/light_bake.h"

namespace isolux::gi {

class FormulaEstimator : public TexelEstimator {
 public:
  explicit FormulaEstimator(LightContent content = {LightContent::Kind::irradiance, 3, 0})
      : content_(content) {}

  LightContent content() const override { return content_; }
  void points(std::span<const glm::ivec3> texels, std::span<TexelPoint> points) const override;
  bool add(std::span<const glm::ivec3> texels, std::span<const TexelPoint> points, SampleRange range,
           std::span<double> sums, std::uint64_t& rays, const std::stop_token& stop) const override;

  // One texel in seven has no normal.
  static glm::vec3 normalOf(glm::ivec3 texel);
  static float meanOf(glm::ivec3 texel, SampleRange range, int component);
  // What a bake must give that goes through `rounds`.
  static float bakedOf(glm::ivec3 texel, const std::vector<std::uint32_t>& rounds, int component);

  // Called by add() first, on the thread of the bake; false: as if stopped.
  std::function<bool(std::span<const glm::ivec3>, SampleRange, std::stop_token)> before;
  mutable std::atomic<std::uint64_t> calls{0}, paths{0};

 private:
  LightContent content_;
};

// All texels of the lattice, or those for which `chosen` is true, in order of blocks.
std::vector<BlockRequest> texelsWhere(const LatticeGeometry& lattice,
                                      const std::function<bool(glm::ivec3)>& chosen);

// Compares every texel with the formula at its number of samples, whose rounds are those up to `samples`;
// returns the first difference in words, or nothing.
std::string differenceFrom(const LightLattice& lattice, std::uint32_t samples);
// Whether each texel of `wanted` has exactly `samples` or no normal.
bool allHave(const LightLattice& lattice, const std::vector<BlockRequest>& wanted, std::uint32_t samples);

}  // namespace isolux::gi
