// Rays to surface points: blocks, segments, cast and refine (render/graph/pass_declarations.h).
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

class HitPasses {
 public:
  explicit HitPasses(const GlPtr& gl);

  void blocks(FrameState& frame);
  void segments(FrameState& frame);
  // behind: the crossing behind the one in the surface image of layer `front`; the pixels without one are not
  // touched. False when no pixel has one.
  // again: only the rays that waited for a brick.
  void cast(FrameState& frame, bool again = false);
  bool castBehind(FrameState& frame, const std::string& front);
  void refine(FrameState& frame);
  bool anyHit(FrameState& frame);  // of the surface points that are there

  // Sets what trace.glsl and trace_cubic.glsl read: view, volume, isovalues, block masks. Texture units 0,
  // 1, 3.
  static void setTrace(FrameState& frame, Program& program);

 private:
  enum class Rays { all, again, behind };
  Program& castProgram(FrameState& frame, Rays rays);
  const Target& castTarget(FrameState& frame) const;
  void clearHits(const FrameState& frame, const Target& target) const;

  VertexArray faceArray_;
  Program segmentsProgram_;
  Query anyHit_;
};

}  // namespace isolux::render
