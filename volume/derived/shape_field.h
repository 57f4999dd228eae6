// World gradient and Hessian of the field that derivatives are taken of, at its scale, in double precision.
//
// Data units per mm and per mm^2. Any thread.
#pragma once

#include <memory>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/choices.h"
#include "volume/derived/cubic_fields.h"
#include "volume/field/reconstruct.h"
#include "volume/grid.h"

namespace isolux::volume {

class ShapeField {
 public:
  // Makes what the field needs. `grid` and `fields` are of one volume and outlive it. scaleMm as
  // derivatives.scale; the trilinear field has none. Throws Error{interrupted, memory}.
  ShapeField(const Grid& grid, CubicFields& fields, scene::Field field, double scaleMm,
             base::Progress& progress);

  // Of voxel coordinates within the volume; NaN where samples that it needs are missing.
  FieldSample atVoxel(const glm::dvec3& voxel) const;
  double scaleMm() const { return scaled_ ? scaleMm_ : 0.0; }

 private:
  FieldSample perVoxel(const glm::dvec3& voxel) const;

  const Grid& grid_;
  scene::Field field_;
  double scaleMm_;
  std::shared_ptr<const ScaledField> scaled_;
  std::shared_ptr<const CubicField> cubic_;
};

}  // namespace isolux::volume
