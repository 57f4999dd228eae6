// From linear colour to the picture: the passes background and resolve.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// The picture where no surface is seen, as long as that is the same from all sides.
class BackgroundPass : public Pass {
 public:
  BackgroundPass() : Pass("background", "resolve.frag.glsl", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Background, supersamples averaged, sRGB encoded, legend.
class ResolvePass : public Pass {
 public:
  ResolvePass() : Pass("resolve", "resolve.frag.glsl", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;

 private:
  Program& prepared(FrameState& frame, const std::string& defines) const;
  void drawAll(FrameState& frame, const Target& target, const std::string& defines) const;
  void drawHits(FrameState& frame, Target& target) const;
};

}  // namespace isolux::render
