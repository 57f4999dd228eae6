#include "gi/sampling/directions.h"

#include <glm/integer.hpp>

#include "base/random.h"

namespace isolux::gi {

using base::hash64;

namespace {

constexpr std::uint64_t singleDimensions = 0x5bd1e995u;  // tells sampleOne()'s patterns from samplePair()'s

// Owen scrambling of a number whose first binary digit is bit 0: every bit may flip, by what the bits below
// it and the key are (a Laine-Karras permutation, constants by Vegdahl 2021).
std::uint32_t scrambleReversed(std::uint32_t x, std::uint32_t key) {
  x ^= x * 0x3d20adeau;
  x += key;
  x *= (key >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// The place in the sequence of sample `index`, in an order that keeps aligned blocks of 2^k together.
std::uint32_t shuffle(std::uint32_t index, std::uint32_t key) {
  return glm::bitfieldReverse(scrambleReversed(glm::bitfieldReverse(index), key));
}

// Sobol's second dimension, first binary digit in bit 0. Digit j is the sum modulo 2 of binomial(k, j) over
// the bits k of the index, and binomial(k, j) is odd where the bits of k include those of j (Lucas): a sum
// over supersets, one bit of the bit numbers at a time.
std::uint32_t sobolSecondReversed(std::uint32_t x) {
  x ^= x >> 1 & 0x55555555u;
  x ^= x >> 2 & 0x33333333u;
  x ^= x >> 4 & 0x0f0f0f0fu;
  x ^= x >> 8 & 0x00ff00ffu;
  x ^= x >> 16;
  return x;
}

// The 23 leading bits, at the middle of their interval.
float toUnit(std::uint32_t bits) {
  return static_cast<float>(bits >> 9) * 0x1p-23f + 0x1p-24f;
}

std::uint64_t keyOf(std::uint32_t seed, std::uint64_t stream) {
  return hash64(static_cast<std::uint64_t>(seed) | stream << 32);
}

glm::vec2 sobolPair(std::uint64_t key, std::uint32_t sample, bool shuffled) {
  const auto first = static_cast<std::uint32_t>(key), second = static_cast<std::uint32_t>(key >> 32);
  const std::uint32_t index = shuffled ? shuffle(sample, first ^ (second * 0x9e3779b1u)) : sample;
  return {toUnit(glm::bitfieldReverse(scrambleReversed(index, first))),
          toUnit(glm::bitfieldReverse(scrambleReversed(sobolSecondReversed(index), second)))};
}

glm::vec2 r2Pair(std::uint64_t key, std::uint32_t sample) {
  // 1/p and 1/p^2 times 2^64.
  constexpr std::uint64_t alpha1 = 0xc13fa9a902a6328full, alpha2 = 0x91e10da5c79e7b1cull;
  const std::uint64_t x = (key << 32) + alpha1 * sample;
  const std::uint64_t y = (key & 0xffffffff00000000u) + alpha2 * sample;
  return {toUnit(static_cast<std::uint32_t>(x >> 32)), toUnit(static_cast<std::uint32_t>(y >> 32))};
}

// SplitMix64's stream that starts at `key`.
std::uint64_t randomBits(std::uint64_t key, std::uint32_t sample) {
  return hash64(key + 0x9e3779b97f4a7c15u * sample);
}

}  // namespace

glm::vec2 samplePair(DirectionSequence sequence, std::uint32_t seed, std::uint32_t sample,
                     std::uint32_t pair) {
  return PairPattern(sequence, seed, pair)(sample);
}

PairPattern::PairPattern(DirectionSequence sequence, std::uint32_t seed, std::uint32_t pair)
    : key_(keyOf(seed, pair)) {
  if (sequence == DirectionSequence::random)
    kind_ = Kind::random;
  else if (pair != 0)
    kind_ = Kind::sobolShuffled;
  else
    kind_ = sequence == DirectionSequence::r2 ? Kind::r2 : Kind::sobol;
}

glm::vec2 PairPattern::operator()(std::uint32_t sample) const {
  if (kind_ == Kind::r2) return r2Pair(key_, sample);
  if (kind_ != Kind::random) return sobolPair(key_, sample, kind_ == Kind::sobolShuffled);
  const std::uint64_t bits = randomBits(key_, sample);
  return {toUnit(static_cast<std::uint32_t>(bits)), toUnit(static_cast<std::uint32_t>(bits >> 32))};
}

float sampleOne(DirectionSequence sequence, std::uint32_t seed, std::uint32_t sample,
                std::uint32_t dimension) {
  const std::uint64_t key = keyOf(seed, dimension) ^ singleDimensions;
  if (sequence == DirectionSequence::random)
    return toUnit(static_cast<std::uint32_t>(randomBits(hash64(key), sample) >> 32));
  const std::uint64_t keys = hash64(key);
  const auto first = static_cast<std::uint32_t>(keys), second = static_cast<std::uint32_t>(keys >> 32);
  return toUnit(glm::bitfieldReverse(scrambleReversed(shuffle(sample, second), first)));
}

}  // namespace isolux::gi
