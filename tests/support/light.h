// Light in tests.
#pragma once

#include <memory>

#include "gi/harmonics/transfer_basis.h"

namespace isolux::test {

// The basis of one lattice alone.
inline std::shared_ptr<const gi::TransferBasis> basisOf(const gi::LightLattice& lattice, int components,
                                                        int bits, std::size_t mostTexels = 20000) {
  const gi::LightLattice* const one = &lattice;
  return gi::TransferBasis::fit(std::span(&one, 1), components, bits, nullptr, mostTexels);
}

}  // namespace isolux::test
