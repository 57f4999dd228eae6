// The point of an isosurface that lies straight below or above a point near it.
#pragma once

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/choices.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"

namespace isolux::volume {

class SurfaceProjection {
 public:
  // coefficients: of cubic_interpolating, else null. isovalue: data units. Keeps references.
  SurfaceProjection(const Grid& grid, scene::Field field, const Coefficients* coefficients, double isovalue);

  // By Newton's steps along the gradient of the world, to 1e-9 voxel; voxel coordinates. Nothing where they
  // do not come to the surface within two voxels.
  std::optional<glm::dvec3> of(const glm::dvec3& voxel) const;

 private:
  const Grid& grid_;
  scene::Field field_;
  const Coefficients* coefficients_;
  double isovalue_;
  glm::dmat3 metric_;  // A^-1 A^-T: turns a gradient of voxel space into the direction across in the world
};

}  // namespace isolux::volume
