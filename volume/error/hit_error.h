// Between which places single precision may put the first crossing of a pixel's ray, in double precision:
// running error analysis of what casts it (resources/shaders/cast, volume/cast).
//
// Rounded arithmetic finds the crossing of the isovalue by a field that differs from the true one along the
// true ray by at most some e. Before the first crossing of isovalue - e and isovalue + e no such field can
// have crossed, behind the later of the two first crossings each has: they enclose every answer, whatever the
// order of operations. docs/explanation/numerics.md derives e.
#pragma once

#include <limits>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "volume/cast/picture_rays.h"
#include "volume/field/coefficients.h"
#include "volume/hit/cell_walk.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::volume {

// Root mean square of one rounding to single precision, parts of the number: half a unit in the last place,
// uniform, over mantissas that are logarithmically uniform: 2^-24 sqrt(1/3 * 3/8 / ln 2).
inline constexpr double kFloatRounding = 0.425 * 0x1p-24;
// Bounds are this many root mean squares of the sum of all roundings: 99.9 % of a normal distribution. What
// is known of it (the rounding of the camera) is added as it is.
inline constexpr double kErrorLevel = 3.3;

// Where float arithmetic puts the point t mm along a ray.
struct RayRounding {
  glm::dvec3 shift{0.0};        // voxels: what the rounded camera makes of it, known
  glm::dvec3 deviation{0.0};    // voxels, along each axis: of what is rounded in each pixel
  double depthDeviation = 0.0;  // mm: of t as it is handed on
};
// fragment: centre of the pixel, in pixels from the lower left corner of the whole picture. exact: the same
// ray in double precision, which starts `startMm` along it (ViewUniforms::rayStartMm, orthographic views).
RayRounding rayRounding(const PictureRays& rays, glm::dvec2 fragment, const Ray& exact, double startMm,
                        double t, bool onProcessor);

// What is hit. coefficients: of cubic_interpolating.
struct HitSource {
  const Grid& grid;
  const MinMaxBlocks& blocks;  // of the field
  scene::Field field = scene::Field::trilinear;
  const Coefficients* coefficients = nullptr;
  bool onProcessor = false;  // which multiplies and adds in one rounding, and has integers as they are
};
// An isosurface, and between which t of this ray it is not cut away: one of its segments.
struct RaySurface {
  double isovalue = 0.0;  // data units
  HiddenPieces hidden{};
  double begin = -std::numeric_limits<double>::infinity(), end = std::numeric_limits<double>::infinity();
};

// Of the type of integers; 0 of floats. Texture units have them from 0 to 1.
double lowestStored(const Grid& grid);

struct HitEnclosure {
  bool hit = false;
  // False where the answer may change by a jump: it grazes, or misses by less than a rounding, another
  // crossing or a missing voxel is as near, or the ends of the enclosure are no continuous way apart.
  bool certain = true;
  double t = 0.0;                  // mm, in double precision
  double first = 0.0, last = 0.0;  // mm: of every answer
  double bound = 0.0;              // mm: how far a drawn depth may be from t; infinite where not certain
  double fieldError = 0.0;         // e, data units
  double randomPart = 1.0;         // of e: without what the rounded camera makes of it
  glm::dvec3 shifted{0.0};         // voxels: the crossing of the ray with the rounded camera
  double isovalue = 0.0;           // of what is hit
  glm::dvec3 voxel{0.0}, gradient{0.0};  // data units per voxel, of the field that is hit
  RayRounding rounding;                  // at t
};

// `ray`: voxel coordinates, t in mm. fieldErrorElsewhere: e for rays that hit nothing (fieldError of those
// that do). Any thread.
HitEnclosure encloseHit(const HitSource& source, std::span<const RaySurface> surfaces,
                        const PictureRays& rays, glm::dvec2 fragment, const Ray& ray, double startMm,
                        double fieldErrorElsewhere);

}  // namespace isolux::volume
