// Draws a progress bar with the time left on stderr, if that is a terminal.
#pragma once

#include <string>
#include <thread>

#include "base/progress.h"

namespace isolux::app {

// Returns "[#####     ]  45 %  reading  3 s left". `elapsed` in seconds; the bar has `width` columns.
std::string progressLine(double fraction, const char* stage, double elapsed, int width = 24);

// Draws during its lifetime; its end erases the line. Appears only after a moment: short work prints
// nothing.
class ProgressBar {
 public:
  explicit ProgressBar(const base::Progress& progress);

 private:
  std::jthread thread_;
};

}  // namespace isolux::app
