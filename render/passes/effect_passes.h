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

// How much of the directions around a surface point is free of what stands near it, from the picture's own
// points [Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion"]. Of the
// picture's cells, some rays each: along one line in the picture, which changes from cell to cell; and then
// the mean over neighbours.
class OpennessPass : public Pass {
 public:
  OpennessPass() : Pass("openness", "openness.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// A tile sees only a part of what stands near: it takes its part of the small picture drawn before the tiles.
class OcclusionPass : public Pass {
 public:
  OcclusionPass() : Pass("occlusion", "occlusion.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;

 private:
  static std::string keptName(int crossing);
  void takeKept(FrameState& frame);

  int crossing_ = 0;
};

// Rays per axis of a cell; 1 in the small picture before tiles.
int occlusionCell(const FrameRequest& request);
// The picture's size in cells.
glm::ivec2 occlusionCells(const FrameRequest& request);

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
