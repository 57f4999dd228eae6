// Images from the GPU as plain values: pictures, deferred images, and the point under a pixel.
#pragma once

#include <optional>

#include "render/graph/frame.h"
#include "render/passes/frame_state.h"

namespace isolux::render {

// What reading back needs to know of the frame whose images are held.
struct DrawnFrame {
  glm::ivec2 raySize{0}, pictureSize{0};
  double rayStartMm = 0.0;  // ViewUniforms::rayStartMm
  double startDepth = 0.0;  // ViewUniforms::startDepth
  glm::dvec2 halfExtent{0.0};
  glm::ivec2 wholeSize{0}, tileOrigin{0};  // rays: of the picture that the frame is a tile of
  double outward = -1.0;                   // times the gradient: the outward normal
  scene::Field hitField = scene::Field::trilinear;
  bool layered = false;             // there are surfaces behind transparent ones
  double scaleMm = 0.0;             // of second derivatives
  bool lit = false;                 // somebody had said what the light is
  bool transparentPicture = false;  // picture.transparent
};

ColorImage readColor(const FrameState& frame, const DrawnFrame& drawn);
LinearImage readLinear(const FrameState& frame);
LinearImage readLinearPicture(const FrameState& frame, const DrawnFrame& drawn);
AovImage readAov(const FrameState& frame, const DrawnFrame& drawn, Aov aov);
// The surface points of every n-th ray on both axes, with n so that there are at most `most`: spread evenly
// over the picture. Only those are read back. Of the layer that `frame` draws now; `outward`: DrawnFrame's;
// `everyRay`: all of them.
void appendHits(const FrameState& frame, std::size_t most, double outward, gi::SeenPoints& hits,
                bool everyRay = false);
gi::SeenPoints hitVoxels(const FrameState& frame, const DrawnFrame& drawn, bool everyRay);

}  // namespace isolux::render
