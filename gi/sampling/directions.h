// Generates points of [0, 1)^2 for directions and other decisions of a light path, and maps them to the
// sphere.
//
// samplePair() and sampleOne() depend only on their arguments: they are the same on every machine, in any
// order and from any number of threads. `seed` selects the pattern (of a texel or pixel; neighbours may have
// neighbouring seeds), `sample` its point. `pair` or `dimension` selects the decision of the path: 0 the
// first direction, then the later ones. Every prefix of a pattern is well distributed, and any number of
// samples may follow. Coordinates are odd multiples of 2^-24: never 0 or 1, so no direction is tangential to
// the surface.
//
// Sequences:
//   sobol_owen: the first two dimensions of Sobol's sequence, a (0,2)-sequence. Of the first 2^k points,
//   exactly one is in each of the 2^k boxes whose width and height are powers of two. Owen scrambling by a
//     hash (Laine & Karras 2011; Burley, JCGT 9(4), 2020; the hash is that of Vegdahl 2021, also in pbrt-v4).
//     Pairs after the first are the same sequence in another order, scrambled again ("padded", Burley 2020
//     sec. 5).
//   r2: fractional parts of n (1/p, 1/p^2), p^3 = p + 1 (Roberts 2018), with a shift per seed (Cranley &
//   Patterson 1976). Computed in 64-bit integers, they do not drift at large n. Pairs after the first are
//   sobol_owen, because
//     two shifted copies of one lattice would be the same in every pair.
//   random: independent numbers, a hash of the counters.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/choices.h"

namespace isolux::gi {

using scene::DirectionSequence;

glm::vec2 samplePair(DirectionSequence sequence, std::uint32_t seed, std::uint32_t sample,
                     std::uint32_t pair);
float sampleOne(DirectionSequence sequence, std::uint32_t seed, std::uint32_t sample,
                std::uint32_t dimension);

// Evaluates samplePair() for one seed and pair.
class PairPattern {
 public:
  PairPattern() = default;
  PairPattern(DirectionSequence sequence, std::uint32_t seed, std::uint32_t pair);
  glm::vec2 operator()(std::uint32_t sample) const;

 private:
  enum class Kind { random, r2, sobol, sobolShuffled };
  Kind kind_ = Kind::random;
  std::uint64_t key_ = 0;
};

// Computes sine and cosine of an angle of at most pi / 4, with an error below 1e-7. Uses no function of the C
// library, so the result is the same everywhere.
inline void sineCosine(float angle, float& sine, float& cosine) {
  const float a2 = angle * angle;
  sine = angle * (1.0f + a2 * (-1.0f / 6 + a2 * (1.0f / 120 + a2 * (-1.0f / 5040 + a2 * (1.0f / 362880)))));
  cosine = 1.0f + a2 * (-0.5f + a2 * (1.0f / 24 + a2 * (-1.0f / 720 + a2 * (1.0f / 40320))));
}

// Computes sine and cosine of `turn` full turns, in [-1/2, 1/2], with an error below 1.5e-7.
inline void sineCosineOfTurn(float turn, float& sine, float& cosine) {
  const int quarter = static_cast<int>(4.0f * turn + 2.5f) - 2;  // the nearest
  float s, c;
  sineCosine(6.28318531f * (turn - 0.25f * static_cast<float>(quarter)), s, c);
  sine = (quarter & 1) != 0 ? c : s;
  cosine = (quarter & 1) != 0 ? s : c;
  if ((quarter & 2) != 0) sine = -sine;
  if (((quarter + 1) & 2) != 0) cosine = -cosine;
}

// Maps the unit square to the unit disc, preserving ratios of areas (Shirley & Chiu 1997).
inline glm::vec2 concentricDisk(glm::vec2 u) {
  const glm::vec2 square = 2.0f * u - 1.0f;
  const bool wide = std::abs(square.x) > std::abs(square.y);
  const float radius = wide ? square.x : square.y;
  const float ratio = radius != 0.0f ? (wide ? square.y : square.x) / radius : 0.0f;
  float sine, cosine;
  sineCosine(0.785398163f * ratio, sine, cosine);
  return radius * (wide ? glm::vec2(cosine, sine) : glm::vec2(sine, cosine));
}

// Return unit vectors about +z. Densities per steradian: z / pi, 1 / (2 pi oneMinusCosine) (uniformCone).
inline glm::vec3 cosineHemisphere(glm::vec2 u) {
  const glm::vec2 disk = concentricDisk(u);
  return {disk.x, disk.y, std::sqrt(std::max(0.0f, 1.0f - glm::dot(disk, disk)))};
}

// Samples the cone of directions within an angle of +z. The angle is given as 1 - cos(angle) in [0, 2], which
// keeps the precision of narrow cones.
inline glm::vec3 uniformCone(glm::vec2 u, float oneMinusCosine) {
  const glm::vec2 disk = concentricDisk(u);
  const float below = oneMinusCosine * std::min(1.0f, glm::dot(disk, disk));  // 1 - z, uniform
  const float scale = std::sqrt(oneMinusCosine * (2.0f - below));
  return {scale * disk.x, scale * disk.y, 1.0f - below};
}

// Returns 1 - cos of the half angle that a ball subtends at `distance` from its centre; 2 (all directions)
// inside it.
inline float oneMinusCosineOfBall(float radius, float distance) {
  if (!(distance > radius)) return 2.0f;
  const float sine = radius / distance;
  return sine * sine / (1.0f + std::sqrt((1.0f - sine) * (1.0f + sine)));
}

// A right-handed orthonormal basis about a unit normal, without a singular direction (Duff et al., JCGT 6(1),
// 2017).
struct Frame {
  glm::vec3 tangent{1, 0, 0}, bitangent{0, 1, 0}, normal{0, 0, 1};

  static Frame about(glm::vec3 n) {
    const float sign = std::copysign(1.0f, n.z);
    const float a = -1.0f / (sign + n.z);
    const float b = n.x * n.y * a;
    return {{1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
  }
  glm::vec3 toWorld(glm::vec3 local) const {
    return local.x * tangent + local.y * bitangent + local.z * normal;
  }
};

}  // namespace isolux::gi
