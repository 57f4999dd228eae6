// Shares the progress of a long job, and requests to stop it, between the job and its owner.
//
// The job reports progress and polls for a stop request; the owner polls progress. It uses no callbacks, so
// no code runs on a foreign thread. All members are safe from any thread.
#pragma once

#include <atomic>
#include <stop_token>

#include "base/error.h"

namespace isolux::base {

class Progress {
 public:
  // Reports `fraction` in [0, 1]. Requires that `stage` is a string literal ("reading", "building blocks").
  void report(double fraction, const char* stage) noexcept {
    fraction_.store(fraction, std::memory_order_relaxed);
    stage_.store(stage, std::memory_order_relaxed);
  }
  double fraction() const noexcept { return fraction_.load(std::memory_order_relaxed); }
  const char* stage() const noexcept { return stage_.load(std::memory_order_relaxed); }

  void requestStop() noexcept { source_.request_stop(); }
  bool stopRequested() const noexcept { return source_.stop_requested(); }
  std::stop_token token() const noexcept { return source_.get_token(); }

  // Throws Error{interrupted} after a stop request. Jobs call this at least every 50 ms.
  void throwIfStopped() const {
    if (stopRequested()) throw Error(ErrorKind::interrupted, "", "", "stopped");
  }

 private:
  std::atomic<double> fraction_{0.0};
  std::atomic<const char*> stage_{""};
  std::stop_source source_;
};

// The range of a job's progress that one of its loops covers. `stage` must be a string literal; if null, the
// loop reports nothing.
struct ProgressRange {
  double from = 0.0, to = 1.0;
  const char* stage = nullptr;
};

}  // namespace isolux::base
