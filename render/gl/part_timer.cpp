#include "render/gl/part_timer.h"

namespace isolux::render {

namespace {
constexpr std::size_t kMostPending = 3;
}

void PartTimer::takeOldest() {
  Pending oldest = std::move(pending_.front());
  pending_.pop_front();
  parts_.add(oldest.rays, millisecondsBetween(oldest.times.first, oldest.times.second));
  if (oldest.last) parts_.endDraw();
  free_.push_back(std::move(oldest.times));
}

void PartTimer::beginDraw() {
  while (!pending_.empty() && pending_.front().times.second.result(GL_QUERY_RESULT_AVAILABLE) != 0)
    takeOldest();
}

int PartTimer::beginPart() {
  while (pending_.size() >= (parts_.known() ? kMostPending : 1)) takeOldest();
  Pending& part = pending_.emplace_back();
  if (free_.empty()) {
    part.times = {Query(gl_), Query(gl_)};
  } else {
    part.times = std::move(free_.back());
    free_.pop_back();
  }
  gl_->QueryCounter(part.times.first.id(), GL_TIMESTAMP);
  return parts_.rays();
}

void PartTimer::endPart(int rays) {
  Pending& part = pending_.back();
  gl_->QueryCounter(part.times.second.id(), GL_TIMESTAMP);
  gl_->Flush();
  part.rays = rays;
}

void PartTimer::endDraw() {
  if (!pending_.empty()) pending_.back().last = true;
}

}  // namespace isolux::render
