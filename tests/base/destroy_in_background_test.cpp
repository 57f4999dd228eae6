#include "base/destroy_in_background.h"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

// Ends when it is let.
struct Slow {
  explicit Slow(std::future<void> may, std::atomic<bool>& gone) : mayEnd(std::move(may)), isGone(gone) {}
  ~Slow() {
    mayEnd.wait();
    isGone = true;
  }
  std::future<void> mayEnd;
  std::atomic<bool>& isGone;
};

TEST(DestroyInBackground, TheCallerDoesNotWaitForTheEnd) {
  std::promise<void> end;
  std::atomic<bool> gone{false};
  destroyInBackground(std::make_unique<Slow>(end.get_future(), gone));
  EXPECT_FALSE(gone);
  EXPECT_FALSE(awaitDestroyed(0.01)) << "a wait is bounded";
  end.set_value();
  EXPECT_TRUE(awaitDestroyed(60.0));
  EXPECT_TRUE(gone);
}

TEST(DestroyInBackground, OneThatIsSlowHoldsUpNoOther) {
  std::promise<void> first, second;
  std::atomic<bool> firstGone{false}, secondGone{false};
  destroyInBackground(std::make_unique<Slow>(first.get_future(), firstGone));
  destroyInBackground(std::make_unique<Slow>(second.get_future(), secondGone));
  second.set_value();
  while (!secondGone) std::this_thread::yield();
  EXPECT_FALSE(firstGone);
  first.set_value();
  EXPECT_TRUE(awaitDestroyed(60.0));
}

TEST(DestroyInBackground, ASharedValueStaysWithItsOtherOwners) {
  const auto kept = std::make_shared<int>(7);
  destroyInBackground(kept);
  EXPECT_TRUE(awaitDestroyed(60.0));
  EXPECT_EQ(kept.use_count(), 1);
  EXPECT_EQ(*kept, 7);
}

}  // namespace
}  // namespace isolux::base
