#include "scene/rules/flow_clock.h"

#include <cassert>
#include <cmath>

#include "scene/rules/relevance.h"

namespace isolux::scene {

namespace {
constexpr double endOfTime = 1e6;  // seconds: the largest flow.time
}

void FlowClock::setScene(const Scene& scene) {
  runs_ = scene.flow.animate && showsFlow(scene);
  if (!runs_ || scene.flow.time != base_) elapsed_ = 0.0;
  base_ = scene.flow.time;
}

void FlowClock::advance(double seconds) {
  assert(seconds >= 0.0);
  if (runs_) elapsed_ += seconds;
}

double FlowClock::seconds() const {
  return elapsed_ > 0.0 ? std::fmod(base_ + elapsed_, endOfTime) : base_;
}

}  // namespace isolux::scene
