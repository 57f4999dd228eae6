#include "tests/support/stop_latency.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/quantiles.h"

namespace isolux::test {

namespace {

using Clock = std::chrono::steady_clock;

double processSeconds() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// From the request to the end of the work; nothing if it ended before.
struct AfterStop {
  double processor = 0.0, clock = 0.0;  // seconds
};

AfterStop afterStop(const std::function<void(base::Progress&)>& work, double afterProcessorSeconds) {
  base::Progress progress;
  std::atomic<bool> ended{false};
  double asked = 0.0;
  Clock::time_point askedAt;
  const double due = processSeconds() + afterProcessorSeconds;
  std::thread other([&] {
    while (!ended && processSeconds() < due) std::this_thread::sleep_for(std::chrono::microseconds(200));
    progress.requestStop();
    asked = processSeconds();  // not before: this thread may be put aside between the two
    askedAt = Clock::now();
  });
  try {
    work(progress);
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::interrupted) << error.what();
  }
  const double end = processSeconds();
  const Clock::time_point endedAt = Clock::now();
  ended = true;
  other.join();
  return {std::max(end - asked, 0.0),
          std::max(std::chrono::duration<double>(endedAt - askedAt).count(), 0.0)};
}

}  // namespace

void expectStopsSoon(const std::function<void(base::Progress&)>& work, int moments) {
  const double whole = processorSeconds([&] {
    base::Progress undisturbed;
    work(undisturbed);
  });
  std::vector<double> processor, clock;
  for (int i = 0; i < moments; ++i) {
    const AfterStop after = afterStop(work, whole * (i + 0.5) / moments);
    processor.push_back(after.processor);
    clock.push_back(after.clock);
  }
  const double cores = std::max(std::thread::hardware_concurrency(), 1u);
  std::printf(
      "of %.2f s of the processors %.3f s after a stop in the median; %.1f ms by the clock, %.1f ms at "
      "worst\n",
      whole, base::median(processor), 1e3 * base::median(clock),
      1e3 * *std::max_element(clock.begin(), clock.end()));
  EXPECT_LE(base::median(processor), std::max(0.25 * whole, 0.01 * cores)) << "of " << whole;
}

double processorSeconds(const std::function<void()>& work) {
  const double start = processSeconds();
  work();
  return processSeconds() - start;
}

}  // namespace isolux::test
