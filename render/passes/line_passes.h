// Lines that follow the surface's curvature, found in the picture: the passes extrema, line field and lines.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// How each principal curvature changes along its own direction: 0 on ridges and valleys.
class ExtremaPass : public Pass {
 public:
  ExtremaPass() : Pass("extrema", "extrema.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Near which lines a pixel is: ridges and valleys, suggestive contours, outlines.
class LineFieldPass : public Pass {
 public:
  LineFieldPass() : Pass("line field", "line_field.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// How much of a pixel they cover: those that are long and strong enough.
class LinesPass : public Pass {
 public:
  LinesPass() : Pass("lines", "lines.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;
};

// Pixels around one that decide what is drawn of its lines.
double reachOfLines(const scene::Scene& scene, int heightInRays);

}  // namespace isolux::render
