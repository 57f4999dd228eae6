#include "volume/voxels/extent.h"

#include <vector>

#include <gtest/gtest.h>

namespace isolux::volume {
namespace {

TEST(Extent, NumbersElementsInTheOrderOfMemory) {
  const Extent3 extent{{3, 4, 5}};
  EXPECT_EQ(extent.count(), 60u);
  std::size_t i = 0;
  forEachIn(glm::ivec3(0), extent.dims, [&](glm::ivec3 v) {
    EXPECT_EQ(extent.index(v), i);
    EXPECT_EQ(extent.at(i), v);
    EXPECT_EQ(extent.firstOfRow(i / extent.row()), glm::ivec3(0, v.y, v.z));
    ++i;
  });
  EXPECT_EQ(i, extent.count());
  const Extent2 image{{3, 4}};
  EXPECT_EQ(image.count(), 12u);
  EXPECT_EQ(image.index(2, 3), 11u);
  EXPECT_EQ(image.at(11), glm::ivec2(2, 3));
}

TEST(Extent, CountsBeyondThirtyTwoBits) {
  const Extent3 extent{glm::ivec3(5000)};
  EXPECT_EQ(extent.count(), 125'000'000'000u);
  EXPECT_EQ(extent.index({4999, 4999, 4999}), extent.count() - 1);
  EXPECT_EQ(extent.at(extent.count() - 1), glm::ivec3(4999));
  EXPECT_EQ(Extent2{glm::ivec2(100'000)}.count(), 10'000'000'000u);
}

TEST(Extent, ContainsWhatIsBelowItsSizeOnEveryAxis) {
  const Extent3 extent{{3, 4, 5}};
  EXPECT_TRUE(extent.contains({0, 0, 0}));
  EXPECT_TRUE(extent.contains({2, 3, 4}));
  for (const glm::ivec3& v :
       {glm::ivec3(-1, 0, 0), glm::ivec3(3, 0, 0), glm::ivec3(0, 4, 0), glm::ivec3(0, 0, 5)})
    EXPECT_FALSE(extent.contains(v));
  for (const int i : {-1, 0}) EXPECT_FALSE(Extent3{}.contains(glm::ivec3(i)));
  EXPECT_TRUE((Extent2{{3, 4}}.contains({2, 3})));
  EXPECT_FALSE((Extent2{{3, 4}}.contains({2, 4})));
}

TEST(Extent, HasTheCornersOfCells) {
  EXPECT_EQ(cornerStep(1), glm::ivec3(1, 0, 0));
  EXPECT_EQ(cornerStep(6), glm::ivec3(0, 1, 1));
  const Extent3 flat{{3, 4, 1}};
  EXPECT_EQ(flat.corner({1, 2, 0}, 7), glm::ivec3(2, 3, 0));
}

}  // namespace
}  // namespace isolux::volume
