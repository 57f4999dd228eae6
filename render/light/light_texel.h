// How a texel of stored light is written into 32-bit words for the GPU; light_lattice.glsl reads them. No GL.
//
// Word 0: the normal, three signed bytes (0: the texel has none and is never lit), and how far it is baked in
// fifteenths: bits 24 to 27 the sky's light, 28 to 31 the lamps'. Then the sky's light: E in one word (11, 11
// and 10 bits of float, or one float of a single channel) or two (three half floats), or the codes of a
// compressed transfer vector. Then the lamps' irradiance likewise, then the isovalue of the texel, a float.
// Each part only where it is stored.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "gi/harmonics/transfer_basis.h"
#include "gi/lattice/light_lattice.h"
#include "scene/choices.h"

namespace isolux::render {

enum class LightPacking { none, r11g11b10, half, single, codes };  // light_lattice.glsl has the same numbers

struct LightTexelLayout {
  LightPacking sky = LightPacking::none, lamps = LightPacking::none;
  std::vector<gi::TransferBasis::Field> fields{};  // of codes
  int codeWords = 0;
  bool isovalue = false;
  // Irradiance is stored as parts of these, powers of two near that of the unoccluded light: small floats
  // hold it whatever units a light probe has.
  float skyUnit = 1.0f, lampsUnit = 1.0f;

  int wordsOf(LightPacking packing) const;
  int words() const { return 1 + wordsOf(sky) + wordsOf(lamps) + (isovalue ? 1 : 0); }
  bool stores() const { return sky != LightPacking::none || lamps != LightPacking::none; }
  bool operator==(const LightTexelLayout&) const = default;
};

// Of light with these contents; null: not stored. Transfer without a basis is not stored.
LightTexelLayout lightTexelLayout(const gi::LightContent* sky, const gi::LightContent* lamps,
                                  const gi::TransferBasis* basis, scene::GiPrecision precision,
                                  bool isovalue);

// E as 11, 11 and 10 bits of float, rounded to nearest, between 0 and the largest such number.
std::uint32_t packR11g11b10(glm::vec3 e);
// Word 0. Fractions 0 .. 1; one above 0 never becomes 0.
std::uint32_t packTexelState(glm::vec3 normal, float skyFraction, float lampsFraction);

// The power of two nearest to an irradiance; 1 where there is none.
float lightUnit(double irradiance);

// Of one texel: `means` are LightContent::components() numbers, `out` wordsOf(packing) words. unit: that
// irradiance is stored as parts of.
void packLight(LightPacking packing, const float* means, float unit, const gi::LightContent& content,
               const gi::TransferBasis* basis, std::uint32_t* out);

}  // namespace isolux::render
