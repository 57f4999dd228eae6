// Which component of compressed transfer gets how many bits of a texel, and how its numbers become codes.
//
// Numbers are quantised evenly within a range that may leave the rarest out, where that lessens the mean
// squared error. Bits are given away one by one, each to the component whose error it lessens most per bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace isolux::gi {

inline constexpr int kMostFieldBits = 16, kWordBits = 32;

// Codes 0 .. 2^bits - 1 stand for low + code * step.
struct Quantizer {
  double low = 0.0, step = 0.0;  // step 0: all are the same
  double squaredError = 0.0;     // mean, of the numbers it was made for
};
// With the least error of these `sorted` numbers (rising); bits 0: their mean.
Quantizer quantizerOf(std::span<const double> sorted, int bits);
std::uint32_t codeOf(const Quantizer& quantizer, int bits, double number);

// Bits of each component for at most `total`; `sorted`: numbers of each, rising.
std::vector<int> allocateBits(const std::vector<std::vector<double>>& sorted, int total);

// Where fields of these bits begin in words of 32, none of them in two words. Fields for which there is no
// room are made narrower: `bits` says how wide they are. Those of 0 bits are nowhere (word -1).
struct FieldPlace {
  int word = -1, shift = 0;
};
std::vector<FieldPlace> placeFields(std::vector<int>& bits, int words);

}  // namespace isolux::gi
