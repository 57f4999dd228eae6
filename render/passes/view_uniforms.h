// Provides the camera for the shaders: in voxel space, as float, computed in double.
//
// If the eye is many times the volume's size away, rays start on a plane in front of the volume. The corners
// of this plane are computed in double precision, because float loses the eye's position. Near eyes keep
// their rays.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/camera.h"
#include "volume/cast/picture_rays.h"
#include "volume/grid.h"

namespace isolux::render {

struct ViewUniforms {
  glm::dvec3 eyeVoxel;                           // where the central ray starts
  glm::dvec3 rightVoxel, upVoxel, forwardVoxel;  // common.glsl
  glm::dvec3 rightWorld, upWorld, forwardWorld;
  glm::dvec2 halfExtent;
  bool orthographic;
  double rayStartMm;  // orthographic: how far before the camera's eye t = 0 lies, so that the whole volume is
                      // in front of it and not too far
  double startDepth;  // perspective: how far before the eye the plane t = 0 lies, mm; 0 unless the eye is far
                      // away
  glm::dvec2 depthRangeMm;  // of the volume's corners along the view direction, from rayStartMm

  ViewUniforms(const scene::Camera& camera, double aspect, const volume::GridGeometry& geometry);

  // Returns the same view for the CPU: `picture` rays, of which those from `origin` on are cast.
  volume::PictureRays rays(glm::ivec2 picture, glm::ivec2 origin) const;
};

}  // namespace isolux::render
