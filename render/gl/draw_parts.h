// Chooses the sizes of the parts that a draw over many rays is cut into on a graphics card, so that no part
// takes longer than about 10 ms: drivers end programs whose draws take too long, and the desktop waits for
// each of them.
//
// Pure: no clock and no GL. Times are added as they become known.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "volume/cast/picture_area.h"

namespace isolux::render {

// The size of the parts of one program's draws.
//
// The first draw starts small and is measured part by part: a part that takes less than `kShort` doubles the
// next one. Later draws double their parts once for each whole draw in which every part was short. A part
// that took longer than `kLong` halves the next ones until they would take less.
class DrawParts {
 public:
  static constexpr int kFirstRays = 1 << 14, kFewestRays = 1 << 8, kMostRays = 1 << 28;
  static constexpr int kMostOfFirstDraw = 1 << 18;    // rays: what is cheap at first may be background
  static constexpr double kShort = 2.5, kLong = 7.0;  // ms

  int rays() const { return rays_; }  // of the next part, about
  // Returns whether a draw of full parts has been measured. Before, each part's time has to be known before
  // the next part is drawn.
  bool known() const { return known_; }
  // Adds the time of a part.
  void add(int rays, double milliseconds);
  // Ends a draw, all parts of which were added.
  void endDraw();

 private:
  int rays_ = kFirstRays;
  bool known_ = false;
  bool full_ = false, long_ = false;  // this draw had a part of about `rays_` rays; one that was not short
};

// Cuts rectangles into parts of about equally many rays. Each ray is in one part.
class PartCutter {
 public:
  using Rectangles = std::vector<volume::Rectangle>;
  explicit PartCutter(Rectangles rectangles) : rectangles_(std::move(rectangles)) { skipEmpty(); }

  bool done() const { return at_ >= rectangles_.size(); }
  // Returns the next part: at most `rays`, but at least 16 rows of 16. Empty once done.
  Rectangles next(int rays);

 private:
  void skipEmpty();

  Rectangles rectangles_;
  std::size_t at_ = 0;
  int x_ = 0,
      y_ = 0;  // rows of the rectangle before y_ are gone, and of the 16 rows from there columns before x_
};

int raysOf(const PartCutter::Rectangles& part);

}  // namespace isolux::render
