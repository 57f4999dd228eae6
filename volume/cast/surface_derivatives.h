// World gradient and Hessian at the surface points of a picture, on the processor: what the passes `gradient`
// and `hessian` write (resources/shaders/derivatives/derivatives.frag.glsl), with their definitions.
//
// g_w = A^-T g_v, data units per mm; H_w = A^-T H_v A^-1, per mm^2. Where a sample of the B-spline is
// missing: the trilinear gradient, no Hessian. The field at a scale is known everywhere.
#pragma once

#include <span>
#include <stop_token>

#include <glm/vec4.hpp>

#include "volume/cast/picture_area.h"
#include "volume/edge/edge_walk.h"
#include "volume/field/scaled_field.h"
#include "volume/grid.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume {

// Spans of equal length; those of the Hessian may both be empty. gradient: w = 1 where there is a surface;
// diagonal: xx, yy, zz, w = 1 where the Hessian is known; mixed: xy, xz, yz, w = 1 where all samples are the
// volume's own.
struct DerivativeImages {
  std::span<glm::vec4> gradient, diagonal, mixed;
};

// What is derived. At a scale `samples are the volume's own` where all 6^3 coefficients of a lookup are, and
// axes may have a single voxel.
struct DerivedField {
  const Coefficients* coefficients = nullptr;  // of the spline; null: the samples themselves
  const ScaledField* scaled = nullptr;         // instead of the spline, unless it is null
  bool trilinear = false;                      // the trilinear field instead
};

// points: voxel coordinates, w < 0 where there is no surface; those beyond `area` are left alone, and
// some within once a stop is asked for. On all threads of the caller's arena. Needs
// SurfaceCaster::available().
void surfaceDerivatives(const Grid& grid, const DerivedField& field, std::span<const glm::vec4> points,
                        const PictureArea& area, const DerivativeImages& images,
                        TracerTarget wanted = TracerTarget::automatic, const std::stop_token& stop = {});

// Where the edge of the object is (volume/edge/edge_walk.h): offset, mm, and strength at each point, `none`
// and 0 where there is neither. The field: a spline, or one at a scale.
void surfaceEdges(const Grid& grid, const DerivedField& field, const EdgeSearch<float>& search,
                  std::span<const glm::vec4> points, const PictureArea& area, std::span<glm::vec2> edges,
                  float none, TracerTarget wanted = TracerTarget::automatic,
                  const std::stop_token& stop = {});

}  // namespace isolux::volume
