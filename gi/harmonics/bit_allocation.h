// Allocates the bits of a texel to the components of compressed transfer, and quantises their numbers.
//
// Numbers are quantised uniformly within a range. The range may exclude rare values if that reduces the mean
// squared error. Allocates bits one by one, each to the component where it reduces the error most per bit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace isolux::gi {

inline constexpr int kMostFieldBits = 16, kWordBits = 32;

// A uniform quantiser: codes 0 .. 2^bits - 1 mean low + code * step.
struct Quantizer {
  double low = 0.0, step = 0.0;  // step 0: all numbers are equal
  double squaredError = 0.0;     // mean, over the numbers it was made for
};
// Returns the quantiser of least error for the `sorted` (ascending) numbers; with 0 bits, their mean.
Quantizer quantizerOf(std::span<const double> sorted, int bits);
std::uint32_t codeOf(const Quantizer& quantizer, int bits, double number);

// Returns the bits of each component, at most `total` together. `sorted`: the numbers of each, ascending.
std::vector<int> allocateBits(const std::vector<std::vector<double>>& sorted, int total);

// Positions of bit fields in 32-bit words; no field spans two words. Fields that do not fit are narrowed, and
// `bits` returns their widths. Fields of 0 bits have word -1.
struct FieldPlace {
  int word = -1, shift = 0;
};
std::vector<FieldPlace> placeFields(std::vector<int>& bits, int words);

}  // namespace isolux::gi
