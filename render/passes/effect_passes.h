// What light and flow add to surface points, once per pixel: shadow, flow field and flow
// (render/graph/pass_declarations.h).
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

class EffectPasses {
 public:
  void shadow(FrameState& frame);
  void flowField(FrameState& frame);
  void flow(FrameState& frame);
};

}  // namespace isolux::render
