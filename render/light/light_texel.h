// Packs a texel of baked lighting into 32-bit words for the GPU; light_lattice.glsl reads them. No GL.
//
// Words, where parts that are not stored are omitted:
//   0      the normal, three signed bytes (0: the texel has none and is never lit), and how far it is baked
//          in fifteenths: bits 24 to 27 for the sky, 28 to 31 for the light sources
//   then   the sky's light: E in one word (11, 11 and 10 bits of float, or one float of a single channel) or
//          two (three half floats), or the codes of a compressed transfer vector
//   then   the light sources' irradiance likewise
//   then   the isovalue of the texel, a float
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
  // Units of the stored irradiance, powers of two near the unoccluded one: small floats then represent it
  // whatever the units of an environment map.
  float skyUnit = 1.0f, lampsUnit = 1.0f;

  int wordsOf(LightPacking packing) const;
  int words() const { return 1 + wordsOf(sky) + wordsOf(lamps) + (isovalue ? 1 : 0); }
  bool stores() const { return sky != LightPacking::none || lamps != LightPacking::none; }
  bool operator==(const LightTexelLayout&) const = default;
};

// Returns the layout for light with these contents; null: not stored. Transfer without a basis is not stored.
LightTexelLayout lightTexelLayout(const gi::LightContent* sky, const gi::LightContent* lamps,
                                  const gi::TransferBasis* basis, scene::GiPrecision precision,
                                  bool isovalue);

// Packs E as 11, 11 and 10 bits of float, rounded to nearest and clamped between 0 and the largest such
// number.
std::uint32_t packR11g11b10(glm::vec3 e);
// Packs word 0. Fractions 0 .. 1; one above 0 never becomes 0.
std::uint32_t packTexelState(glm::vec3 normal, float skyFraction, float lampsFraction);

// Returns the power of two nearest to an irradiance; 1 if that is 0.
float lightUnit(double irradiance);

// Packs the light of one texel: `means` are LightContent::components() numbers, `out` wordsOf(packing) words.
// `unit`: the unit of the stored irradiance.
void packLight(LightPacking packing, const float* means, float unit, const gi::LightContent& content,
               const gi::TransferBasis* basis, std::uint32_t* out);

}  // namespace isolux::render
