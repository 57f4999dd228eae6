// The cube that shows how the view is turned, as a picture and as something to click on.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "scene/camera.h"
#include "scene/world_axes.h"

namespace isolux::app {

// A face that is seen. Pixels from the cube's middle, x right, y down.
struct CubeFace {
  scene::StandardView view;  // from its side
  std::string letter;        // of the end of the axis
  double facing;             // cosine between its normal and the way to the viewer, above 0
  std::array<glm::dvec2, 4> corners;
  glm::dvec2 middle, right, up;  // right and up: half an edge, as its letter stands
};

// halfEdge: pixels. The farthest corner lies sqrt(3) times that from the middle.
std::vector<CubeFace> cubeFaces(const scene::CameraFrame& frame, scene::WorldAxes axes, double halfEdge);

std::optional<scene::StandardView> faceAt(const std::vector<CubeFace>& faces, glm::dvec2 fromMiddle);

}  // namespace isolux::app
