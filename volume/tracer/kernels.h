// What the kernels of the isosurface tracer share: the volume as they see it, and rays made ready for them.
// Internal to this folder.
//
// A prepared ray is scaled by a power of two so that the greatest component of its direction is in [1, 2),
// begins in the volume, and has no component 0: what it does not move along it creeps along, by 1e-30, so
// that no plane is at 0 / 0.
#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "volume/hit/shown_cells.h"
#include "volume/skip/cell_ranges.h"
#include "volume/tracer/isosurface_tracer.h"
#include "volume/tracer/simd_set.h"

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
  // One of them.
  const std::int16_t* signed16 = nullptr;
  const std::uint16_t* unsigned16 = nullptr;
  const float* float32 = nullptr;

  // Where pieces are hidden, and whether the inside of rays is the inside of pieces, or the other side.
  const ShownCells* shown = nullptr;
  bool insideIsOfPieces = true;

  bool traceable() const { return table != nullptr; }
};

// What is seen of a cell in which something is hidden: where on its stretch, s in [0, 1], a ray first enters
// the inside; below 0: nowhere. `outside`: the ray is known to be outside; becomes that at the end.
inline double entryIntoShown(const View& view, glm::ivec3 cell, const glm::dvec3& from, const glm::dvec3& to,
                             bool& outside) {
  const ShownWay way = view.shown->along(cell, from, to);
  for (const ShownWay::Part& part : way.parts()) {
    const bool inside = part.inside == view.insideIsOfPieces;
    if (outside && inside) return part.begin;
    outside = !inside;
  }
  return -1.0;
}

struct Kernels {
  SimdSet set;
  void (*firstEntries)(const View& view, const TraceRay* rays, std::size_t count, float* t);
  void (*anyEntries)(const View& view, const TraceRay* rays, std::size_t count, std::uint8_t* hit);
  void (*gradients)(const View& view, const glm::vec3* voxels, std::size_t count, glm::vec3* gradients);
};

const Kernels& scalarKernels();
// Those of `target` (not scalar; automatic: the widest), or null where they are not compiled or the machine
// lacks it.
const Kernels* simdKernels(TracerTarget target);

constexpr float kCreep = 1e-30f;

struct PreparedRay {
  float origin[3], direction[3], inverse[3];
  float tEnd;
  float isovalue;
  int bin;
  int cell[3];
  float scale;  // t of the caller = tBegin + t * scale
  float tBegin;

  float callerT(float t) const { return tBegin + t * scale; }
};

// Moves a ray that begins outside the volume to where it enters: in double precision, whatever the distance.
bool enterVolume(const View& view, const TraceRay& ray, glm::vec3& origin, float& tBegin);

// False: the ray meets nothing.
inline bool prepare(const View& view, const TraceRay& ray, PreparedRay& out) {
  const glm::vec3 d = ray.direction;
  const float greatest = std::fmax(std::fmax(std::fabs(d.x), std::fabs(d.y)), std::fabs(d.z));
  // Comparisons with NaN are false; sums of finite numbers that are not huge are finite.
  const float sum = (d.x - d.x) + (d.y - d.y) + (d.z - d.z) + (ray.origin.x - ray.origin.x) +
                    (ray.origin.y - ray.origin.y) + (ray.origin.z - ray.origin.z) +
                    (ray.isovalue - ray.isovalue);
  if (!(sum == 0.0f) || !(greatest > 0.0f) || !(ray.tMaximum > 0.0f)) return false;
  glm::vec3 origin = ray.origin;
  out.tBegin = 0.0f;
  const bool within = origin.x >= 0.0f && origin.y >= 0.0f && origin.z >= 0.0f &&
                      origin.x <= static_cast<float>(view.dims.x - 1) &&
                      origin.y <= static_cast<float>(view.dims.y - 1) &&
                      origin.z <= static_cast<float>(view.dims.z - 1);
  if (!within && !enterVolume(view, ray, origin, out.tBegin)) return false;
  // 2^-e, exact but for directions so long or short that float has no such power.
  const std::uint32_t exponent = std::bit_cast<std::uint32_t>(greatest) >> 23;
  const float shrink = std::bit_cast<float>((exponent >= 253 ? 1u : 254u - exponent) << 23);
  out.scale = shrink;
  out.tEnd = (ray.tMaximum - out.tBegin) / shrink;
  for (int axis = 0; axis < 3; ++axis) {
    const float last = static_cast<float>(view.dims[axis] - 1);
    float along = d[axis] * shrink;
    if (std::fabs(along) < kCreep) along = origin[axis] >= last ? -kCreep : kCreep;
    out.origin[axis] = origin[axis];
    out.direction[axis] = along;
    out.inverse[axis] = 1.0f / along;
    const float leaves = ((along > 0.0f ? last : 0.0f) - origin[axis]) * out.inverse[axis];
    out.tEnd = leaves < out.tEnd ? leaves : out.tEnd;
    const int below = static_cast<int>(origin[axis]);
    out.cell[axis] = below > view.dims[axis] - 2 ? view.dims[axis] - 2 : below;
  }
  if (!(out.tEnd > 0.0f)) return false;
  out.isovalue = ray.isovalue;
  out.bin = view.ranges->bins()(ray.isovalue);
  return true;
}

}  // namespace isolux::volume::tracing
