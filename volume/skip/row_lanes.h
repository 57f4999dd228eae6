// Voxels of a row four at a time, and comparisons of them as bits: vectors of the compiler, for any
// processor.
#pragma once

#include <cstdint>
#include <cstring>

namespace isolux::volume {

// What is compared is -1 in all bits where it is true.
using FourFloats = float __attribute__((vector_size(16)));
using FourFlags = std::int32_t __attribute__((vector_size(16)));

template <class T>
FourFloats fourOf(const T* row) {
  return FourFloats{static_cast<float>(row[0]), static_cast<float>(row[1]), static_cast<float>(row[2]),
                    static_cast<float>(row[3])};
}

// All bits that any lane has.
inline unsigned anyLane(FourFlags flags) {
  std::uint64_t halves[2];
  std::memcpy(halves, &flags, sizeof halves);
  const std::uint64_t both = halves[0] | halves[1];
  return static_cast<unsigned>(both | both >> 32);
}

// A bit for each of eight, the first four in `near`.
inline unsigned eightBits(FourFlags near, FourFlags far) {
  return anyLane((near & FourFlags{1, 2, 4, 8}) | (far & FourFlags{16, 32, 64, 128}));
}

}  // namespace isolux::volume
