// Measures the parts of one program's draws on a graphics card, and chooses their size
// (render/gl/draw_parts.h).
//
// Each part is submitted to the card by itself. Its time is read when the card is done with it: at most
// three parts of a program are on their way, so that a stop request waits for no more, and fast cards are not
// kept waiting. Requires GlLimits::timestampBits and the context to be current.
#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "render/gl/draw_parts.h"
#include "render/gl/gl_objects.h"

namespace isolux::render {

class PartTimer {
 public:
  explicit PartTimer(GlPtr gl) : gl_(std::move(gl)) {}

  void beginDraw();
  int beginPart();         // returns the rays that the part should have
  void endPart(int rays);  // those that it had
  void endDraw();

 private:
  using Times = std::pair<Query, Query>;  // begin and end
  struct Pending {
    Times times;
    int rays = 0;
    bool last = false;  // of its draw
  };
  void takeOldest();  // waits for the card unless it is timed

  GlPtr gl_;
  DrawParts parts_;
  std::deque<Pending> pending_;
  std::vector<Times> free_;
};

}  // namespace isolux::render
