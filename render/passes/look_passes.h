// Computes linear colour from surface points and their derivatives: the passes ranges, shade and layers.
#pragma once

#include "render/passes/frame_state.h"
#include "render/passes/gloss_passes.h"

namespace isolux::render {

// Computes automatic numbers from the curvature of the volume's whole surface; independent of the view.
class RangesPass : public Pass {
 public:
  RangesPass();
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

// Shades the first crossing in linear colour; a layer is blended behind the colour drawn so far.
class ShadePass : public Pass {
 public:
  ShadePass() : Pass(pass::shade, "shade.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  void forget() override {
    colors_ = Texture();
    secondColors_ = Texture();
    crevices_ = Texture();
    gloss_.forget();
  }

 private:
  void drawBand(FrameState& frame);
  Program& prepared(FrameState& frame);  // returns its program with all its inputs set
  void setSurfaces(FrameState& frame, Program& program) const;
  void setLight(FrameState& frame, Program& program) const;
  void setMeasure(FrameState& frame, Program& program);
  void setSecond(FrameState& frame, Program& program, int unit);
  void setCrevices(const FrameState& frame, Program& program, int unit);
  void setOverlays(FrameState& frame, Program& program) const;

  // The colour map's samples, and the look they were made from.
  Texture colors_;
  scene::Look colorsOf_;
  Texture secondColors_;  // of the second volume
  scene::ColorMap secondColorsOf_ = scene::ColorMap::automatic;
  GlossUniforms gloss_;
  Texture crevices_;  // of look.accessibility_points
  std::optional<std::vector<scene::ColorPoint>> crevicesOf_;
};

// Draws crossings behind transparent surfaces, one after another until none is visible. For each crossing,
// runs all passes from cast to shade again.
class LayersPass : public Pass {
 public:
  LayersPass() : Pass(pass::layers, "", {.castsRays = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

}  // namespace isolux::render
