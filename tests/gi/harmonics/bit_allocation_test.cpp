#include "gi/harmonics/bit_allocation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

namespace isolux::gi {
namespace {

std::vector<double> uniform(double deviation, int count = 4000) {
  std::vector<double> numbers;
  const double half = deviation * std::sqrt(3.0);
  for (int i = 0; i < count; ++i) numbers.push_back(half * (2.0 * (i + 0.5) / count - 1.0));
  return numbers;
}

// An even quantiser of uniform numbers errs by step^2 / 12.
TEST(BitAllocation, AQuantiserOfUniformNumbersErrsByItsStep) {
  const std::vector<double> numbers = uniform(1.0);
  EXPECT_NEAR(quantizerOf(numbers, 0).squaredError, 1.0, 1e-6);
  for (int bits = 1; bits <= 7; ++bits) {
    const Quantizer quantizer = quantizerOf(numbers, bits);
    const double step = 2.0 * std::sqrt(3.0) / std::ldexp(1.0, bits);
    EXPECT_NEAR(quantizer.step, step, 2e-3 * step);
    EXPECT_NEAR(quantizer.squaredError, step * step / 12.0, 0.01 * step * step);
  }
}

// Of normal numbers in 16 steps: step 0.3352, mean squared error 0.01154 (Max 1960, table 2).
TEST(BitAllocation, AQuantiserOfNormalNumbersLeavesTheRarestOut) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> numbers(100000);
  for (double& number : numbers) number = normal(random);
  std::sort(numbers.begin(), numbers.end());
  const Quantizer quantizer = quantizerOf(numbers, 4);
  EXPECT_NEAR(quantizer.step, 0.3352, 0.02);
  EXPECT_NEAR(quantizer.squaredError, 0.01154, 0.0005);
}

// However few the bits: of all even quantisers that leave out as many at either
// end hardly any is better.
TEST(BitAllocation, AQuantiserLeavesOutAboutAsManyAsIsBest) {
  constexpr int count = 2000;
  std::vector<double> laplace;
  for (int i = 0; i < count; ++i) {
    const double u = (i + 0.5) / count;
    laplace.push_back(u < 0.5 ? std::log(2.0 * u) : -std::log(2.0 - 2.0 * u));
  }
  for (const std::vector<double>& numbers : {uniform(1.0, count), laplace})
    for (int bits = 1; bits <= 4; ++bits) {
      double least = INFINITY;
      for (int cut = 0; cut < count / 2 - 1; ++cut) {
        const double low = numbers[static_cast<std::size_t>(cut)],
                     high = numbers[static_cast<std::size_t>(count - 1 - cut)];
        const double step = (high - low) / std::ldexp(1.0, bits);
        double sum = 0.0;
        for (const double number : numbers) {
          const double code = std::clamp(std::floor((number - low) / step), 0.0, std::ldexp(1.0, bits) - 1.0);
          sum += std::pow(low + (code + 0.5) * step - number, 2);
        }
        least = std::min(least, sum / count);
      }
      EXPECT_LE(quantizerOf(numbers, bits).squaredError, 1.05 * least)
          << bits << " bits of " << numbers.front();
    }
}

TEST(BitAllocation, CodesAreNearestAndClamped) {
  const Quantizer quantizer{-1.0, 0.5, 0.0};
  EXPECT_EQ(codeOf(quantizer, 2, -0.6), 1u);
  EXPECT_EQ(codeOf(quantizer, 2, 1e30), 3u);
  EXPECT_EQ(codeOf(quantizer, 2, -1e30), 0u);
  EXPECT_EQ(codeOf(quantizer, 2, NAN), 0u);
  EXPECT_EQ(codeOf({2.0, 0.0, 0.0}, 4, 5.0), 0u);
}

// Uniform numbers of deviations 8, 4, 2, 1: each halving costs a bit (reverse water-filling).
TEST(BitAllocation, BitsFollowTheLogarithmOfTheDeviation) {
  std::vector<std::vector<double>> sorted;
  for (const double deviation : {8.0, 4.0, 2.0, 1.0}) sorted.push_back(uniform(deviation));
  EXPECT_EQ(allocateBits(sorted, 18), (std::vector<int>{6, 5, 4, 3}));
  sorted.emplace_back(100, 7.0);
  EXPECT_EQ(allocateBits(sorted, 10), (std::vector<int>{4, 3, 2, 1, 0}));
}

TEST(BitAllocation, NoComponentGetsMoreThanAFieldHolds) {
  const std::vector<int> bits = allocateBits({uniform(1.0), uniform(1e-3)}, 1000);
  EXPECT_LE(*std::max_element(bits.begin(), bits.end()), kMostFieldBits);
}

TEST(BitAllocation, AQuantiserOfEqualNumbersHasNoSteps) {
  const std::vector<double> equal(100, 3.0);
  for (const int bits : {0, 4}) {
    const Quantizer quantizer = quantizerOf(equal, bits);
    EXPECT_EQ(quantizer.low, 3.0);
    EXPECT_EQ(quantizer.step, 0.0);
  }
}

TEST(BitAllocation, AFieldGoesToTheFullestWordWithRoom) {
  std::vector<int> bits = {16, 12, 8, 2};
  const std::vector<FieldPlace> places = placeFields(bits, 2);
  const int expected[][2] = {{0, 0}, {0, 16}, {1, 0}, {0, 28}};
  for (std::size_t k = 0; k < bits.size(); ++k) {
    EXPECT_EQ(places[k].word, expected[k][0]) << k;
    EXPECT_EQ(places[k].shift, expected[k][1]) << k;
  }
}

TEST(BitAllocation, FieldsShareNoBitAndLieInOneWord) {
  std::mt19937 random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const int words = 1 + trial % 6;
    std::vector<int> bits;
    int left = words * kWordBits;
    while (left > 0) {
      bits.push_back(std::min(left, std::uniform_int_distribution<int>(0, 12)(random)));
      left -= bits.back();
    }
    const std::vector<int> wanted = bits;
    const std::vector<FieldPlace> places = placeFields(bits, words);
    std::vector<std::uint64_t> used(static_cast<std::size_t>(words), 0);
    for (std::size_t k = 0; k < bits.size(); ++k) {
      EXPECT_LE(bits[k], wanted[k]);
      ASSERT_EQ(places[k].word < 0, bits[k] == 0);
      if (bits[k] == 0) continue;
      ASSERT_LE(places[k].shift + bits[k], kWordBits);
      const std::uint64_t mask = ((std::uint64_t{1} << bits[k]) - 1) << places[k].shift;
      std::uint64_t& word = used[static_cast<std::size_t>(places[k].word)];
      EXPECT_EQ(word & mask, 0u);
      word |= mask;
    }
    EXPECT_GE(std::accumulate(bits.begin(), bits.end(), 0), words * kWordBits * 9 / 10);
  }
}

}  // namespace
}  // namespace isolux::gi
