// Compresses transfer vectors (precomputed radiance transfer) to a few principal components of unequal bits.
//
// A transfer vector of D = channels * order^2 numbers is written as mean + sum_k c_k B_k. Lighting then needs
// no decompression: E = mean . l + sum_k c_k (B_k . l), with the dot products computed once per frame (Sloan
// et al. 2003, "Clustered Principal Components", with one cluster). Wyman et al. 2006 store D floats. Each
// bit is allocated to the component where it reduces the error most (Huang & Schultheiss 1963). The first
// components therefore get several times as many as the last, and useless ones get none.
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
  // The bit field of one component in the words of a texel. (words[word] >> shift) & ((1 << bits) - 1) is its
  // code, and c = low + code * step. No field spans two words.
  struct Field {
    int word = 0, shift = 0, bits = 0;
    float low = 0.0f, step = 0.0f;  // step 0: the component is equal in all texels
    bool operator==(const Field&) const = default;
  };

  // Fits a basis to the baked texels of lattices of the same content, at most `mostTexels` of them, evenly
  // chosen. Returns null if no texel is baked.
  //
  // `bits` per texel, for at most `components` components, are rounded up to whole words. Errors are weighted
  // by their effect on E under usual environments, whose coefficients fall with the SH band. Throws
  // Error{interrupted} within 100 ms of a stop of `progress`.
  static std::shared_ptr<const TransferBasis> fit(std::span<const LightLattice* const> lattices,
                                                  int components, int bits,
                                                  const base::Progress* progress = nullptr,
                                                  std::size_t mostTexels = 20000);

  const std::vector<Field>& fields() const { return fields_; }  // of the components that have any bits
  std::size_t words() const { return words_; }                  // 32-bit words per texel
  const LightContent& content() const { return content_; }

  // Encodes a transfer vector; values beyond the range of a field are clamped. `words` has words() elements.
  void encode(std::span<const float> transfer, std::span<std::uint32_t> words) const;
  std::uint32_t code(std::span<const std::uint32_t> words, std::size_t component) const;

  // The factors of a frame under an environment of order^2 RGB coefficients: E = offset + sum_k code_k
  // factor_k.
  struct Lighting {
    glm::vec3 offset{0.0f};
    std::vector<glm::vec3> factors;  // of integer codes
  };
  Lighting under(std::span<const glm::vec3> environment) const;

 private:
  LightContent content_;
  std::size_t words_ = 0;
  std::vector<float> mean_, basis_;  // D; components x D
  std::vector<float> projection_;    // components x D: c = projection (transfer - mean)
  std::vector<Field> fields_;
};

}  // namespace isolux::gi
