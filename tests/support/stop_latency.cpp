#include "tests/support/stop_latency.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/quantiles.h"

namespace isolux::test {

namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

// From the request to the end of the work.
double latencyOf(const std::function<void(base::Progress&)>& work, double afterSeconds) {
  base::Progress progress;
  Clock::time_point asked;
  std::thread other([&] {
    std::this_thread::sleep_for(Seconds(afterSeconds));
    asked = Clock::now();
    progress.requestStop();
  });
  Clock::time_point ended;
  try {
    work(progress);
    ended = Clock::now();
  } catch (const base::Error& error) {
    ended = Clock::now();
    EXPECT_EQ(error.kind(), base::ErrorKind::interrupted) << error.what();
  }
  other.join();
  return Seconds(ended - asked).count();
}

}  // namespace

void expectStopsSoon(const std::function<void(base::Progress&)>& work, int moments) {
  base::Progress undisturbed;
  const Clock::time_point start = Clock::now();
  work(undisturbed);
  const double whole = Seconds(Clock::now() - start).count();
  std::vector<double> latencies;
  for (int i = 0; i < moments; ++i) latencies.push_back(latencyOf(work, whole * (i + 0.5) / moments));
  const double median = base::median(latencies);
  testing::Test::RecordProperty("whole", std::to_string(whole));
  testing::Test::RecordProperty("median", std::to_string(median));
  testing::Test::RecordProperty("worst",
                                std::to_string(*std::max_element(latencies.begin(), latencies.end())));
  EXPECT_LT(median, 0.1) << "of " << whole << " s in all";
}

double processorSeconds(const std::function<void()>& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace isolux::test
