// Where marks lie in the picture, and what of them is behind the surface.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/marks/mark_report.h"
#include "scene/camera.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// A point of the world in a picture of this size: pixels from its upper left corner; nothing for what lies
// behind the eye.
std::optional<glm::dvec2> pixelOf(const scene::CameraFrame& frame, glm::dvec3 worldMm, glm::dvec2 size);

// Whether a surface lies more than half a voxel's diagonal before it. `resolved`: scene::resolve of this
// volume.
bool isBehindSurface(const volume::PreparedVolume& volume, const scene::Scene& resolved, glm::dvec3 worldMm,
                     double aspect);

// A polyline in the world; `hidden` of each corner, once that is known.
struct MarkLine {
  std::vector<glm::dvec3> corners;
  bool onSurface = false;  // else it passes through the air or the inside: dashed
  std::vector<bool> hidden;
};

// What is drawn of a mark.
struct MarkShape {
  MarkLine points;              // dots
  std::vector<MarkLine> lines;  // at most 128 corners each
  glm::dvec3 anchor{0.0};       // where the label stands beside
  std::string label;
  glm::dvec3 color{1.0};  // linear
};

MarkShape markShape(const scene::Mark& mark, const MarkReport& report);

}  // namespace isolux::app
