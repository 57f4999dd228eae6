#include "render/light/light_texel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <span>

#include <glm/common.hpp>
#include <glm/gtc/packing.hpp>
#include <glm/packing.hpp>

namespace isolux::render {

namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr int kFractionSteps = 15;

// The nearest float of 5 bits of exponent and `mantissa` bits, no sign: a half float without its last bits.
std::uint32_t shortFloat(float v, int mantissa) {
  const float positive = std::clamp(v, 0.0f, kLargestHalf);  // NaN: 0 by the line below
  if (!(v > 0.0f)) return 0;
  const int dropped = 10 - mantissa;
  const std::uint32_t half = glm::packHalf1x16(positive);
  const std::uint32_t largest = (30u << mantissa) | ((1u << mantissa) - 1u);
  return std::min((half + (1u << (dropped - 1))) >> dropped, largest);
}

std::uint32_t fractionBits(float fraction) {
  if (!(fraction > 0.0f)) return 0;
  return static_cast<std::uint32_t>(
      std::clamp(static_cast<int>(std::lround(fraction * kFractionSteps)), 1, kFractionSteps));
}

LightPacking packingOf(const gi::LightContent* content, const gi::TransferBasis* basis,
                       scene::GiPrecision precision) {
  if (!content) return LightPacking::none;
  if (content->kind == gi::LightContent::Kind::transfer)
    return basis && basis->content() == *content ? LightPacking::codes : LightPacking::none;
  if (content->channels == 1) return LightPacking::single;
  return precision == scene::GiPrecision::half ? LightPacking::half : LightPacking::r11g11b10;
}

}  // namespace

int LightTexelLayout::wordsOf(LightPacking packing) const {
  switch (packing) {
    case LightPacking::none:
      return 0;
    case LightPacking::r11g11b10:
    case LightPacking::single:
      return 1;
    case LightPacking::half:
      return 2;
    case LightPacking::codes:
      break;
  }
  return codeWords;
}

LightTexelLayout lightTexelLayout(const gi::LightContent* sky, const gi::LightContent* lamps,
                                  const gi::TransferBasis* basis, scene::GiPrecision precision,
                                  bool isovalue) {
  LightTexelLayout layout;
  layout.sky = packingOf(sky, basis, precision);
  layout.lamps = packingOf(lamps, nullptr, precision);
  if (layout.sky == LightPacking::codes) {
    layout.fields = basis->fields();
    layout.codeWords = static_cast<int>(basis->words());
  }
  layout.isovalue = isovalue && layout.stores();
  return layout;
}

std::uint32_t packR11g11b10(glm::vec3 e) {
  return shortFloat(e.x, 6) | shortFloat(e.y, 6) << 11 | shortFloat(e.z, 5) << 22;
}

std::uint32_t packTexelState(glm::vec3 normal, float skyFraction, float lampsFraction) {
  std::uint32_t word = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const float scaled = glm::clamp(normal[axis], -1.0f, 1.0f) * 127.0f;
    const auto byte = static_cast<std::int8_t>(std::lround(std::isfinite(scaled) ? scaled : 0.0f));
    word |= static_cast<std::uint32_t>(static_cast<std::uint8_t>(byte)) << (8 * axis);
  }
  return word | fractionBits(skyFraction) << 24 | fractionBits(lampsFraction) << 28;
}

float lightUnit(double irradiance) {
  if (!(irradiance > 0.0) || !std::isfinite(irradiance)) return 1.0f;
  return static_cast<float>(std::exp2(std::clamp(std::round(std::log2(irradiance)), -100.0, 100.0)));
}

void packLight(LightPacking packing, const float* means, float unit, const gi::LightContent& content,
               const gi::TransferBasis* basis, std::uint32_t* out) {
  const auto component = [&](int i) { return std::isfinite(means[i]) ? means[i] / unit : 0.0f; };
  switch (packing) {
    case LightPacking::none:
      return;
    case LightPacking::single: {
      const float e = component(0);
      std::memcpy(out, &e, sizeof e);
      return;
    }
    case LightPacking::r11g11b10:
    case LightPacking::half: {
      glm::vec3 e(component(0));
      if (content.channels == 3) e = {component(0), component(1), component(2)};
      if (packing == LightPacking::r11g11b10) {
        out[0] = packR11g11b10(e);
        return;
      }
      e = glm::clamp(e, glm::vec3(-kLargestHalf), glm::vec3(kLargestHalf));
      out[0] = glm::packHalf2x16({e.x, e.y});
      out[1] = glm::packHalf2x16({e.z, 0.0f});
      return;
    }
    case LightPacking::codes: {
      assert(basis);
      basis->encode({means, static_cast<std::size_t>(content.components())}, {out, basis->words()});
      return;
    }
  }
}

}  // namespace isolux::render
