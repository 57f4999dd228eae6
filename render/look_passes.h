// From surface points and their derivatives to the picture: shade, layers and resolve (render/passes.h).
#pragma once

#include "render/derivative_passes.h"
#include "render/frame_state.h"
#include "render/hit_passes.h"

namespace isolux::render {

class LookPasses {
 public:
  void shade(FrameState& frame);
  // Crossings behind transparent surfaces, one after another until nothing is seen any more.
  void layers(FrameState& frame, HitPasses& hits, DerivativePasses& derivatives);
  void resolve(FrameState& frame);

 private:
  // Draws the look of the frame's layer into what is bound.
  void drawShading(FrameState& frame);
};

}  // namespace isolux::render
