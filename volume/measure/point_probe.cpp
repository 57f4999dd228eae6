#include "volume/measure/point_probe.h"

#include <cmath>

#include "volume/field/reconstruct.h"

namespace isolux::volume {

namespace {

constexpr double kBorderSlack = 1e-9;  // voxels: a point on the border is inside

bool within(const GridGeometry& geometry, const glm::dvec3& voxel) {
  for (int axis = 0; axis < 3; ++axis)
    if (!(voxel[axis] >= -kBorderSlack && voxel[axis] <= geometry.dims[axis] - 1 + kBorderSlack))
      return false;
  return true;
}

}  // namespace

PointProbe::PointProbe(std::shared_ptr<const PreparedVolume> volume, const scene::Scene& resolved,
                       base::Progress& progress)
    : volume_(std::move(volume)),
      hitField_(resolved.hit.field),
      shapeField_(resolved.derivatives.field),
      outward_(resolved.isosurface.inside == scene::Inside::above ? -1.0 : 1.0),
      scaleMm_(resolved.derivatives.scale.value_or(0.0)) {
  CubicFields& fields = *volume_->cubicFields;
  const auto interpolating = scene::Field::cubic_interpolating;
  if (hitField_ == interpolating || shapeField_ == interpolating)
    interpolating_ = fields.make(interpolating, progress);
  scaled_ = fields.make(shapeField_, scaleMm_, progress);
  if (!scaled_) scaleMm_ = 0.0;
  const scene::NoiseModel noise = volume_->derivativeChoices->noise(progress);
  curvatureScale_ = curvatureScale(volume_->grid().geometry(), shapeField_,
                                   resolved.derivatives.noise.value_or(0.0), noise.correlation, scaleMm_);
}

FieldSample PointProbe::sample(scene::Field field, glm::dvec3 voxel) const {
  const Grid& grid = volume_->grid();
  if (field == scene::Field::trilinear) return sampleTrilinear(grid, voxel);
  if (field == scene::Field::cubic) return sampleCubic(grid, voxel);
  return sampleCubic(*interpolating_->coefficients, grid, voxel);
}

std::optional<ProbedPoint> PointProbe::at(glm::dvec3 world) const {
  const GridGeometry& geometry = volume_->grid().geometry();
  ProbedPoint point;
  point.world = world;
  point.voxel = glm::dvec3(geometry.voxelFromWorld() * glm::dvec4(world, 1.0));
  if (!within(geometry, point.voxel)) return std::nullopt;
  point.value = sample(hitField_, point.voxel).value;
  const FieldSample shape =
      scaled_ ? sampleScaled(*scaled_, volume_->grid(), point.voxel) : sample(shapeField_, point.voxel);
  if (!std::isfinite(point.value) || !std::isfinite(shape.value)) return std::nullopt;
  point.gradient = worldGradient(geometry, shape.gradient);
  point.curvature = principalCurvature(point.gradient, worldHessian(geometry, shape.hessian), outward_);
  point.confidence = curvatureConfidence(point.curvature, point.gradient, curvatureScale_);
  point.scaleMm = scaleMm_;
  return point;
}

}  // namespace isolux::volume
