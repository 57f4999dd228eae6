// Lamps of global illumination on the picture: where their handles are, and what dragging them does. Pure
// functions, no widgets.
//
// Pixels are logical, (0,0) the picture's top left corner, y down. World: mm.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/camera.h"
#include "scene/rules/automatic.h"

namespace isolux::app {

// What handles are drawn in.
struct LampStage {
  scene::CameraFrame frame;
  glm::dvec2 pixels{1.0};    // of the picture
  glm::dvec3 centreMm{0.0};  // of the volume
  double reachMm = 1.0;      // distant lamps have their handles on a ball of this radius about the centre
};
LampStage lampStageOf(const scene::Scene& resolved, const scene::VolumeFacts& facts, glm::dvec2 pixels);

struct LampHandle {
  std::string id;  // of the lamp
  int number = 0;  // its position in the list, from 1
  scene::LampKind kind = scene::LampKind::point;
  glm::dvec3 color{1.0};    // linear RGB
  glm::dvec2 pixel{0.0};    // where the handle is drawn: always on the picture
  bool outside = false;     // the lamp itself is not on the picture: `toward` points to it
  glm::dvec2 toward{0.0};   // unit, pixels
  bool far = false;         // behind the volume's centre as the viewer sees it
  double ringPixels = 0.0;  // outline about `ballPixel`: of a sphere, or of a distant lamp's ball; 0 none
  glm::dvec2 ballPixel{0.0};
  bool operator==(const LampHandle&) const = default;
};
// Of the lamps that are shown; none unless the shading is global illumination.
std::vector<LampHandle> lampHandles(const scene::Scene& resolved, const LampStage& stage);

enum class LampPart { handle, ring };  // ring: the radius of a sphere
struct LampGrip {
  std::string id;
  int number = 0;
  LampPart part = LampPart::handle;
  bool operator==(const LampGrip&) const = default;
};
std::optional<LampGrip> lampAt(const std::vector<LampHandle>& handles, glm::dvec2 pixel);

// Return the lamp of an id, or null.
const scene::Lamp* lampOf(const scene::Scene& scene, const std::string& id);
scene::Lamp* lampOf(scene::Scene& scene, const std::string& id);

// `lamp` is a resolved one. The handle comes to `pixel`: a lamp with a place moves in the plane through it
// that is parallel to the screen, a distant one on its side of the ball (beyond its rim, along the rim).
scene::Lamp lampMovedTo(const scene::Lamp& lamp, const LampStage& stage, glm::dvec2 pixel);
// Along the depth, `fraction` in parts of the picture's height: above 0 is away from the viewer.
scene::Lamp lampMovedAway(const scene::Lamp& lamp, const LampStage& stage, double fraction);
// A sphere's outline goes through `pixel`.
scene::Lamp lampResizedTo(const scene::Lamp& lamp, const LampStage& stage, glm::dvec2 pixel);

}  // namespace isolux::app
