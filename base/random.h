// Generates random numbers that depend only on a seed and a counter.
//
// They are the same on every machine, in any order and from any number of threads. (std::normal_distribution
// differs between standard libraries.)
#pragma once

#include <cstdint>

namespace isolux::base {

// Returns SplitMix64's finaliser (Steele, Lea & Flood 2014): a bijection of 64 bits with good avalanche.
inline std::uint64_t hash64(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

// Returns the upper half of hash64(), for use as a seed.
inline std::uint32_t hash32(std::uint64_t x) {
  return static_cast<std::uint32_t>(hash64(x) >> 32);
}

inline std::uint64_t counterHash(std::uint64_t seed, std::uint64_t counter) {
  return hash64(hash64(seed) ^ counter);
}

// Returns a uniform number in [0, 1).
inline double uniformNoise(std::uint64_t seed, std::uint64_t counter) {
  return static_cast<double>(counterHash(seed, counter) >> 11) * 0x1p-53;
}

// Returns a number of mean 0 and variance 1, within ±6: the sum of twelve uniform 16-bit integers, computed
// without library functions. Its tails are slightly lighter than the normal distribution's.
inline double normalNoise(std::uint64_t seed, std::uint64_t counter) {
  std::int64_t sum = 0;
  for (std::uint64_t word = 0; word < 3; ++word) {
    const std::uint64_t bits = counterHash(seed + 0x632be59bd9b4e019ull * word, counter);
    for (int shift = 0; shift < 64; shift += 16) sum += static_cast<std::int64_t>(bits >> shift & 0xffffu);
  }
  return static_cast<double>(sum - std::int64_t{6} * 65535) * (1.0 / 65536.0);
}

}  // namespace isolux::base
