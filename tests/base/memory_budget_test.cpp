// The memory budget: sums, refusals and what they say, reservations from many threads, sizes as text.
#include "base/memory_budget.h"

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

using Held = MemoryBudget::Held;

TEST(MemoryBudget, CountsWhatIsHeldAsLongAsItLives) {
  MemoryBudget budget(1000);
  EXPECT_EQ(budget.left(), 1000u);
  {
    Held first = budget.reserve(600, "first", "");
    EXPECT_EQ(first.bytes(), 600u);
    EXPECT_EQ(budget.held(), 600u);
    const Held moved = std::move(first);
    EXPECT_EQ(budget.held(), 600u);
    EXPECT_EQ(moved.bytes(), 600u);
    const Held copy = moved;  // of data that is there twice now
    EXPECT_EQ(budget.held(), 1200u);
    EXPECT_EQ(budget.left(), 0u);
  }
  EXPECT_EQ(budget.held(), 0u);
}

TEST(MemoryBudget, AssigningGivesBackWhatWasHeldBefore) {
  MemoryBudget budget(1000);
  Held held = budget.reserve(600, "", "");
  held = budget.reserve(300, "", "");
  EXPECT_EQ(budget.held(), 300u);
  held = {};
  EXPECT_EQ(budget.held(), 0u);
}

TEST(MemoryBudget, GivesTheLastByteAndNoMore) {
  MemoryBudget budget(1000);
  const Held all = budget.reserve(1000, "all", "");
  EXPECT_FALSE(budget.tryReserve(1));
  EXPECT_TRUE(budget.tryReserve(0));
  EXPECT_FALSE(budget.tryReserve(~std::size_t{0}));
}

TEST(MemoryBudget, ARefusalSaysTheSumAndWhatLowersItAndHoldsNothing) {
  MemoryBudget budget(std::size_t{3} << 30);
  const Held volume = budget.reserve(std::size_t{2} << 30, "the volume", "");
  try {
    const Held light =
        budget.reserve(std::size_t{42} << 30, "the light", "a lower gi.lattice_scale needs less");
    FAIL() << "was granted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::memory);
    EXPECT_STREQ(error.what(),
                 "out of memory for the light: 42.0 GiB needed, 2.0 GiB in use, memory budget of 3.0 GiB; "
                 "a lower gi.lattice_scale needs less, or raise --memory-budget");
  }
  EXPECT_EQ(budget.held(), std::size_t{2} << 30);
  EXPECT_THROW(budget.check(std::size_t{2} << 30, "", ""), Error);
  EXPECT_NO_THROW(budget.check(std::size_t{1} << 30, "", ""));
  EXPECT_EQ(budget.held(), std::size_t{2} << 30);
}

TEST(MemoryBudget, CountsWhatIsThereAlreadyEvenOverTheLimit) {
  MemoryBudget budget(100);
  const Held there = budget.count(250);
  EXPECT_EQ(budget.held(), 250u);
  EXPECT_EQ(budget.left(), 0u);
  budget.setLimit(300);
  EXPECT_EQ(budget.left(), 50u);
}

TEST(MemoryBudget, ThreadsTogetherGetTheLimitAndNoMore) {
  constexpr std::size_t limit = 100000, piece = 7;
  MemoryBudget budget(limit);
  std::vector<std::vector<Held>> taken(8);
  std::vector<std::thread> threads;
  for (std::vector<Held>& mine : taken)
    threads.emplace_back([&budget, &mine] {
      while (auto held = budget.tryReserve(piece)) mine.push_back(std::move(*held));
    });
  for (std::thread& thread : threads) thread.join();
  std::size_t pieces = 0;
  for (const std::vector<Held>& mine : taken) pieces += mine.size();
  EXPECT_EQ(pieces, limit / piece);
  EXPECT_EQ(budget.held(), pieces * piece);
}

TEST(MemoryBudget, ThreadsThatTakeAndGiveBackNeverHoldMoreThanTheLimit) {
  constexpr std::size_t limit = 1000, piece = 70;
  MemoryBudget budget(limit);
  std::atomic<std::size_t> granted{0};
  std::atomic<bool> exceeded{false};
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i < 5000; ++i)
        if (const auto held = budget.tryReserve(piece)) {
          if ((granted += piece) > limit) exceeded = true;
          granted -= piece;
        }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_FALSE(exceeded);
  EXPECT_EQ(budget.held(), 0u);
}

TEST(MemoryBudget, TheMachineAllowsSomethingAndNotMoreThanItHas) {
  EXPECT_GT(allowedMemory(), std::size_t{16} << 20);
  EXPECT_LT(allowedMemory(), std::size_t{1} << 48);
  EXPECT_EQ(&machineMemory(), &machineMemory());
}

TEST(MemoryBudget, WhatTheSystemDoesNotHaveIsRefusedWhateverTheLimit) {
  static std::size_t left = 0;
  MemoryBudget budget(std::size_t{100} << 30, [] { return left; });
  left = std::size_t{1} << 30;
  EXPECT_TRUE(budget.tryReserve(std::size_t{900} << 20));
  EXPECT_FALSE(budget.tryReserve(std::size_t{1020} << 20)) << "what is not counted needs some";
  try {
    budget.check(std::size_t{2} << 30, "the light", "less is less");
    FAIL() << "was granted";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "out of memory for the light: 2.0 GiB needed, 1.0 GiB left in the system; less is less");
  }
}

TEST(MemoryBudget, WhatIsHeldCanGrowAndShrink) {
  MemoryBudget budget(1000);
  Held held;
  held.add(budget.reserve(300, "", ""));
  held.add(budget.reserve(200, "", ""));
  EXPECT_EQ(held.bytes(), 500u);
  EXPECT_EQ(budget.held(), 500u);
  held.shrinkTo(100);
  held.shrinkTo(400);
  EXPECT_EQ(held.bytes(), 100u);
  EXPECT_EQ(budget.held(), 100u);
  held.release();
  EXPECT_EQ(budget.held(), 0u);
}

TEST(MemoryBudget, SizesAreReadInTheUnitsThatPeopleWrite) {
  EXPECT_EQ(parseMemorySize("200000000"), 200000000u);
  EXPECT_EQ(parseMemorySize("512M"), std::size_t{512} << 20);
  EXPECT_EQ(parseMemorySize("16 GiB"), std::size_t{16} << 30);
  EXPECT_EQ(parseMemorySize("1.5g"), std::size_t{3} << 29);
  EXPECT_EQ(parseMemorySize("2TB"), std::size_t{2} << 40);
  EXPECT_EQ(parseMemorySize("64kb"), std::size_t{64} << 10);
  for (const char* wrong : {"", "0", "-1", "M", "1X", "1e300", "nan", "inf", "12 monkeys", "1GG"})
    EXPECT_THROW(parseMemorySize(wrong), Error) << wrong;
}

}  // namespace
}  // namespace isolux::base
