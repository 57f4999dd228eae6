// Casts rays through bricks in rounds: cast, upload the bricks that rays wait for, and cast the waiting rays
// again.
//
// A pixel keeps its hit, so bricks that only such pixels need may be evicted. Before an eviction, the passes
// at the hits are drawn. If the bricks of all waiting rays do not fit together, parts of the image are cast
// one after the other. An image is complete if the bricks of a few neighbouring rays fit.
#pragma once

#include <functional>

#include "render/passes/frame_state.h"

namespace isolux::render {

class BrickRounds {
 public:
  // Takes a pass that casts rays. `drawAtHits` runs the passes that need the bricks at the hits found so far;
  // it does not change pixels drawn before.
  BrickRounds(FrameState& frame, const Pass& pass, std::function<void()> drawAtHits);

  // Rays without a result.
  struct Unfinished {
    std::size_t waiting = 0;  // with FrameRequest::brickUploadBytes for bricks that were not resident,
                              // otherwise for bricks that do not fit
    std::size_t lost = 0;     // they ended at an unreadable brick
  };
  // Runs the cast pass.
  Unfinished cast();
  // Runs another pass that casts rays: repeats it while requested bricks are uploaded.
  Unfinished draw();

 private:
  Unfinished ofLastRound() const;
  void castRound(const volume::Rectangle& area, bool again);
  Unfinished settle(const volume::Rectangle& area);

  FrameState& frame_;
  const Pass& pass_;
  Bricks& bricks_;
  std::function<void()> drawAtHits_;
  bool complete_;    // the image may not miss any part
  int largestArea_;  // rays per axis that are cast together
};

}  // namespace isolux::render
