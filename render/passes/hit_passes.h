// Rays to surface points: the passes blocks, segments, bricks, cast and refine.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// The active blocks of the isovalues, and which of their boxes can hold a surface.
class BlocksPass : public Pass {
 public:
  BlocksPass() : Pass("blocks", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Between which depths the rays of each tile can meet anything, by projecting the active blocks.
class SegmentsPass : public Pass {
 public:
  SegmentsPass() : Pass("segments", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Uploads of the bricks that the rays of the frame before asked for; none in a volume of one texture.
class BricksPass : public Pass {
 public:
  BricksPass() : Pass(pass::bricks, "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// The first crossing of an isovalue on each ray: exact hits are the surface points, sampled ones a bracket
// [t0, t1] yet. In a layer: the crossing behind the one of the layer before; pixels without one are not
// touched.
class CastPass : public Pass {
 public:
  CastPass() : Pass(pass::cast, "cast.frag.glsl", {.castsRays = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor& on) const override { return on.casts; }

 private:
  enum class Rays { all, again, behind };
  Program& program(FrameState& frame, Rays rays) const;
  void castBehind(FrameState& frame) const;
};

// The surface point of a sampled hit: its bracket narrowed on the exact field of hit.field.
class RefinePass : public Pass {
 public:
  RefinePass() : Pass(pass::refine, "refine.frag.glsl", {.atHits = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

bool anyHit(FrameState& frame);  // of the surface points that are there

// What the shaders that cast rays are compiled with; and what trace.glsl and trace_cubic.glsl read: view,
// volume, isovalues, block masks, what is hidden. Texture units 0, 1, 3, 14.
std::string traceDefines(const FrameState& frame);
void setTrace(FrameState& frame, Program& program);

}  // namespace isolux::render
