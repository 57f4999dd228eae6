#include "gi/bake/bake_rate.h"

namespace isolux::gi {

void BakeRate::note(double seconds, std::uint64_t rays, std::uint64_t paths) {
  last_ = {seconds, rays, paths};
  if (seconds < marks_.back().seconds + kStep) return;
  marks_.push_back(last_);
  while (marks_.size() > 2 && marks_[1].seconds <= seconds - kWindow) marks_.pop_front();
}

}  // namespace isolux::gi
