// Reads images from the GPU as plain values: frames, AOVs, and the visible surface points.
#pragma once

#include <optional>

#include "render/graph/frame.h"
#include "render/passes/frame_state.h"

namespace isolux::render {

// Describes the properties of a stored frame that reading back requires.
struct DrawnFrame {
  glm::ivec2 raySize{0}, pictureSize{0};
  double rayStartMm = 0.0;  // ViewUniforms::rayStartMm
  double startDepth = 0.0;  // ViewUniforms::startDepth
  glm::dvec2 halfExtent{0.0};
  glm::ivec2 wholeSize{0}, tileOrigin{0};  // rays; of the image that the frame is a tile of
  double outward = -1.0;                   // factor of the gradient that gives the outward normal
  scene::Field hitField = scene::Field::trilinear;
  bool layered = false;             // surfaces behind transparent ones were drawn
  double scaleMm = 0.0;             // of second derivatives
  bool lit = false;                 // the light was known
  bool transparentPicture = false;  // picture.transparent
};

ColorImage readColor(const FrameState& frame, const DrawnFrame& drawn);
LinearImage readLinear(const FrameState& frame);
LinearImage readLinearPicture(const FrameState& frame, const DrawnFrame& drawn);
AovImage readAov(const FrameState& frame, const DrawnFrame& drawn, Aov aov);
// Appends the surface points of every n-th ray on both axes, with n such that at most `most` result, spread
// evenly over the image. Only those are read back. The points are of the layer that `frame` draws now.
// Surfaces whose light is not baked (scene/opacity.h) are left out. `outward`: DrawnFrame's.
void appendHits(const FrameState& frame, std::size_t most, double outward, gi::VisiblePointSet& hits);
gi::VisiblePointSet hitVoxels(const FrameState& frame, const DrawnFrame& drawn);

}  // namespace isolux::render
