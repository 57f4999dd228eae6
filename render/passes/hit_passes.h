// Finds the surface points of rays: the passes blocks, segments, bricks, cast and refine.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Finds the active blocks of the isovalues, and which of their sub-blocks can contain a surface.
class BlocksPass : public Pass {
 public:
  BlocksPass() : Pass("blocks", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Finds the depths between which the rays of each tile can meet anything, by projecting the active blocks.
class SegmentsPass : public Pass {
 public:
  SegmentsPass() : Pass("segments", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Uploads the bricks that the rays of the previous frame requested; does nothing for a volume in one texture.
class BricksPass : public Pass {
 public:
  BricksPass() : Pass(pass::bricks, "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Finds the first crossing of an isovalue on each ray: exact hits are the surface points, sampled ones still
// a bracket [t0, t1]. In a layer, finds the crossing behind that of the previous layer; pixels without one
// are unchanged.
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

// Refines a sampled hit to a surface point, by narrowing its bracket on the exact field of hit.field.
class RefinePass : public Pass {
 public:
  RefinePass() : Pass(pass::refine, "refine.frag.glsl", {.atHits = true, .ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
};

Target& surfaceTarget(FrameState& frame);  // returns the images of image::surface, to draw into
bool anyHit(FrameState& frame);            // returns whether there is any surface point

// Return the defines for shaders that cast rays, and set the inputs of trace.glsl and trace_cubic.glsl: view,
// volume, isovalues, block masks, hidden components. Texture units 0, 1, 3, 14.
std::string traceDefines(const FrameState& frame);
void setTrace(FrameState& frame, Program& program);

}  // namespace isolux::render
