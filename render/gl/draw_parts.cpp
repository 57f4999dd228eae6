#include "render/gl/draw_parts.h"

#include <algorithm>

namespace isolux::render {

namespace {
// Rows and columns of the smallest part: multiples of what cards shade together.
constexpr int kBlock = 16;

int blocksOf(int length) {
  return std::max(length / kBlock, 1) * kBlock;
}
}  // namespace

void DrawParts::add(int rays, double milliseconds) {
  const bool full = rays >= rays_ / 2;  // parts end at rectangles and at blocks
  full_ = full_ || full;
  long_ = long_ || !(milliseconds < kShort);
  if (milliseconds > kLong) {
    // As if the part had had the size of now: its time may come late.
    double expected = milliseconds / std::max(rays, 1) * rays_;
    while (expected > kLong && rays_ > kFewestRays) {
      rays_ /= 2;
      expected /= 2.0;
    }
  } else if (!known_ && !long_ && full && rays_ < kMostOfFirstDraw) {
    rays_ *= 2;
  }
}

void DrawParts::endDraw() {
  if (known_ && full_ && !long_ && rays_ < kMostRays) rays_ *= 2;
  known_ = known_ || full_;
  full_ = long_ = false;
}

void PartCutter::skipEmpty() {
  while (!done() && (rectangles_[at_].size.x <= 0 || rectangles_[at_].size.y <= 0)) ++at_;
}

PartCutter::Rectangles PartCutter::next(int rays) {
  Rectangles part;
  int left = rays;
  const auto take = [&](const volume::Rectangle& piece) {
    part.push_back(piece);
    left -= piece.size.x * piece.size.y;
  };
  while (!done() && (part.empty() || left > 0)) {
    const volume::Rectangle& of = rectangles_[at_];
    const int rows = std::min(kBlock, of.size.y - y_);
    if (x_ == 0 && left >= of.size.x * rows) {
      const int height = std::min(blocksOf(left / of.size.x), of.size.y - y_);
      take({of.low + glm::ivec2(0, y_), {of.size.x, height}});
      y_ += height;
    } else {
      const int width = std::min(blocksOf(left / rows), of.size.x - x_);
      if (!part.empty() && width * rows > left) break;
      take({of.low + glm::ivec2(x_, y_), {width, rows}});
      x_ += width;
      if (x_ == of.size.x) {
        x_ = 0;
        y_ += rows;
      }
    }
    if (y_ < of.size.y) continue;
    ++at_;
    x_ = y_ = 0;
    skipEmpty();
  }
  return part;
}

int raysOf(const PartCutter::Rectangles& part) {
  int rays = 0;
  for (const volume::Rectangle& one : part) rays += one.size.x * one.size.y;
  return rays;
}

}  // namespace isolux::render
