// Finds lines that follow the surface's curvature, in image space: the passes extrema, line field and lines.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Computes the change of each principal curvature along its own direction: 0 on ridges and valleys.
class ExtremaPass : public Pass {
 public:
  ExtremaPass() : Pass("extrema", "extrema.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Finds the lines near each pixel: ridges and valleys, suggestive contours, outlines.
class LineFieldPass : public Pass {
 public:
  LineFieldPass() : Pass("line field", "line_field.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Computes the coverage of each pixel by lines that are long and strong enough.
class LinesPass : public Pass {
 public:
  LinesPass()
      : Pass("lines", "lines.frag.glsl", {.ofCrossing = true},
             {image::lines, "LINES", {"uLines"}, scene::drawsLines}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Returns how many pixels around one decide which lines it shows.
double reachOfLines(const scene::Scene& scene, int heightInRays);

}  // namespace isolux::render
