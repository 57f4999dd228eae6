// How the time of a frame divides over its passes.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bench/frame.h"

namespace isolux::bench {

struct PassTimes {
  std::vector<std::pair<std::string, double>> passes;  // those that run, in order, with median milliseconds
  double frame = 0.0;                                  // median milliseconds, wall time
  std::size_t activeBlocks = 0;

  double of(const std::string& pass) const;  // 0 where it does not run
};

// Every pass of every frame, frames in turns, medians over `rounds` after one to warm up.
std::vector<PassTimes> passTimes(const std::vector<Frame>& frames, int rounds);

}  // namespace isolux::bench
