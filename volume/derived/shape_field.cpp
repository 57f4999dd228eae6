#include "volume/derived/shape_field.h"

namespace isolux::volume {

ShapeField::ShapeField(const Grid& grid, CubicFields& fields, scene::Field field, double scaleMm,
                       base::Progress& progress)
    : grid_(grid), field_(field), scaleMm_(scaleMm), scaled_(fields.make(field, scaleMm, progress)) {
  if (!scaled_ && field == scene::Field::cubic_interpolating) cubic_ = fields.make(field, progress);
}

FieldSample ShapeField::perVoxel(const glm::dvec3& voxel) const {
  if (scaled_) return sampleScaled(*scaled_, grid_, voxel);
  if (field_ == scene::Field::trilinear) return sampleTrilinear(grid_, voxel);
  return cubic_ ? sampleCubic(*cubic_->coefficients, grid_, voxel) : sampleCubic(grid_, voxel);
}

FieldSample ShapeField::atVoxel(const glm::dvec3& voxel) const {
  FieldSample sample = perVoxel(voxel);
  sample.gradient = worldGradient(grid_.geometry(), sample.gradient);
  sample.hessian = worldHessian(grid_.geometry(), sample.hessian);
  return sample;
}

}  // namespace isolux::volume
