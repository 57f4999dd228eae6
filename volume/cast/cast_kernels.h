// What the kernels of the caster share: the volume as they see it, and what they are asked for. Internal to
// this folder.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "volume/cast/cell_bits_on_demand.h"
#include "volume/cast/surface_caster.h"
#include "volume/clip/clip_region.h"
#include "volume/edge/edge_walk.h"
#include "volume/hit/shown_cells.h"
#include "volume/tracer/simd_set.h"

namespace isolux::volume::casting {

using VoxelPointer = std::variant<const std::int8_t*, const std::uint8_t*, const std::int16_t*,
                                  const std::uint16_t*, const float*>;

// Stored values become (stored - offset) * scale.
struct CastView {
  glm::ivec3 dims{0};       // voxels; all at least 2
  glm::ivec3 blockDims{0};  // of 8^3 cells
  VoxelPointer samples;     // of the field: the voxels, or coefficients
  bool cubic = false;       // it is their tri-cubic B-spline, else trilinear
  float offset = 0.0f, scale = 1.0f;
  const float* gapsOf = nullptr;         // the voxels, where some are missing but known as coefficients
  bool gaps = false;                     // some voxel is missing: behind an empty box no side is known
  CellBitsOnDemand* cells = nullptr;     // of the cubic field
  const std::uint64_t* masks = nullptr;  // of each block: bit x + 4 y + 16 z, a box of 2^3 cells
  int surfaces = 1;                      // 1 to 4
  float isovalue = 0.0f;                 // the first, less the offset, stored units
  float shifts[4] = {};                  // each isovalue minus the first, scaled
  // Of each surface, where pieces of any are hidden.
  std::span<const ShownCells> shown;
  bool insideIsAbove = true;  // of pieces: stored values above the isovalue
  // CastField::region: kept is where dot(face, (p, 1)) <= 0, less boxes along `axes`; clipped and rayEnds as
  // there.
  std::array<glm::vec4, ClipRegion::kMostFaces> faces{};
  std::size_t faceCount = 0;
  struct Removed {
    glm::vec3 low, high;
  };
  std::array<Removed, ClipRegion::kMostRemoved> removed{};
  std::size_t removedCount = 0;
  glm::mat3 axes{1.0f};
  int clipped = 0;
  const float* rayEnds = nullptr;
};

// The nearest crossing that is seen on a ray's way through a cell: a bit of the surface (0: none) and s.
// inside: the sides at the beginning.
struct SeenCrossing {
  int inside = 0, changed = 0;
  double s = 2.0;
};
// fresh: the sides at the beginning are not known yet. first: the ray has just crossed surfaces there, so
// that which side it begins on is a matter of rounding.
SeenCrossing seenCrossing(const CastView& view, glm::ivec3 cell, const glm::dvec3& from, const glm::dvec3& to,
                          int inside, bool fresh, bool first);

// A part of a picture, pixels [begin, end); images whose rows are `stride` pixels apart. lit: 255, or 0 in
// shadow, where the surface faces away, and where there is none.
struct ShadowTarget {
  glm::ivec2 begin{0}, end{0};
  const glm::vec4* points;
  const glm::vec2* infos;
  const glm::vec4* gradients;
  std::uint8_t* lit;
  std::size_t stride;
};

struct DerivativesView {
  glm::ivec3 dims{0};
  VoxelPointer samples;            // the volume's
  VoxelPointer spline;             // whose B-spline is derived: the samples, or coefficients
  bool cubic = true;               // else the trilinear field
  const float* scaled = nullptr;   // coefficients of the field at a scale: derived instead of either
  glm::mat3 worldFromVoxel{1.0f};  // of gradients: A^-T
  float dataUnits = 1.0f;          // per stored unit
};

// Stored units per voxel (and per voxel squared).
struct PointDerivatives {
  glm::vec3 gradient, diagonal, mixed;  // diagonal: xx, yy, zz; mixed: xy, xz, yz
  bool known, within;                   // all samples are there; are the volume's own
};

// Images of what derivatives.frag.glsl writes; diagonal and mixed may be null.
struct DerivativesTarget {
  const glm::vec4* points;
  std::size_t count;
  glm::vec4 *gradient, *diagonal, *mixed;
};

struct EdgeView {
  DerivativesView field;  // its spline, or the field at a scale
  EdgeSearch<float> search;
  bool gaps = false;  // some voxel is missing
};

// Offset (mm; `none` where there is no edge) and strength at each point.
struct EdgeTarget {
  const glm::vec4* points;
  std::size_t count;
  glm::vec2* edges;
  float none;
};

// Derivatives at a point as the kernels of one instruction set compute them.
struct EdgeSampler {
  const void* derivatives;
  EdgeSample<float> (*at)(const void* derivatives, const glm::vec3& voxel);

  EdgeSample<float> operator()(const glm::vec3& voxel) const { return at(derivatives, voxel); }
};
// The walk, compiled once, for instructions that every processor has.
FoundEdge<float> edgeAt(const EdgeSearch<float>& search, const EdgeSampler& sampler, const glm::vec3& voxel);

struct CastKernels {
  tracing::SimdSet set;
  void (*cast)(const CastView& view, const PictureRays& rays, const StartDepths& depths,
               const CastTarget& target);
  void (*castBehind)(const CastView& view, const PictureRays& rays, const CrossingsBefore& before,
                     const CastTarget& target);
  void (*shadows)(const CastView& view, const ShadowRays& shadow, const ShadowTarget& target);
  void (*derivatives)(const DerivativesView& view, const DerivativesTarget& target);
  void (*edges)(const EdgeView& view, const EdgeTarget& target);
};

// Those of `target`; automatic: the widest of this machine. Null where they are not compiled or the machine
// lacks it.
const CastKernels* castKernels(TracerTarget target);

}  // namespace isolux::volume::casting
