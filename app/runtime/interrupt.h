// Ctrl-C: asks the running job to stop and, if it does not within 40 ms, ends the process tidily.
//
// While an InterruptWatcher lives, SIGINT, SIGTERM and SIGHUP call Progress::requestStop(). A job that
// listens throws Error{interrupted}; one that is deep in a driver or a library is not waited for: unfinished
// files are removed and the process leaves with exit code 130. One watcher at a time. What comes before a
// watcher lives, and what takes longer to leave, is the supervisor's (app/launcher).
#pragma once

#include <atomic>
#include <thread>

#include "base/progress.h"
#include "base/supervision.h"

namespace isolux::app {

class InterruptWatcher {
 public:
  explicit InterruptWatcher(base::Progress& progress);
  ~InterruptWatcher();
  InterruptWatcher(const InterruptWatcher&) = delete;
  InterruptWatcher& operator=(const InterruptWatcher&) = delete;

  // True for the first caller only: whoever gets it prints the one line about how the command ended.
  bool claimReport(bool interrupted) noexcept {
    return !reported_.exchange(true) && (interrupted ? base::claimInterruptReport() : base::claimReport());
  }

 private:
  void watch();

  base::Progress& progress_;
  std::atomic<bool> reported_{false};
  int pipe_[2] = {-1, -1};
  std::thread thread_;
};

}  // namespace isolux::app
