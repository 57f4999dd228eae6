// Compression of transfer vectors to a few principal components, in 8 or 16 bits each.
//
// A transfer vector of D = channels * order^2 numbers is written as mean + sum_k c_k B_k. Lighting then needs
// no decompression: E = mean . l + sum_k c_k (B_k . l), with the dot products made once a frame (Sloan et al.
// 2003, "Clustered Principal Components", with one cluster). Wyman et al. 2006 store D floats.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

class TransferBasis {
 public:
  // From the baked texels of a lattice, at most `mostTexels` of them, evenly chosen. Null if there are none.
  // `components` is cut to D. Errors count by what they do to E under usual environments, whose coefficients
  // fall with the band of spherical harmonics. Throws Error{interrupted} within 100 ms of a stop of
  // `progress`.
  static std::shared_ptr<const TransferBasis> fit(const LightLattice& lattice, int components, int bits,
                                                  const base::Progress* progress = nullptr,
                                                  std::size_t mostTexels = 20000);

  int components() const { return static_cast<int>(low_.size()); }
  int bits() const { return bits_; }  // 8 or 16
  std::size_t bytesPerTexel() const { return low_.size() * static_cast<std::size_t>(bits_ / 8); }
  const LightContent& content() const { return content_; }
  // Of component k: c = low + code * step.
  float low(int component) const { return low_[static_cast<std::size_t>(component)]; }
  float step(int component) const { return step_[static_cast<std::size_t>(component)]; }

  // Codes are unsigned integers: c_k = low_k + code * step_k, over the range of the texels that the basis is
  // from and a little more; what is beyond is clamped. `codes`: bytesPerTexel() bytes, 16 bits little endian.
  void encode(std::span<const float> transfer, std::span<std::uint8_t> codes) const;
  void decode(std::span<const std::uint8_t> codes, std::span<float> transfer) const;

  // What a picture needs under an environment of order^2 rgb coefficients: E = offset + sum_k code_k
  // factor_k.
  struct Lighting {
    glm::vec3 offset{0.0f};
    std::vector<glm::vec3> factors;  // of integer codes
  };
  Lighting under(std::span<const glm::vec3> environment) const;

 private:
  LightContent content_;
  int bits_ = 8;
  std::vector<float> mean_, basis_;  // D; components x D
  std::vector<float> projection_;    // components x D: c = projection (transfer - mean)
  std::vector<float> low_, step_;    // step 0: that component is the same in all texels
};

}  // namespace isolux::gi
