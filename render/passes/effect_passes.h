// What light and flow add to surface points, once per pixel: the passes shadow, flow field and flow.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// A second ray from each surface point to the key light.
class ShadowPass : public Pass {
 public:
  ShadowPass() : Pass("shadow", "shadow.frag.glsl", {.castsRays = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

// The direction of the flow on screen, and noise on the surface.
class FlowFieldPass : public Pass {
 public:
  FlowFieldPass() : Pass("flow field", "flow_field.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Streaks along the flow field.
class FlowPass : public Pass {
 public:
  FlowPass() : Pass("flow", "flow.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;
};

}  // namespace isolux::render
