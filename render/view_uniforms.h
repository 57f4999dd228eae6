// The camera as the shaders want it: in voxel space, float, made in double.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/camera.h"
#include "volume/grid.h"

namespace isolux::render {

struct ViewUniforms {
  glm::dvec3 eyeVoxel, rightVoxel, upVoxel, forwardVoxel;  // common.glsl
  glm::dvec3 rightWorld, upWorld, forwardWorld;
  glm::dvec2 halfExtent;
  bool orthographic;
  double rayStartMm;  // what a ray's t = 0 lies behind the camera's eye: 0, or for orthographic views far
                      // enough back that the whole volume is in front
  glm::dvec2 depthRangeMm;  // of the volume's corners along the view direction, from t = 0

  ViewUniforms(const scene::Camera& camera, double aspect, const volume::GridGeometry& geometry);
};

}  // namespace isolux::render
