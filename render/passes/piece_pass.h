// Which connected piece of its isosurface each surface point belongs to (volume/pieces).
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Ids as of volume::Pieces of that isosurface, 0 the largest; -1 where there is no surface. Looked up on the
// processor whoever casts the rays. Floats: ids of 2^24 and more round.
class PiecePass : public Pass {
 public:
  PiecePass() : Pass("piece", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor&) const override { return true; }
};

}  // namespace isolux::render
