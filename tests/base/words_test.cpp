#include "base/words.h"

#include <vector>

#include <gtest/gtest.h>

namespace isolux::base {
namespace {

TEST(Suggestion, FindsTheNearestWord) {
  const std::vector<std::string> words{"info", "render", "replay", "phantom", "settings", "doctor"};
  EXPECT_EQ(nearest("inof", words), "info");
  EXPECT_EQ(nearest("rendr", words), "render");
  EXPECT_EQ(nearest("setting", words), "settings");
  EXPECT_EQ(nearest("replay", words), "replay");
}

TEST(Suggestion, StaysSilentWhenNothingIsNear) {
  const std::vector<std::string> words{"info", "render"};
  EXPECT_EQ(nearest("completely different", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(nearest(std::string(100000, 'r'), words), "");
  EXPECT_EQ(nearest("info", {}), "");
}

}  // namespace
}  // namespace isolux::base
