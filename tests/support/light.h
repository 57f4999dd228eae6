// Light in tests.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "gi/harmonics/transfer_basis.h"

namespace isolux::test {

// The basis of one lattice alone.
inline std::shared_ptr<const gi::TransferBasis> basisOf(const gi::LightLattice& lattice, int components,
                                                        int bits, std::size_t mostTexels = 20000) {
  const gi::LightLattice* const one = &lattice;
  return gi::TransferBasis::fit(std::span(&one, 1), components, bits, nullptr, mostTexels);
}

// The transfer vector that the words of a texel stand for: its light under each coefficient alone.
inline std::vector<float> decoded(const gi::TransferBasis& basis, std::span<const std::uint32_t> words) {
  const gi::LightContent& content = basis.content();
  const auto terms = static_cast<std::size_t>(content.order) * static_cast<std::size_t>(content.order);
  std::vector<float> transfer(static_cast<std::size_t>(content.components()));
  for (std::size_t i = 0; i < terms; ++i) {
    std::vector<glm::vec3> environment(terms, glm::vec3(0.0f));
    environment[i] = glm::vec3(1.0f);
    const gi::TransferBasis::Lighting lighting = basis.under(environment);
    glm::dvec3 light(lighting.offset);
    for (std::size_t k = 0; k < lighting.factors.size(); ++k)
      light += glm::dvec3(lighting.factors[k]) * static_cast<double>(basis.code(words, k));
    for (int channel = 0; channel < content.channels; ++channel)
      transfer[static_cast<std::size_t>(channel) * terms + i] = static_cast<float>(light[channel]);
  }
  return transfer;
}

}  // namespace isolux::test
