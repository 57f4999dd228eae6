// Normal and curvature at a point in double precision, and how far single precision may be from them.
//
// What is summed are samples less one of them, times weights: each sample, weight, product and sum is rounded
// (resources/shaders/cast/spline.glsl, quintic.glsl, volume/cast). Errors are first order in the rounding;
// docs/explanation/numerics.md derives them.
#pragma once

#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/choices.h"
#include "volume/field/coefficients.h"
#include "volume/field/scaled_field.h"
#include "volume/grid.h"

namespace isolux::volume {

// Whose derivatives. coefficients: of cubic_interpolating; scaled: of the field at a scale, null at 0.
struct DerivedShape {
  const Grid& grid;
  scene::Field field = scene::Field::cubic;
  const Coefficients* coefficients = nullptr;
  const ScaledField* scaled = nullptr;
  scene::Fetch fetch = scene::Fetch::exact;
  double outward = -1.0;     // volume/field/curvature.h
  bool exactSamples = true;  // the processor's; texture units round integers
};

struct ShapeAt {
  glm::dvec3 normal{0.0};  // 0: there is none
  double kappa1 = 0.0, kappa2 = 0.0;
  bool hasCurvature = false;
  double gradient = 0.0;  // |world gradient|, data units per mm
  double bend = 0.0;      // |world Hessian|, data units per mm^2
  double lean =
      0.0;  // the tangential part of Hessian times normal: how fast |gradient| changes along the surface
};
// As the passes `gradient`, `hessian` and `curvature`: next to missing voxels the cell's own gradient, and no
// curvature. voxel: voxel coordinates. Any thread.
ShapeAt shapeAt(const DerivedShape& shape, const glm::dvec3& voxel);

// Root mean squares of what rounding makes of normal and curvature at a point, positions apart.
struct ShapeRounding {
  double normal = 0.0;     // radians, along a tangent
  double curvature = 0.0;  // 1/mm
};
ShapeRounding shapeRounding(const DerivedShape& shape, const glm::dvec3& voxel, const ShapeAt& at);

// How far shapes of single precision may be from that at `voxel`. What is known: at `shifted`, added as it
// is. What is random, as the root of squares: at the farthest of `ends`, where the hit may be along its ray;
// at distances of `deviation` along each axis (voxels, root mean squares); by rounding; kErrorLevel of each.
// Infinite where there is no shape on one of the ways.
struct ShapeBound {
  double normalDegrees = 0.0;
  double curvature = 0.0;  // 1/mm, of each of kappa1 and kappa2
  ShapeAt at;
};
ShapeBound boundShape(const DerivedShape& shape, const glm::dvec3& voxel, const glm::dvec3& shifted,
                      std::span<const glm::dvec3> ends, const glm::dvec3& deviation);

}  // namespace isolux::volume
