// Rays in bricks: cast, upload what they wait for, and cast those that waited again.
//
// A pixel keeps the hit it has found, so bricks that only such pixels needed may be replaced: what is drawn
// at the hits is drawn before. Where the bricks of all waiting rays together do not fit, parts of the picture
// are cast one after the other: a picture is complete if the bricks of a few neighbouring rays fit.
#pragma once

#include <functional>

#include "render/passes/frame_state.h"

namespace isolux::render {

class BrickRounds {
 public:
  // Of a pass that casts rays. drawAtHits draws what needs the bricks at the hits found so far, and keeps
  // what it drew before.
  BrickRounds(FrameState& frame, Pass& pass, std::function<void()> drawAtHits);

  // Rays that have not arrived.
  struct Unfinished {
    std::size_t waiting = 0;  // with FrameRequest::brickUploadBytes for bricks that were not resident,
                              // otherwise for bricks that do not fit
    std::size_t lost = 0;     // they ended at a brick that cannot be read
  };
  // The cast pass.
  Unfinished cast();
  // Another pass that casts rays: drawn again while it gets bricks it asked for.
  Unfinished draw();

 private:
  Unfinished ofLastRound() const;
  void castRound(const volume::Rectangle& area, bool again);
  Unfinished settle(const volume::Rectangle& area);

  FrameState& frame_;
  Pass& pass_;
  Bricks& bricks_;
  std::function<void()> drawAtHits_;
  bool complete_;    // a picture of which nothing may be missing
  int largestArea_;  // rays per axis that are cast together
};

}  // namespace isolux::render
