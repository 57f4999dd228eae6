// Evaluates continuous fields from samples: trilinear, tri-cubic B-spline, and tri-quintic at a scale σ;
// value and derivatives, in double precision.
//
// The CPU reference for the shaders. Positions are voxel coordinates inside [0, n-1]; outside they are
// clamped. Derivatives are per voxel; GridGeometry transforms them to world: g_w = A^-T g_v, H_w = A^-T H_v
// A^-1. Values are data units. A missing voxel among the samples of a lookup (8 or 64) makes its result NaN.
// Samples beyond the border repeat the border sample (clamp), on CPU and GPU.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/choices.h"
#include "volume/field/coefficients.h"
#include "volume/field/scaled_field.h"
#include "volume/grid.h"

namespace isolux::volume {

struct FieldSample {
  double value = 0.0;
  glm::dvec3 gradient{0.0};  // per voxel
  glm::dmat3 hessian{0.0};   // per voxel squared, symmetric
};

FieldSample sampleTrilinear(const Grid& grid, glm::dvec3 voxel);  // hessian: only the mixed terms are not 0
FieldSample sampleCubic(const Grid& grid, glm::dvec3 voxel);  // the samples are the coefficients (smoothing)
// Evaluates the spline that interpolates the samples: interpolatingCoefficients(grid).
FieldSample sampleCubic(const Coefficients& coefficients, const Grid& grid, glm::dvec3 voxel);

// Evaluates the field at a scale σ. Unlike the others it continues beyond the border by point reflection, and
// is finite also where voxels are missing.
FieldSample sampleScaled(const ScaledField& scaled, const Grid& grid, glm::dvec3 voxel);

// Evaluates `field`, or `scaled` unless it is null. `coefficients`: of cubic_interpolating, else null.
FieldSample sampleField(const Grid& grid, scene::Field field, const Coefficients* coefficients,
                        glm::dvec3 voxel, const ScaledField* scaled = nullptr);

glm::dvec3 worldGradient(const GridGeometry& geometry, glm::dvec3 voxelGradient);
glm::dmat3 worldHessian(const GridGeometry& geometry, const glm::dmat3& voxelHessian);

}  // namespace isolux::volume
