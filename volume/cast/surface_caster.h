// The first crossing of a picture's rays with up to four isosurfaces, exactly, on the processor.
//
// Definitions are those of pass `cast` (resources/shaders/cast/): a hit is the first change of (f >=
// isovalue), in either direction; the side is carried from cell to cell; a cell with a missing voxel holds no
// surface. Arithmetic is float, of values less their middle and scaled like texels (value_scaling.h). Rays of
// 4x4 pixels go together, one per SIMD lane.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/choices.h"
#include "volume/cast/picture_area.h"
#include "volume/cast/picture_rays.h"
#include "volume/cast/start_depths.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume {

class ClipRegion;
class VoxelMask;
class ShownCells;

namespace casting {
class CellBitsOnDemand;
struct CastKernels;
struct CastView;
}  // namespace casting

// The field that is cast: the trilinear one of a grid, or the tri-cubic B-spline of its samples or of
// coefficients (cubic_interpolating).
struct CastField {
  const Grid& grid;
  scene::Field field = scene::Field::trilinear;
  const Coefficients* coefficients = nullptr;
  // Of each isovalue what is hidden, null where nothing is; or empty. `inside`: of pieces.
  std::span<const VoxelMask* const> hidden = {};
  scene::Inside inside = scene::Inside::above;
  // What is kept of the surfaces that are cut (voxel coordinates; null: nothing is cut), a bit for each of
  // them, and where rays end for other reasons (cut faces): t of each pixel of what is cast, +inf where they
  // do not, or empty. Shadows heed the first two.
  const ClipRegion* region = nullptr;
  int clipped = 0;
  std::span<const float> rayEnds = {};
};

// A part of what is cast, pixels [begin, end), `begin` a multiple of 4, and the pixel (0, 0) of the images it
// is written to, whose rows are `stride` pixels apart. points: voxel coordinates and t (mm; -1: no surface).
// infos: |f - isovalue| in texels, and HitInfo.
struct CastTarget {
  glm::ivec2 begin{0}, end{0};
  glm::vec4* points = nullptr;
  glm::vec2* infos = nullptr;
  std::size_t stride = 0;
};

// A crossing of each pixel's ray, bottom row first; beyond `area` there is none.
struct CrossingImage {
  explicit CrossingImage(glm::ivec2 size);
  PictureArea area;
  std::vector<glm::vec4> points;  // as of CastTarget
  std::vector<glm::vec2> infos;
};

// The crossings that rays come from, and how much of the pixel is covered; above kMostCovered the ray ends.
struct CrossingsBefore {
  static constexpr float kMostCovered = 0.996f;  // what lies behind adds less than a step of 8 bits
  const CrossingImage& crossings;
  std::span<const float> covered;
};

// A light infinitely far away, and the camera that saw what it shines on
// (resources/shaders/look/surface.glsl).
struct ShadowRays {
  PictureRays rays;
  glm::vec3 right{0.0f}, up{0.0f}, forward{0.0f};  // the camera's unit axes, world
  float outward = 1.0f;                            // times the gradient
  glm::mat3 voxelFromWorld{1.0f};                  // of directions
  glm::vec3 light{0.0f};                           // unit, world, toward the light
  int opaque = 0;                                  // a bit for each surface that stops light
  int first = 0;                                   // of the surfaces that are traced, among all
  int surfaces = 4;                                // that are traced
};

// Beyond `area` all are 0.
struct ShadowImage {
  PictureArea area;
  std::vector<std::uint8_t> lit;  // 255; 0: in shadow, facing away, or no surface
};

class SurfaceCaster {
 public:
  // Whether this machine has the vector instructions (SSE4.1, AVX2, AVX-512, NEON), and which are taken.
  static bool available() { return target() != nullptr; }
  static const char* target();

  // storedIsovalues: one to four, stored units. masks: of them, by BoxBounds::masks of the same field; blocks
  // of 8^3 cells. Field and masks must stay. The grid has at least 2 voxels on each axis. wanted: one of
  // those that this machine has, for tests. Throws base::Error{memory} for cubic fields.
  SurfaceCaster(const CastField& field, std::span<const double> storedIsovalues, glm::ivec3 blocks,
                std::span<const std::uint64_t> masks, TracerTarget wanted = TracerTarget::automatic);
  ~SurfaceCaster();

  StartDepths startDepths(const PictureRays& rays, glm::ivec2 size) const;
  // On the calling thread. Safe from many.
  void cast(const PictureRays& rays, const StartDepths& depths, const CastTarget& target) const;
  // All pixels of `out`, on all threads of the caller's arena. Of what it held before, only its area is
  // overwritten; not all of it once a stop is asked for, which is heeded within a millisecond.
  void castAll(const PictureRays& rays, CrossingImage& out, const std::stop_token& stop = {}) const;
  // The next crossings behind those, of an image of the same size.
  void castBehind(const PictureRays& rays, const CrossingsBefore& before, CrossingImage& out,
                  const std::stop_token& stop = {}) const;
  // Whether the light reaches those crossings. gradients: world, of each pixel.
  void castShadows(const ShadowRays& shadow, const CrossingImage& hits, std::span<const glm::vec4> gradients,
                   ShadowImage& out, const std::stop_token& stop = {}) const;

 private:
  template <class MayHit, class Cast>
  static void castPieces(CrossingImage& out, const std::stop_token& stop, const MayHit& mayHit,
                         const Cast& cast);
  std::span<const std::uint64_t> masks_;
  std::unique_ptr<casting::CellBitsOnDemand> cells_;  // of cubic fields
  std::vector<ShownCells> shown_;
  std::unique_ptr<casting::CastView> view_;
  const casting::CastKernels* kernels_;
};

}  // namespace isolux::volume
