// Loops over voxels: every step runs once, and after a stop each core ends the step that it is at.
#include "volume/parallel/parallel_steps.h"

#include <mutex>
#include <set>
#include <thread>

#include <gtest/gtest.h>

namespace isolux::volume {
namespace {

TEST(ParallelSteps, EachRunsOnceAndTheLastTellsTheEndOfItsShare) {
  base::Progress progress;
  std::vector<std::atomic<int>> runs(1000);
  parallelSteps(runs.size(), progress, {0.25, 0.75, "counting"}, [&](std::size_t i) { ++runs[i]; });
  EXPECT_TRUE(std::all_of(runs.begin(), runs.end(), [](const auto& count) { return count == 1; }));
  EXPECT_GT(progress.fraction(), 0.25);
  EXPECT_LE(progress.fraction(), 0.75);
  EXPECT_STREQ(progress.stage(), "counting");
}

TEST(ParallelSteps, PiecesCoverWhatTheyAreCutFrom) {
  for (const std::size_t count : {0u, 1u, 9u, 10u, 11u, 100u}) {
    base::Progress progress;
    std::vector<std::atomic<int>> covered(count);
    parallelPieces(count, 10, progress, {}, [&](std::size_t begin, std::size_t end) {
      EXPECT_LE(end - begin, 10u);
      for (std::size_t i = begin; i < end; ++i) ++covered[i];
    });
    EXPECT_TRUE(std::all_of(covered.begin(), covered.end(), [](const auto& times) { return times == 1; }));
  }
}

TEST(ParallelSteps, AfterAStopNoThreadBeginsMoreThanTheStepItWasAbout) {
  base::Progress progress;
  std::atomic<int> steps{0}, late{0};
  std::mutex lock;
  std::set<std::thread::id> threads;
  const auto run = [&] {
    parallelSteps(100000, progress, {}, [&](std::size_t) {
      late += progress.stopRequested();
      const std::lock_guard guard(lock);
      threads.insert(std::this_thread::get_id());
      if (++steps == 100) progress.requestStop();
    });
  };
  try {
    run();
    ADD_FAILURE() << "not stopped";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
  }
  EXPECT_LE(late, static_cast<int>(threads.size()));
  EXPECT_LE(steps, 100 + static_cast<int>(threads.size()));
}

TEST(ParallelSteps, MemoryIsNotHandedOutAfterAStop) {
  base::Progress progress;
  std::vector<float> values;
  resizeStoppably(values, 3 << 20, progress);
  EXPECT_EQ(values.size(), std::size_t{3} << 20);
  progress.requestStop();
  EXPECT_THROW(resizeStoppably(values, 30 << 20, progress), base::Error);
  EXPECT_EQ(values.size(), std::size_t{3} << 20);
}

}  // namespace
}  // namespace isolux::volume
