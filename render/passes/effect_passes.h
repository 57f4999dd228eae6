// Computes shadow, occlusion and flow at surface points, once per pixel: the passes shadow, openness,
// occlusion, flow field and flow.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Casts a second ray from each surface point towards the key light.
class ShadowPass : public Pass {
 public:
  ShadowPass()
      : Pass("shadow", "shadow.frag.glsl", {.castsRays = true, .ofCrossing = true},
             {image::shadow, "SHADOW", {"uLit"}, scene::showsShadow}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.all; }
};

// Computes the fraction of directions around a surface point that nearby geometry leaves open, from the
// image's own points [Jimenez et al. 2016, "Practical Real-Time Strategies for Accurate Indirect Occlusion"].
// Works on cells of some rays each, along one line in the image, which changes from cell to cell, and
// averages over neighbours.
class OpennessPass : public Pass {
 public:
  OpennessPass() : Pass("openness", "openness.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Turns openness into occlusion. A tile contains only a part of the nearby geometry. It therefore uses its
// part of the small image drawn before the tiles.
class OcclusionPass : public Pass {
 public:
  OcclusionPass()
      : Pass("occlusion", "occlusion.frag.glsl", {.ofCrossing = true},
             {image::occlusion, "OCCLUSION", {"uOpen"}, scene::showsOcclusion}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;

 private:
  static std::string keptName(int crossing);
  void takeKept(FrameState& frame);

  int crossing_ = 0;
};

// Returns the rays per axis of a cell; 1 in the small image before tiles.
int occlusionCell(const FrameRequest& request);
// Returns the image's size in cells.
glm::ivec2 occlusionCells(const FrameRequest& request);

// Computes the direction of the flow on the screen, and noise on the surface.
class FlowFieldPass : public Pass {
 public:
  FlowFieldPass() : Pass("flow field", "flow_field.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Draws streaks along the flow field.
class FlowPass : public Pass {
 public:
  FlowPass()
      : Pass("flow", "flow.frag.glsl", {.ofCrossing = true},
             {image::flow, "FLOW", {"uFlow"}, scene::showsFlow}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

}  // namespace isolux::render
