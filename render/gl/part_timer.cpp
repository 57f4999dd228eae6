#include "render/gl/part_timer.h"

namespace isolux::render {

namespace {
constexpr std::size_t kMostPending = 3;
}

bool PartTimer::isTimed(const Pending& pending) const {
  GLuint64 available = 0;
  gl_->GetQueryObjectui64v(pending.times.second.id(), GL_QUERY_RESULT_AVAILABLE, &available);
  return available != 0;
}

void PartTimer::takeOldest() {
  Pending oldest = std::move(pending_.front());
  pending_.pop_front();
  GLuint64 from = 0, to = 0;
  gl_->GetQueryObjectui64v(oldest.times.first.id(), GL_QUERY_RESULT, &from);
  gl_->GetQueryObjectui64v(oldest.times.second.id(), GL_QUERY_RESULT, &to);
  parts_.add(oldest.rays, to > from ? static_cast<double>(to - from) * 1e-6 : 0.0);
  if (oldest.last) parts_.endDraw();
  free_.push_back(std::move(oldest.times));
}

void PartTimer::beginDraw() {
  while (!pending_.empty() && isTimed(pending_.front())) takeOldest();
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
