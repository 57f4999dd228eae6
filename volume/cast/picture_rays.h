// The rays of a picture as the shaders cast them (resources/shaders/common.glsl): in voxel space, float.
//
// A point t mm along a ray is origin + t * direction. Fragments count from the picture's lower left corner.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace isolux::volume {

struct PictureRays {
  glm::vec3 eye{0.0f};                             // where the middle ray starts
  glm::vec3 right{0.0f}, up{0.0f}, forward{0.0f};  // of the camera, voxels per mm
  glm::vec2 halfExtent{1.0f};                      // of the image plane: at unit distance, or mm
  bool orthographic = false;
  float startDepth = 0.0f;  // perspective: t = 0 lies on a plane so far before the eye
  glm::ivec2 picture{1};    // rays, of the whole picture
  glm::ivec2 origin{0};     // of what is cast, within the picture
};

}  // namespace isolux::volume
