// What a background bake is to the window that owns it: its threads stand behind all others, and its owner
// never waits for one of them, also when the system has put that aside. How soon it ends is measured by
// `./dev interrupts`.
#include <algorithm>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include "gi/bake/light_bake.h"
#include "tests/gi/bake/formula_estimator.h"
#include "tests/support/own_waits.h"

namespace isolux::gi {
namespace {

// Niceness and scheduler of the calling thread.
std::pair<int, int> standing() {
  return {::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid())), ::sched_getscheduler(0)};
}

TEST(LightBakeOfAWindow, ItsThreadsStandBehindAllOthers) {
  const LatticeGeometry geometry = LatticeGeometry::make({16, 16, 16}, 1.0);
  for (const bool background : {false, true}) {
    const auto estimator = std::make_shared<FormulaEstimator>();
    std::mutex lock;
    std::set<std::pair<int, int>> standings;
    estimator->before = [&](std::span<const glm::ivec3>, SampleRange, std::stop_token) {
      const std::lock_guard guard(lock);
      standings.insert(standing());
      return true;
    };
    const auto lattice = std::make_shared<LightLattice>(geometry, estimator->content(), "key");
    LightBake bake(lattice, estimator, {.samples = 4, .threads = 2, .background = background});
    bake.want(Priority::rest, texelsWhere(geometry, [](glm::ivec3) { return true; }));
    ASSERT_TRUE(bake.waitFor(0, 120.0));
    // A tenth of an ordinary thread; at nice 19, or idle, it would not see a stop for a fifth of a second.
    const std::pair<int, int> own = standing();
    if (background && own.first > 10) GTEST_SKIP() << "these tests stand behind it themselves";
    const std::pair<int, int> expected = background ? std::pair(10, SCHED_BATCH) : own;
    EXPECT_EQ(standings, std::set{expected}) << background;
  }
}

// Units are as short as they can be, so that the threads nearly always hold a lock of theirs, and there are
// more threads than processors, so that some are put aside while they do.
TEST(LightBakeOfAWindow, ItsOwnerNeverWaitsForAThread) {
  const LatticeGeometry geometry = LatticeGeometry::make({96, 96, 96}, 1.0);
  const auto everything = texelsWhere(geometry, [](glm::ivec3) { return true; });
  std::vector<BlockRequest> single;  // a texel each: next to no light between two looks at the queue
  for (const BlockRequest& block : everything)
    single.push_back({block.block, std::bitset<kTexelsOfBlock>(1)});
  const auto estimator = std::make_shared<FormulaEstimator>();
  const int threads = 2 * static_cast<int>(std::max(std::thread::hardware_concurrency(), 1u));
  constexpr int kCalls = 2000;
  int calls = 0, waited = 0;
  while (calls < kCalls) {
    const auto lattice = std::make_shared<LightLattice>(geometry, estimator->content(), "key");
    LightBake bake(lattice, estimator, {.samples = 64, .threads = threads});
    bake.want(Priority::rest, single);
    for (int i = 0; i < 100 && !bake.counters().idle; ++i, ++calls) {
      const long waits = test::ownWaits([&] {  // as a window that draws
        bake.yield(i % 2 == 0);
        bake.want(Priority::visible, {single[static_cast<std::size_t>(i)]});
        static_cast<void>(bake.counters());
        bake.yield(false);
      });
      waited += waits > 0;
      std::this_thread::yield();
    }
  }
  RecordProperty("waited", waited);
  EXPECT_LE(waited, calls / 100);  // the allocator has locks, too
}

}  // namespace
}  // namespace isolux::gi
