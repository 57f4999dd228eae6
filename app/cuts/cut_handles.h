// Handles of cuts on the picture: where they are, and which lies under the pointer. Pure functions, no
// widgets.
//
// A plane has a knob in the middle of the face that it cuts, which moves it along its normal, as its
// outline does, and an arrow whose tip turns it. The box has a knob on each face, one in its middle, which
// moves it, and corners that turn it; those that are removed have all but the last. Pixels are logical, (0,0)
// the picture's top left corner, y down.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "app/cuts/cut_edits.h"
#include "scene/camera.h"

namespace isolux::app {

// What handles are drawn in.
struct CutStage {
  scene::CameraFrame frame;
  glm::dvec2 pixels{1.0};  // of the picture
  BoxCorners volumeMm{};
};
CutStage cutStageOf(const scene::Scene& resolved, const volume::GridGeometry& geometry, glm::dvec2 pixels);

enum class CutPart {
  move,  // a plane along its normal; the box, parallel to the screen
  turn,  // a plane; the box, by its corner `index`
  face,  // of the box: 2 * axis + 1 on the far end of the axis, 2 * axis on the near one
};
struct CutGrip {
  int plane = 0;  // 1 .. 6; 0: the box; -1 .. -8: a removed one
  CutPart part = CutPart::move;
  int index = 0;
  bool operator==(const CutGrip&) const = default;
};

struct CutKnob {
  CutGrip grip;
  glm::dvec2 pixel{0.0};
  bool far = false;  // on the side that the viewer does not see
  bool operator==(const CutKnob&) const = default;
};
struct CutLine {
  glm::dvec2 from{0.0}, to{0.0};
  bool far = false;
  bool operator==(const CutLine&) const = default;
};
// One plane's, or a box's.
struct CutShape {
  int plane = 0;
  std::vector<CutLine> outline;
  std::vector<CutKnob> knobs;  // none where they would not be on the picture
  bool operator==(const CutShape&) const = default;
};
std::vector<CutShape> cutShapes(const scene::Clip& clip, const CutStage& stage);
// A knob within 11 pixels, the nearest; else a plane's outline within 5.
std::optional<CutGrip> cutAt(const std::vector<CutShape>& shapes, glm::dvec2 pixel);

// Pixels from a plane's knob to the tip of its arrow, seen from the side; and at least, however it is seen.
inline constexpr double kCutArrow = 62.0, kCutArrowLeast = 30.0;

// How a point of the world lies on the picture.
struct ProjectedPoint {
  glm::dvec2 pixel{0.0};
  double depthMm = 0.0, mmPerPixel = 1.0;
  bool before = true;  // the eye; else the pixel means nothing
};
ProjectedPoint projectedOn(const CutStage& stage, const glm::dvec3& world);
// Where planes[plane] has its knob: middleOfFace(), or, where that is not on the picture, what of the plane
// lies in the picture's middle.
glm::dvec3 knobOf(const scene::Clip& clip, std::size_t plane, const CutStage& stage);

}  // namespace isolux::app
