#include "gi/sampling/guide_table.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"

namespace isolux::gi {
namespace {

constexpr std::uint32_t end = 1u << 31;

// The starts of intervals of these weights; one of weight 0 is empty.
std::vector<std::uint32_t> startsOf(const std::vector<double>& weights) {
  double total = 0.0, before = 0.0;
  for (const double weight : weights) total += weight;
  std::vector<std::uint32_t> starts;
  for (const double weight : weights) {
    starts.push_back(static_cast<std::uint32_t>(std::min(before / total * end, static_cast<double>(end))));
    before += weight;
  }
  return starts;
}

std::vector<std::vector<std::uint32_t>> startLists() {
  std::vector<std::vector<std::uint32_t>> all;
  for (const std::size_t count : {1u, 2u, 3u, 17u, 64u, 1000u}) {
    std::vector<double> even(count, 1.0), steep(count), gaps(count), one(count, 0.0), last(count, 1e-9);
    for (std::size_t i = 0; i < count; ++i) {
      steep[i] = std::pow(base::uniformNoise(count, i), 20.0);
      gaps[i] = i % 3 == 1 ? base::uniformNoise(count, i) : 0.0;
    }
    one[count / 2] = 1.0;
    gaps[count / 2] = 1.0;
    last[count - 1] = 1.0;
    for (const auto& weights : {even, steep, gaps, one, last}) all.push_back(startsOf(weights));
  }
  return all;
}

TEST(GuideTable, FindsWhatABinarySearchFinds) {
  for (const std::vector<std::uint32_t>& starts : startLists()) {
    std::vector<std::uint32_t> guide(guideSize(starts.size()));
    ASSERT_LE(guide.size(), starts.size() + 1);
    fillGuide(starts, guide);
    const auto check = [&](std::uint32_t value) {
      const auto after = std::upper_bound(starts.begin(), starts.end(), value);
      ASSERT_EQ(intervalOf(starts, guide, value), static_cast<std::size_t>(after - starts.begin()) - 1)
          << value << " of " << starts.size();
    };
    check(end - 1);
    for (const std::uint32_t start : starts)  // both sides of every edge
      for (const std::uint32_t value : {start - 1, start, start + 1})
        if (value < end) check(value);
    for (std::uint32_t cell = 0; cell < guide.size(); ++cell) {
      const std::uint32_t first = cell << (31 - guideBits(starts.size()));
      for (const std::uint32_t value : {first, first - 1})
        if (value < end) check(value);
    }
    for (std::uint32_t i = 0; i < 20000; ++i) check(base::hash32(i) >> 1);
    for (std::uint64_t value = 0; value < end; value += 99991) check(static_cast<std::uint32_t>(value));
  }
}

// Averaged over all numbers, which is over all cells: the intervals that a search has left.
TEST(GuideTable, LeavesFewIntervals) {
  for (const std::vector<std::uint32_t>& starts : startLists()) {
    std::vector<std::uint32_t> guide(guideSize(starts.size()));
    fillGuide(starts, guide);
    double left = 0.0;
    for (std::size_t cell = 0; cell + 1 < guide.size(); ++cell)
      left += static_cast<double>(guide[cell + 1] - guide[cell]) + 1.0;
    EXPECT_LE(left / static_cast<double>(guide.size() - 1), 9.0) << starts.size();
  }
}

}  // namespace
}  // namespace isolux::gi
