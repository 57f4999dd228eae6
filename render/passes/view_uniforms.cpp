#include "render/passes/view_uniforms.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace isolux::render {

namespace {
constexpr double kFarExtents = 8.0;  // floats lose half a thousandth of a voxel of 1000 there
}

ViewUniforms::ViewUniforms(const scene::Camera& camera, double aspect, const volume::GridGeometry& geometry) {
  const scene::CameraFrame frame = scene::frameOf(camera);
  rightWorld = frame.right;
  upWorld = frame.up;
  forwardWorld = -frame.back;
  orthographic = frame.projection == scene::Projection::orthographic;
  halfExtent = {frame.halfHeight * aspect, frame.halfHeight};

  volume::Bounds<double> depths;
  for (const glm::dvec3& corner : geometry.corners()) depths.add(glm::dot(corner - frame.eye, forwardWorld));
  const auto [nearest, farthest] = depths;
  const double extent = farthest - nearest, before = nearest - 0.01 * extent;
  const bool far = nearest > kFarExtents * extent;
  rayStartMm = orthographic ? (far ? before : std::min(0.0, before)) : 0.0;
  startDepth = !orthographic && far ? before : 0.0;
  depthRangeMm = glm::dvec2(std::max(nearest, rayStartMm), farthest) - rayStartMm;

  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  const glm::dmat3 linear(voxelFromWorld);
  eyeVoxel =
      glm::dvec3(voxelFromWorld * glm::dvec4(frame.eye + (rayStartMm + startDepth) * forwardWorld, 1.0));
  rightVoxel = linear * rightWorld;
  upVoxel = linear * upWorld;
  forwardVoxel = linear * forwardWorld;
}

volume::PictureRays ViewUniforms::rays(glm::ivec2 picture, glm::ivec2 origin) const {
  return {.eye = eyeVoxel,
          .right = rightVoxel,
          .up = upVoxel,
          .forward = forwardVoxel,
          .halfExtent = halfExtent,
          .orthographic = orthographic,
          .startDepth = static_cast<float>(startDepth),
          .picture = picture,
          .origin = origin};
}

}  // namespace isolux::render
