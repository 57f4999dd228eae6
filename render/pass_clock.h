// Measures how long the passes of a frame take.
#pragma once

#include <chrono>
#include <utility>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/graph/frame.h"

namespace isolux::render {

// Times the passes of a frame: GPU timestamps, read when the frame is done; on a software rasteriser, whose
// own time is wall time, a clock around a finished pass.
class PassClock {
 public:
  explicit PassClock(GlPtr gl) : gl_(std::move(gl)) {}

  void begin() {
    begin_ = Clock::now();
    if (!gl_->software)
      gl_->QueryCounter(timers_.emplace_back(Query(gl_), Query(gl_)).first.id(), GL_TIMESTAMP);
  }
  void end(std::size_t reportIndex) {
    timed_.push_back(reportIndex);
    if (gl_->software)
      gl_->Finish();
    else
      gl_->QueryCounter(timers_.back().second.id(), GL_TIMESTAMP);
    wall_.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin_).count());
  }
  void write(std::vector<PassReport>& passes) const {
    for (std::size_t i = 0; i < timed_.size(); ++i) {
      double& milliseconds = passes[timed_[i]].milliseconds;
      if (gl_->software) {
        milliseconds += wall_[i];
        continue;
      }
      GLuint64 from = 0, to = 0;
      gl_->GetQueryObjectui64v(timers_[i].first.id(), GL_QUERY_RESULT, &from);
      gl_->GetQueryObjectui64v(timers_[i].second.id(), GL_QUERY_RESULT, &to);
      milliseconds += static_cast<double>(to - from) * 1e-6;
    }
  }

 private:
  using Clock = std::chrono::steady_clock;

  GlPtr gl_;
  Clock::time_point begin_;
  std::vector<std::pair<Query, Query>> timers_;
  std::vector<std::size_t> timed_;
  std::vector<double> wall_;
};

}  // namespace isolux::render
