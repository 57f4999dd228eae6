#include "volume/extraction/surface_arrays.h"

#include <cmath>
#include <limits>
#include <optional>

#include <glm/geometric.hpp>

#include "volume/color/second_values.h"
#include "volume/derived/shape_field.h"
#include "volume/field/curvature.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

}  // namespace

std::vector<PointArray> surfaceArrays(const PreparedVolume& volume, const scene::Scene& resolved,
                                      std::span<const glm::dvec3> points, bool curvature,
                                      base::Progress& progress) {
  const scene::Derivatives& d = resolved.derivatives;
  const GridGeometry& geometry = volume.grid().geometry();
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  const double outward = resolved.isosurface.inside == scene::Inside::above ? -1.0 : 1.0;
  const ShapeField forNormals(volume.grid(), *volume.cubicFields, d.field, d.normalScale.value_or(0.0),
                              progress);
  const ShapeField forCurvature(volume.grid(), *volume.cubicFields, d.field, d.scale.value_or(0.0), progress);
  const CurvatureScale scale =
      curvatureScale(geometry, d.field, d.noise.value_or(0.0),
                     curvature ? volume.derivativeChoices->noise(progress).correlation : glm::dvec3(0.0),
                     d.scale.value_or(0.0));
  std::vector<PointArray> arrays{{kNormalsName, 3, std::vector<float>(3 * points.size(), kNone)}};
  if (curvature)
    for (const char* name : {"kappa1", "kappa2", "confidence"})
      arrays.push_back({name, 1, std::vector<float>(points.size(), kNone)});
  parallelEach(points.size(), [&](std::size_t i) {
    if (progress.stopRequested()) return;
    const glm::dvec3 voxel(voxelFromWorld * glm::dvec4(points[i], 1.0));
    const glm::dvec3 gradient = forNormals.atVoxel(voxel).gradient;
    if (const double length = glm::length(gradient); length > 0.0)
      for (int axis = 0; axis < 3; ++axis)
        arrays[0].values[3 * i + static_cast<std::size_t>(axis)] =
            static_cast<float>(outward * gradient[axis] / length);
    if (!curvature) return;
    const FieldSample s = forCurvature.atVoxel(voxel);
    const PrincipalCurvature k = principalCurvature(s.gradient, s.hessian, outward);
    if (k.normal == glm::dvec3(0.0)) return;
    arrays[1].values[i] = static_cast<float>(k.kappa1);
    arrays[2].values[i] = static_cast<float>(k.kappa2);
    arrays[3].values[i] = static_cast<float>(curvatureConfidence(k, s.gradient, scale));
  });
  progress.throwIfStopped();
  return arrays;
}

PointArray secondValueArray(const PreparedVolume& volume, const scene::Scene& resolved,
                            std::span<const glm::dvec3> points, base::Progress& progress) {
  const SecondValues values(volume.secondVolumes->make(resolved.color, progress), resolved.color.field);
  PointArray array{"color_value", 1, std::vector<float>(points.size(), kNone)};
  const std::vector<PointArray> normals = resolved.color.below > 0.0
                                              ? surfaceArrays(volume, resolved, points, false, progress)
                                              : std::vector<PointArray>();
  parallelEach(points.size(), [&](std::size_t i) {
    std::optional<SecondValue> found;
    if (normals.empty()) {
      found = values.at(points[i]);
    } else {
      const float* const n = &normals[0].values[3 * i];
      const glm::dvec3 outward(n[0], n[1], n[2]);
      if (std::isfinite(outward.x)) found = values.largestBelow(points[i], -outward, resolved.color.below);
    }
    if (found) array.values[i] = static_cast<float>(found->value);
  });
  return array;
}

}  // namespace isolux::volume
