#include "base/recent.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

TEST(Recent, KeepsTheEntriesRequestedLast) {
  Recent<int, std::string> recent(2);
  int made = 0;
  const auto get = [&](int key) {
    return recent.get(key, [&] {
      ++made;
      return std::to_string(key);
    });
  };
  get(1), get(2), get(1), get(3);
  EXPECT_EQ(made, 3);
  EXPECT_EQ(recent.find(1), "1");
  EXPECT_EQ(recent.find(2), std::nullopt);
  EXPECT_EQ(get(3), "3");
  EXPECT_EQ(made, 3);
}

TEST(Recent, EvictsItsOwnEntriesBeforeMemoryIsRefused) {
  Recent<int, int> recent(4);
  for (int key = 0; key < 4; ++key) recent.get(key, [key] { return key; });
  int tries = 0;
  const auto make = [&] {
    if (++tries < 3) throw Error(ErrorKind::memory, "", "", "too much");
    return 7;
  };
  EXPECT_EQ(recent.get(9, make), 7);
  EXPECT_EQ(recent.find(2), std::nullopt);
  EXPECT_EQ(recent.find(3), 3);
  tries = -10;
  EXPECT_THROW(recent.get(8, make), Error);
  EXPECT_TRUE(recent.empty());
}

TEST(Recent, TwoThatComputeTheSameReturnTheFirst) {
  Once<int> once;
  EXPECT_EQ(once.get({}, [&] { return once.get({}, [] { return 1; }) + 1; }), 1);
}

}  // namespace
}  // namespace isolux::base
