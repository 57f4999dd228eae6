// What a volume says at points of the world, in double precision: value, gradient, curvature and how sure
// they are.
#pragma once

#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/derived/shape_field.h"
#include "volume/field/curvature.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

struct ProbedPoint {
  glm::dvec3 world{0.0}, voxel{0.0};
  double value = 0.0;              // data units, of hit.field
  glm::dvec3 gradient{0.0};        // data units per mm, world, of the field at the scale
  glm::dmat3 hessian{0.0};         // data units per mm^2, the same
  PrincipalCurvature curvature{};  // with the normal; zero where the gradient vanishes
  double confidence = 0.0, scaleMm = 0.0;
};

class PointProbe {
 public:
  // `resolved`: with derivatives.scale and .noise filled in (DerivativeChoices::complete). Makes the fields
  // that are needed. Throws Error{interrupted, memory}.
  PointProbe(std::shared_ptr<const PreparedVolume> volume, const scene::Scene& resolved,
             base::Progress& progress);

  // Nothing outside the volume, and where voxels that the fields need are missing. Any thread.
  std::optional<ProbedPoint> at(glm::dvec3 world) const;

 private:
  std::shared_ptr<const PreparedVolume> volume_;
  ShapeField values_, shape_;  // of hit.field, and of what derivatives are of
  double outward_;
  CurvatureScale curvatureScale_;
};

}  // namespace isolux::volume
