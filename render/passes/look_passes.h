// From surface points and their derivatives to linear colour: the passes ranges, shade and layers.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// The surface's curvature as a whole, from the volume: numbers that are automatic. Knows no view.
class RangesPass : public Pass {
 public:
  RangesPass() : Pass("ranges", "", {}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;
};

// The look, linear colour, of the first crossing; of a layer, blended behind what is there.
class ShadePass : public Pass {
 public:
  ShadePass() : Pass("shade", "shade.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  void forget() override {
    colors_ = Texture();
    secondColors_ = Texture();
  }

 private:
  Program& prepared(FrameState& frame);  // its program, with all that it reads
  void setSurfaces(FrameState& frame, Program& program) const;
  void setLight(FrameState& frame, Program& program) const;
  void setMeasure(FrameState& frame, Program& program);
  void setSecond(FrameState& frame, Program& program, int unit);
  void setOverlays(FrameState& frame, Program& program) const;

  // The colour map's samples, and what they were made from.
  Texture colors_;
  scene::Look colorsOf_;
  Texture secondColors_;  // of the second volume
  scene::ColorMap secondColorsOf_ = scene::ColorMap::automatic;
};

// Crossings behind transparent surfaces, one after another until nothing is seen any more: for each, all
// passes of a crossing are drawn again, from cast to shade.
class LayersPass : public Pass {
 public:
  LayersPass() : Pass(pass::layers, "", {.castsRays = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

}  // namespace isolux::render
