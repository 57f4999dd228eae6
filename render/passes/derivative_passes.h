// Surface points to derivatives and curvature, once per pixel: gradient, hessian and curvature
// (render/graph/pass_declarations.h).
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

class DerivativePasses {
 public:
  void gradient(FrameState& frame) { derivatives(frame, false); }
  void hessian(FrameState& frame) { derivatives(frame, true); }  // gradients too, from the same samples
  void curvature(FrameState& frame);

 private:
  void derivatives(FrameState& frame, bool hessian);
};

}  // namespace isolux::render
