// What a background bake promises a window beside other processes: it ends soon, and nobody waits for it.
#include <algorithm>
#include <chrono>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <cstdio>
#include <ctime>

#include "base/quantiles.h"
#include "gi/bake/light_bake.h"
#include "tests/gi/bake/formula_estimator.h"
#include "tests/support/busy_processes.h"

namespace isolux::gi {
namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::duration<double, std::milli>;

// Light whose paths take processor time, as those of the tracer do, and that looks at the stop as it does.
class WorkingEstimator : public FormulaEstimator {
 public:
  bool add(std::span<const glm::ivec3> texels, std::span<const TexelPoint> points, SampleRange range,
           std::span<double> sums, std::uint64_t& rays, const std::stop_token& stop) const override {
    const std::size_t wanted = texels.size() * range.count;
    for (std::size_t done = 0; done < wanted; done += kPathsOfMillisecond) {
      if (stop.stop_requested()) return false;
      work(std::min(1.0, static_cast<double>(wanted - done) / kPathsOfMillisecond));
    }
    return FormulaEstimator::add(texels, points, range, sums, rays, stop);
  }

 private:
  static constexpr std::size_t kPathsOfMillisecond = 2048;
  static double processorMilliseconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }
  static void work(double milliseconds) {
    for (const double end = processorMilliseconds() + milliseconds; processorMilliseconds() < end;) {
    }
  }
};

double percentile(std::vector<double> values, double part) {
  return base::lowerQuantile(values, part);
}

TEST(LightBakeBesideBusyProcesses, EndsWithin100MillisecondsAndNeverHoldsItsOwnerUp) {
  const test::BusyProcesses busy;
  const LatticeGeometry geometry = LatticeGeometry::make({64, 64, 64}, 1.0);
  const auto everything = texelsWhere(geometry, [](glm::ivec3) { return true; });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> moment(0.0, 40.0);
  std::vector<double> endings, calls;
  for (int i = 0; i < 100; ++i) {
    const auto estimator = std::make_shared<WorkingEstimator>();
    const auto lattice = std::make_shared<LightLattice>(geometry, estimator->content(), "key");
    auto bake = std::make_unique<LightBake>(
        lattice, estimator,
        LightBake::Options{.samples = 4096, .threads = std::max(busy.count(), 1), .background = true});
    bake->want(Wish::rest, everything);
    const Clock::time_point until =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(Milliseconds(moment(random)));
    while (Clock::now() < until) {  // as a window that draws
      const Clock::time_point before = Clock::now();
      bake->yield(i % 2 == 0);
      bake->want(Wish::visible, {everything[static_cast<std::size_t>(i)]});
      static_cast<void>(bake->counters());
      bake->yield(false);
      calls.push_back(Milliseconds(Clock::now() - before).count());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    const Clock::time_point before = Clock::now();
    bake.reset();
    endings.push_back(Milliseconds(Clock::now() - before).count());
  }
  RecordProperty("ending_median_ms", std::to_string(percentile(endings, 0.5)));
  RecordProperty("ending_p95_ms", std::to_string(percentile(endings, 0.95)));
  std::printf(
      "ending: median %.1f ms, 95th percentile %.1f ms, longest %.1f ms; owner's calls: median %.3f ms, "
      "95th percentile %.3f ms, longest %.1f ms\n",
      percentile(endings, 0.5), percentile(endings, 0.95), percentile(endings, 1.0), percentile(calls, 0.5),
      percentile(calls, 0.95), percentile(calls, 1.0));
  EXPECT_LE(percentile(endings, 0.95), 100.0);
  // The owner is put aside itself for a turn of its neighbour now and then.
  EXPECT_LE(percentile(calls, 0.95), 20.0);
}

}  // namespace
}  // namespace isolux::gi
