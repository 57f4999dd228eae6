// Declares what the kernels of the caster share: their view of the volume, and what they compute. Internal to
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
#include "volume/simd/simd_set.h"

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

// The nearest visible crossing within a cell: surface bit (0 = none) and parameter s. inside: the state at
// the beginning of the segment.
struct VisibleCrossing {
  int inside = 0, changed = 0;
  double s = 2.0;
};
// entered: the state at the beginning is not known yet. first: the ray has just crossed surfaces there, so
// that the side it begins on is a matter of rounding.
VisibleCrossing visibleCrossing(const CastView& view, glm::ivec3 cell, const glm::dvec3& from,
                                const glm::dvec3& to, int inside, bool entered, bool first);

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

// Computes derivatives at a point with the kernels of one instruction set.
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

// Returns those of `target` (automatic: the widest), or null where they are not compiled or the machine lacks
// it.
const CastKernels* castKernels(TracerTarget target);

}  // namespace isolux::volume::casting
