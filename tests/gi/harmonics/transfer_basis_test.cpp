#include "gi/harmonics/transfer_basis.h"
#include "tests/support/light.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include <gtest/gtest.h>

namespace isolux::gi {
namespace {

using Random = std::mt19937;

// A lattice whose texels are `vectorOf(number of the texel)`.
template <class VectorOf>
std::shared_ptr<LightLattice> latticeOf(LightContent content, glm::ivec3 dims, VectorOf vectorOf) {
  auto lattice = std::make_shared<LightLattice>(LatticeGeometry::make(dims, 1.0), content, "");
  const auto d = static_cast<std::size_t>(content.components());
  for (std::uint32_t b = 0; b < lattice->geometry().blockCount(); ++b) {
    LatticeBlock block;
    block.means.assign(kTexelsOfBlock * d, 1e6f);  // of texels that are not baked
    for (int i = 0; i < kTexelsOfBlock; ++i) {
      const glm::ivec3 texel = lattice->geometry().texelOf(b, i);
      if (!lattice->geometry().contains(texel)) continue;
      const std::vector<float> vector = vectorOf(lattice->geometry().indexOf(texel));
      std::copy(vector.begin(), vector.end(), block.means.begin() + static_cast<std::ptrdiff_t>(i) * d);
      block.samples[static_cast<std::size_t>(i)] = 1;
    }
    lattice->write(b, block);
  }
  return lattice;
}

// Vectors in a few directions and noise in all, as transfer is.
std::vector<float> vectorOf(std::uint64_t texel, int d) {
  Random random(static_cast<unsigned>(texel) + 1);
  std::normal_distribution<float> normal;
  std::vector<float> vector(static_cast<std::size_t>(d));
  for (int k = 0; k < 6; ++k) {
    const float c = normal(random);
    for (int i = 0; i < d; ++i)
      vector[static_cast<std::size_t>(i)] +=
          c * std::cos(static_cast<float>((k + 1) * (i + k))) / static_cast<float>(k + 1);
  }
  for (float& v : vector) v += 0.02f * normal(random) + 1.0f;
  return vector;
}

std::vector<float> roundTrip(const TransferBasis& basis, const std::vector<float>& vector) {
  std::vector<std::uint32_t> codes(basis.words());
  basis.encode(vector, codes);
  return test::decoded(basis, codes);
}

double rmsOf(const TransferBasis& basis, int texels) {
  double sum = 0.0;
  for (int t = 0; t < texels; ++t) {
    const auto in = vectorOf(static_cast<std::uint64_t>(t), basis.content().components());
    const auto out = roundTrip(basis, in);
    for (std::size_t i = 0; i < in.size(); ++i) sum += std::pow(static_cast<double>(out[i] - in[i]), 2);
  }
  return std::sqrt(sum / texels);
}

const LightContent kColor{LightContent::Kind::transfer, 3, 5};

// Steps of the widest fields are fine enough to see nothing but rounding.
TEST(TransferBasis, IsExactToHalfAStepWhereAllComponentsAreKept) {
  const LightContent content{LightContent::Kind::transfer, 1, 3};
  const auto lattice = latticeOf(content, {9, 10, 11}, [](std::uint64_t t) { return vectorOf(t, 9); });
  const auto basis = test::basisOf(*lattice, 24, 9 * 16);
  ASSERT_TRUE(basis);
  ASSERT_EQ(basis->fields().size(), 9u);
  EXPECT_EQ(basis->words(), 5u);
  // An error of half a step in every component, at most, through orthonormal axes that are stretched by
  // the reciprocal of the weights: at most sqrt(3) at order 3.
  double most = 0.0;
  for (const TransferBasis::Field& field : basis->fields())
    most += std::pow(0.5 * static_cast<double>(field.step), 2);
  most = std::sqrt(3.0 * most) + 1e-5;
  EXPECT_LT(most, 2e-3);
  for (std::uint64_t t = 0; t < 990; ++t) {
    const auto in = vectorOf(t, 9), out = roundTrip(*basis, in);
    double error = 0.0;
    for (std::size_t i = 0; i < in.size(); ++i) error += std::pow(static_cast<double>(out[i] - in[i]), 2);
    ASSERT_LE(std::sqrt(error), most);
  }
}

TEST(TransferBasis, MoreComponentsAndMoreBitsErrLess) {
  const auto lattice = latticeOf(kColor, {9, 10, 11}, [](std::uint64_t t) { return vectorOf(t, 75); });
  double before = INFINITY;
  for (const int components : {1, 2, 4, 6, 12, 75}) {
    const double rms = rmsOf(*test::basisOf(*lattice, components, components * 16), 990);
    EXPECT_LT(rms, before) << components;
    before = rms;
  }
  // Six directions hold all but the noise, 0.02 in each of 69 others.
  EXPECT_NEAR(rmsOf(*test::basisOf(*lattice, 6, 96), 990), 0.02 * std::sqrt(69.0), 0.02);
  before = INFINITY;
  for (const int bits : {32, 64, 96, 192, 384}) {
    const double rms = rmsOf(*test::basisOf(*lattice, 75, bits), 990);
    EXPECT_LT(rms, before) << bits;
    before = rms;
  }
}

// Bits where they bring most: less than half the error of equal fields of as many bits in all.
TEST(TransferBasis, UnequalBitsErrLessThanEqualOnes) {
  const auto strong = [](std::uint64_t t) {
    Random random(static_cast<unsigned>(t) + 1);
    std::normal_distribution<float> normal;
    std::vector<float> vector(9);
    for (std::size_t i = 0; i < 9; ++i) vector[i] = normal(random) * std::pow(0.4f, static_cast<float>(i));
    return vector;
  };
  const LightContent content{LightContent::Kind::transfer, 1, 3};
  const auto lattice = latticeOf(content, {20, 20, 20}, strong);
  const auto basis = test::basisOf(*lattice, 9, 32);
  ASSERT_TRUE(basis);
  EXPECT_GT(basis->fields().front().bits, basis->fields().back().bits + 3);
  double sum = 0.0, equal = 0.0;
  for (std::uint64_t t = 0; t < 2000; ++t) {
    const auto in = strong(t), out = roundTrip(*basis, in);
    for (std::size_t i = 0; i < 9; ++i) {
      sum += std::pow(static_cast<double>(out[i] - in[i]), 2);
      // 8 fields of 4 bits over 4 deviations either way, and one of none.
      const double deviation = std::pow(0.4, static_cast<double>(i));
      equal += i == 8 ? deviation * deviation : std::pow(8.0 * deviation / 16.0, 2) / 12.0;
    }
  }
  EXPECT_LT(std::sqrt(sum), 0.5 * std::sqrt(equal));
}

TEST(TransferBasis, LightingIsThatOfTheDecodedTransfer) {
  Random random(2);
  std::normal_distribution<float> normal;
  for (const int channels : {1, 3})
    for (const int bits : {32, 7 * 16}) {
      const LightContent content{LightContent::Kind::transfer, channels, 4};
      const int d = content.components();
      const auto lattice = latticeOf(content, {8, 8, 8}, [&](std::uint64_t t) { return vectorOf(t, d); });
      const auto basis = test::basisOf(*lattice, 7, bits);
      std::vector<glm::vec3> environment(16);
      for (glm::vec3& l : environment) l = {normal(random), normal(random), normal(random)};
      const TransferBasis::Lighting lighting = basis->under(environment);
      for (std::uint64_t t = 0; t < 512; ++t) {
        std::vector<std::uint32_t> codes(basis->words());
        basis->encode(vectorOf(t, d), codes);
        const std::vector<float> transfer = test::decoded(*basis, codes);
        glm::dvec3 expected(0.0), got(lighting.offset);
        for (int channel = 0; channel < 3; ++channel)
          for (std::size_t i = 0; i < 16; ++i)
            expected[channel] +=
                static_cast<double>(
                    transfer[(channels == 1 ? 0 : static_cast<std::size_t>(channel) * 16) + i]) *
                static_cast<double>(environment[i][channel]);
        for (std::size_t k = 0; k < lighting.factors.size(); ++k)
          got += glm::dvec3(lighting.factors[k]) * static_cast<double>(basis->code(codes, k));
        for (int channel = 0; channel < 3; ++channel) ASSERT_NEAR(got[channel], expected[channel], 2e-4);
      }
    }
}

TEST(TransferBasis, TexelsThatAreAllTheSameComeBack) {
  const std::vector<float> same = vectorOf(5, 75);
  for (const glm::ivec3& dims : {glm::ivec3(1), glm::ivec3(9, 3, 2)})
    for (const int bits : {96, 24 * 16}) {
      const auto basis =
          test::basisOf(*latticeOf(kColor, dims, [&](std::uint64_t) { return same; }), 24, bits);
      ASSERT_TRUE(basis);
      const auto out = roundTrip(*basis, same);
      for (std::size_t i = 0; i < same.size(); ++i) EXPECT_NEAR(out[i], same[i], 1e-5);
    }
}

TEST(TransferBasis, BlackTexelsAreBlack) {
  const std::vector<float> black(75, 0.0f);
  const auto basis =
      test::basisOf(*latticeOf(kColor, {4, 4, 4}, [&](std::uint64_t) { return black; }), 24, 96);
  ASSERT_TRUE(basis);
  EXPECT_EQ(roundTrip(*basis, black), black);
}

TEST(TransferBasis, NothingBakedHasNone) {
  const LightLattice lattice(LatticeGeometry::make({9, 9, 9}, 1.0), kColor, "");
  EXPECT_EQ(test::basisOf(lattice, 24, 96), nullptr);
}

TEST(TransferBasis, TexelsThatAreNoNumbersAreLeftOut) {
  const auto fitted = [](float wild) {
    return test::basisOf(*latticeOf(kColor, {8, 8, 8},
                                    [&](std::uint64_t t) {
                                      std::vector<float> vector = vectorOf(t, 75);
                                      if (t == 7) vector[3] += wild;
                                      return vector;
                                    }),
                         24, 192);
  };
  const double clean = rmsOf(*fitted(0.0f), 500);
  for (const float wild : {NAN, INFINITY}) EXPECT_LT(rmsOf(*fitted(wild), 500), 1.1 * clean);
}

TEST(TransferBasis, FewTexelsStandForAll) {
  const auto lattice = latticeOf(kColor, {20, 20, 20}, [](std::uint64_t t) { return vectorOf(t, 75); });
  const double all = rmsOf(*test::basisOf(*lattice, 12, 192, 8000), 8000);
  const double few = rmsOf(*test::basisOf(*lattice, 12, 192, 800), 8000);
  EXPECT_GE(few, all * (1.0 - 1e-6));
  EXPECT_LT(few, all * 1.1);
}

TEST(TransferBasis, WhatIsBeyondItsRangeIsClamped) {
  const auto lattice = latticeOf(kColor, {8, 8, 8}, [](std::uint64_t t) { return vectorOf(t, 75); });
  const auto basis = test::basisOf(*lattice, 24, 96);
  for (const float wild : {1e30f, -1e30f, NAN})
    for (const float value : roundTrip(*basis, std::vector<float>(75, wild)))
      EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace isolux::gi
