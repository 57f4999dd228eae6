#include "volume/derived/shape_field.h"

namespace isolux::volume {

ShapeField::ShapeField(const Grid& grid, CubicFields& fields, scene::Field field, double scaleMm,
                       base::Progress& progress)
    : grid_(grid), field_(field), scaleMm_(scaleMm), scaled_(fields.make(field, scaleMm, progress)) {
  if (!scaled_ && field == scene::Field::cubic_interpolating) cubic_ = fields.make(field, progress);
}

FieldSample ShapeField::atVoxel(const glm::dvec3& voxel) const {
  FieldSample sample =
      sampleField(grid_, field_, cubic_ ? cubic_->coefficients.get() : nullptr, voxel, scaled_.get());
  sample.gradient = worldGradient(grid_.geometry(), sample.gradient);
  sample.hessian = worldHessian(grid_.geometry(), sample.hessian);
  return sample;
}

}  // namespace isolux::volume
