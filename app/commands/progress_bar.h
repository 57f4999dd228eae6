// A progress bar with the time left on stderr, when that is a terminal; nothing otherwise.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "base/progress.h"

namespace isolux::app {

// "[#####     ]  45 %  reading  3 s left". `elapsed` in seconds; the bar has `width` columns.
std::string progressLine(double fraction, const char* stage, double elapsed, int width = 24);

// Draws while it lives; the destructor wipes the line. Appears only after a moment: short work stays silent.
class ProgressBar {
 public:
  explicit ProgressBar(const base::Progress& progress);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

 private:
  void draw(const base::Progress& progress);

  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace isolux::app
