// Declares what the kernels of the isosurface tracer share: their view of the volume, and what it does ray by
// ray. Internal to this folder.
#pragma once

#include <cstddef>
#include <cstdint>

#include "volume/hit/shown_cells.h"
#include "volume/simd/simd_set.h"
#include "volume/skip/cell_ranges.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume::tracing {

struct View {
  glm::ivec3 dims{0};       // voxels; all at least 2, else nothing is traced
  glm::ivec3 blockDims{0};  // CellRanges
  // Of stored - isovalue: positive inside; a power of two that brings floats near 1, so that their products
  // neither overflow nor vanish.
  float scale = 1.0f;
  const CellRanges* ranges = nullptr;
  const std::uint8_t* table = nullptr;
  std::size_t cellBytes = 0;
  bool wide = false;  // voxels, or pairs of bytes in the table, have no 32-bit numbers
  // One of them.
  const std::int16_t* signed16 = nullptr;
  const std::uint16_t* unsigned16 = nullptr;
  const float* float32 = nullptr;

  // Where pieces are hidden, and whether the inside of rays is the inside of pieces, or the other side.
  const ShownCells* shown = nullptr;
  bool insideIsOfPieces = true;

  bool traceable() const { return table != nullptr; }

  // Calls use(voxels).
  template <class Use>
  auto withVoxels(const Use& use) const {
    return signed16 ? use(signed16) : unsigned16 ? use(unsigned16) : use(float32);
  }
};

// Handles a cell with masked voxels: returns the parameter s in [0, 1] of the first visible entry, or -1.
// `outside` (in/out): whether the ray is known to be outside.
inline double entryIntoShown(const View& view, glm::ivec3 cell, const glm::dvec3& from, const glm::dvec3& to,
                             bool& outside) {
  const VisibilityIntervals way = view.shown->along(cell, from, to);
  for (const VisibilityIntervals::Part& part : way.parts()) {
    const bool inside = part.inside == view.insideIsOfPieces;
    if (outside && inside) return part.begin;
    outside = !inside;
  }
  return -1.0;
}

// Moves a ray that begins outside the volume to where it enters, in double precision whatever the distance,
// and returns t of that. Rays that meet nothing, or are none, become of length 0.
float enterVolume(const View& view, TraceRay& ray);

// Returns the gradient near the border and beside missing voxels, where the kernels' vectors do not reach.
glm::vec3 borderGradient(const View& view, glm::vec3 voxel);

struct Kernels {
  SimdSet set;
  void (*firstEntries)(const View& view, const TraceRay* rays, std::size_t count, float* t);
  void (*anyEntries)(const View& view, const TraceRay* rays, std::size_t count, std::uint8_t* hit);
  void (*gradients)(const View& view, const glm::vec3* voxels, std::size_t count, glm::vec3* gradients);
};

// Returns those of `target` (automatic: the widest), or null where they are not compiled or the machine lacks
// it.
const Kernels* kernelsOf(TracerTarget target);

}  // namespace isolux::volume::tracing
