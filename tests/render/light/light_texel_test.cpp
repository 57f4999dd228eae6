// How light is written into a texel's words: numbers that no light has, and the ends of what a word can hold.
#include "render/light/light_texel.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/packing.hpp>

namespace isolux::render {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// 11 bits: 5 of exponent, 6 of mantissa; below 1 in the exponent's all ones, which stand for infinity.
float ofElevenBits(std::uint32_t bits) {
  const auto exponent = static_cast<int>(bits >> 6 & 31u);
  const auto mantissa = static_cast<float>(bits & 63u);
  return exponent == 0 ? std::ldexp(mantissa, -20) : std::ldexp(64.0f + mantissa, exponent - 21);
}

TEST(LightTexelTest, ShortFloatsAreTheNearestAndStayWithinTheirField) {
  for (const float v : {1.0f, 0.37f, 1e-3f, 3.3e4f}) {
    const float back = ofElevenBits(packR11g11b10({v, 0.0f, 0.0f}) & 0x7FFu);
    EXPECT_NEAR(back, v, v / 128.0f) << v;
    EXPECT_EQ(packR11g11b10({v, 0.0f, 0.0f}) >> 11, 0u) << v;
  }
  constexpr std::uint32_t largest11 = 30u << 6 | 63u, largest10 = 30u << 5 | 31u;
  for (const float v : {65504.0f, 1e6f, 3e38f, kInfinity})
    EXPECT_EQ(packR11g11b10(glm::vec3(v)), largest11 | largest11 << 11 | largest10 << 22) << v;
}

TEST(LightTexelTest, NoLightIsZero) {
  for (const float v : {NAN, -1.0f, -kInfinity, 0.0f}) EXPECT_EQ(packR11g11b10(glm::vec3(v)), 0u) << v;
}

TEST(LightTexelTest, ANormalThatIsNoneIsZeroAndAFewPathsAreNotNone) {
  EXPECT_EQ(packTexelState(glm::vec3(NAN), 0.0f, 0.0f), 0u);
  EXPECT_EQ(packTexelState(glm::vec3(0.0f), NAN, -1.0f), 0u);
  EXPECT_EQ(packTexelState(glm::vec3(0.0f), 1e-6f, 2.0f), 1u << 24 | 15u << 28);
  EXPECT_EQ(packTexelState(glm::vec3(1.0f, -1.0f, 0.0f), 0.0f, 0.0f), 127u | 129u << 8);
}

TEST(LightTexelTest, MeansThatAreNoNumbersAreZeroAndHugeOnesTheLargest) {
  const gi::LightContent content{gi::LightContent::Kind::irradiance, 3, 0};
  const std::array<float, 3> means{NAN, kInfinity, 1e30f};
  std::array<std::uint32_t, 2> words{};
  packLight(LightPacking::half, means.data(), 1.0f, content, nullptr, words.data());
  EXPECT_EQ(glm::unpackHalf2x16(words[0]), glm::vec2(0.0f));
  EXPECT_EQ(glm::unpackHalf2x16(words[1]).x, 65504.0f);
}

TEST(LightTexelTest, UnitsAreThePowersOfTwoNearestToTheLight) {
  EXPECT_EQ(lightUnit(1.0), 1.0f);
  EXPECT_EQ(lightUnit(1e5), 131072.0f);
  EXPECT_EQ(lightUnit(3e-7), 0x1p-22f);
  for (const double none : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(kInfinity)})
    EXPECT_EQ(lightUnit(none), 1.0f);
  const gi::LightContent content{gi::LightContent::Kind::irradiance, 3, 0};
  const std::array<float, 3> means{1e5f, 5e4f, 2e6f};
  std::array<std::uint32_t, 2> words{};
  packLight(LightPacking::half, means.data(), lightUnit(1e5), content, nullptr, words.data());
  const glm::vec2 first = 131072.0f * glm::unpackHalf2x16(words[0]);
  EXPECT_NEAR(first.x, 1e5f, 50.0f);
  EXPECT_NEAR(first.y, 5e4f, 25.0f);
  EXPECT_NEAR(131072.0f * glm::unpackHalf2x16(words[1]).x, 2e6f, 1000.0f);
}

}  // namespace
}  // namespace isolux::render
