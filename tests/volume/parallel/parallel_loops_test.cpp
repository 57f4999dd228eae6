#include "volume/parallel/parallel_loops.h"

#include <atomic>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace isolux::volume {

namespace {

TEST(ParallelLoops, CallForEachIndexOnce) {
  std::vector<std::atomic<int>> calls(10007);
  parallelEach(calls.size(), [&](std::size_t i) { ++calls[i]; });
  parallelRanges(static_cast<std::uint32_t>(calls.size()), 64, [&](const Indices<std::uint32_t>& range) {
    for (std::uint32_t i = range.begin(); i != range.end(); ++i) ++calls[i];
  });
  for (std::size_t i = 0; i < calls.size(); ++i) EXPECT_EQ(calls[i], 2) << i;
}

TEST(ParallelLoops, RangesMakeUpTheWhole) {
  std::atomic<std::size_t> sum{0};
  parallelRanges(1000, 7, [&](const Indices<int>& range) {
    EXPECT_LT(range.begin(), range.end());
    sum += range.size();
  });
  EXPECT_EQ(sum, 1000u);
}

TEST(ParallelLoops, OfNothingCallNothing) {
  parallelEach(0, [](int) { FAIL(); });
  parallelEach(-3, [](int) { FAIL(); });
  parallelRanges(std::size_t{0}, 1, [](const Indices<std::size_t>&) { FAIL(); });
}

TEST(ParallelLoops, ThrowWhatACallThrows) {
  EXPECT_THROW(parallelEach(100,
                            [](int i) {
                              if (i == 57) throw std::runtime_error("57");
                            }),
               std::runtime_error);
}

}  // namespace

}  // namespace isolux::volume
