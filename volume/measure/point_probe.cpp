#include "volume/measure/point_probe.h"

#include <cmath>
#include <utility>

namespace isolux::volume {

namespace {

constexpr double kBorderSlack = 1e-9;  // voxels: a point on the border is inside

}  // namespace

PointProbe::PointProbe(std::shared_ptr<const PreparedVolume> volume, const scene::Scene& resolved,
                       base::Progress& progress)
    : volume_(std::move(volume)),
      values_(volume_->grid(), *volume_->cubicFields, resolved.hit.field, 0.0, progress),
      shape_(volume_->grid(), *volume_->cubicFields, resolved.derivatives.field,
             resolved.derivatives.scale.value_or(0.0), progress),
      outward_(resolved.isosurface.inside == scene::Inside::above ? -1.0 : 1.0) {
  const scene::NoiseModel noise = volume_->derivativeChoices->noise(progress);
  curvatureScale_ =
      curvatureScale(volume_->grid().geometry(), resolved.derivatives.field,
                     resolved.derivatives.noise.value_or(0.0), noise.correlation, shape_.scaleMm());
}

std::optional<ProbedPoint> PointProbe::at(glm::dvec3 world) const {
  const GridGeometry& geometry = volume_->grid().geometry();
  ProbedPoint point;
  point.world = world;
  point.voxel = geometry.voxelOf(world);
  if (!geometry.holds(point.voxel, kBorderSlack)) return std::nullopt;
  point.value = values_.atVoxel(point.voxel).value;
  const FieldSample shape = shape_.atVoxel(point.voxel);
  if (!std::isfinite(point.value) || !std::isfinite(shape.value)) return std::nullopt;
  point.gradient = shape.gradient;
  point.hessian = shape.hessian;
  point.curvature = principalCurvature(point.gradient, shape.hessian, outward_);
  point.confidence = curvatureConfidence(point.curvature, point.gradient, curvatureScale_);
  point.scaleMm = shape_.scaleMm();
  return point;
}

}  // namespace isolux::volume
