// Computes the final image from linear colour: the passes background and resolve.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Draws the pixels without a surface, if they do not depend on the view.
class BackgroundPass : public Pass {
 public:
  BackgroundPass() : Pass("background", "resolve.frag.glsl", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Adds the background, averages supersamples, encodes sRGB and adds the legend.
class ResolvePass : public Pass {
 public:
  ResolvePass() : Pass(pass::resolve, "resolve.frag.glsl", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;

 private:
  Program& prepared(FrameState& frame, const std::string& defines) const;
  void drawAll(FrameState& frame, const Target& target, const std::string& defines) const;
  void drawHits(FrameState& frame, Target& target) const;
};

}  // namespace isolux::render
