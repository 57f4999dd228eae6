// What the kernels of the caster share: the volume as they see it, and what they are asked for. Internal to
// this folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include <glm/vec3.hpp>

#include "volume/cast/surface_caster.h"

namespace isolux::volume::casting {

using VoxelPointer = std::variant<const std::int8_t*, const std::uint8_t*, const std::int16_t*,
                                  const std::uint16_t*, const float*>;

// Stored values become (stored - offset) * scale.
struct CastView {
  glm::ivec3 dims{0};       // voxels; all at least 2
  glm::ivec3 blockDims{0};  // of 8^3 cells
  VoxelPointer voxels;
  float offset = 0.0f, scale = 1.0f;
  bool gaps = false;                     // some voxel is missing: behind an empty box no side is known
  const std::uint64_t* masks = nullptr;  // of each block: bit x + 4 y + 16 z, a box of 2^3 cells
  int surfaces = 1;                      // 1 to 4
  float isovalue = 0.0f;                 // the first, less the offset, stored units
  float shifts[4] = {};                  // each isovalue minus the first, scaled
};

struct CastKernels {
  const char* name;
  void (*cast)(const CastView& view, const PictureRays& rays, const StartDepths& depths,
               const CastTarget& target);
};

// The widest of this machine; null where it has no vector instructions that these are made for.
const CastKernels* castKernels();

}  // namespace isolux::volume::casting
