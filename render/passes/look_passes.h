// From surface points and their derivatives to the picture: ranges, shade, layers and resolve
// (render/graph/pass_declarations.h).
#pragma once

#include "render/passes/derivative_passes.h"
#include "render/passes/effect_passes.h"
#include "render/passes/frame_state.h"
#include "render/passes/hit_passes.h"
#include "render/passes/light_passes.h"
#include "volume/statistics/curvature_statistics.h"

namespace isolux::render {

class LookPasses {
 public:
  void ranges(FrameState& frame);
  void shade(FrameState& frame);
  // Crossings behind transparent surfaces, one after another until nothing is seen any more.
  void layers(FrameState& frame, HitPasses& hits, DerivativePasses& derivatives, EffectPasses& effects,
              LightPasses& light);
  void resolve(FrameState& frame, LightPasses& light);

 private:
  void drawResolved(FrameState& frame, LightPasses& light, const Target& target, const std::string& defines);
  // Draws the look of the frame's layer into what is bound.
  void drawShading(FrameState& frame);
  void setSurfaces(FrameState& frame, Program& program) const;
  void setLight(FrameState& frame, Program& program) const;
  void setMeasure(FrameState& frame, Program& program);
  void setLines(FrameState& frame, Program& program) const;
  void setOverlays(FrameState& frame, Program& program) const;

  volume::CurvatureStatistics statistics_;
  // The colour map's samples, and what they were made from.
  Texture colors_;
  scene::Look colorsOf_;
};

}  // namespace isolux::render
