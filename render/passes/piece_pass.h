// Determines the connected component of its isosurface that each surface point belongs to (volume/pieces).
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Writes ids as of volume::Pieces of that isosurface, 0 the largest; -1 if there is no surface. Always runs
// on the CPU. Ids are floats: those of 2^24 and more are rounded.
class PiecePass : public Pass {
 public:
  PiecePass() : Pass("piece", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor&) const override { return true; }
};

}  // namespace isolux::render
