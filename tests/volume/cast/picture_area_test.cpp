// Parts of images: no GL.
#include "volume/cast/picture_area.h"

#include <random>

#include <gtest/gtest.h>

namespace isolux::volume {
namespace {

// How many of the rectangles hold each pixel.
std::vector<int> countsOf(const PictureArea& area, glm::ivec2 size) {
  std::vector<int> counts(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (const Rectangle& part : area.rectangles())
    for (int y = 0; y < part.size.y; ++y)
      for (int x = 0; x < part.size.x; ++x)
        ++counts.at(static_cast<std::size_t>(part.low.y + y) * static_cast<std::size_t>(size.x) +
                    static_cast<std::size_t>(part.low.x + x));
  return counts;
}

TEST(PictureArea, OfNothingHasNoRectangles) {
  EXPECT_TRUE(PictureArea().empty());
  EXPECT_TRUE(PictureArea({40, 30}).empty());
  EXPECT_TRUE(PictureArea({40, 30}).rectangles().empty());
  EXPECT_TRUE(PictureArea::of({40, 30}, {{50, 0}, {10, 10}}).empty()) << "beyond the image";
}

TEST(PictureArea, OfAnImageIsOneRectangle) {
  for (const glm::ivec2& size : {glm::ivec2(1, 1), glm::ivec2(7, 16), glm::ivec2(300, 229)}) {
    const std::vector<Rectangle> all = PictureArea::whole(size).rectangles();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0], (Rectangle{glm::ivec2(0), size}));
  }
}

TEST(PictureArea, StripsOfTheSameColumnsAreOneRectangleUnlessTheyAreApart) {
  const glm::ivec2 size(100, 8 * PictureArea::kRows);
  PictureArea area(size);
  for (const int strip : {1, 2, 4, 5}) area.add(strip * PictureArea::kRows + 3, 10, 20);
  area.add(5 * PictureArea::kRows, 30, 40);
  const std::vector<Rectangle> expected = {{{10, 16}, {10, 32}}, {{10, 64}, {10, 16}}, {{10, 80}, {30, 16}}};
  EXPECT_EQ(area.rectangles(), expected);
}

// Whatever is added, by rows, by areas: each pixel of it lies in one rectangle, none in two.
TEST(PictureArea, HoldsWhatIsAddedOnce) {
  std::mt19937 random(7);
  const auto upTo = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  for (int round = 0; round < 200; ++round) {
    const glm::ivec2 size(1 + upTo(90), 1 + upTo(90));
    PictureArea area(size), other(size);
    std::vector<int> expected(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    for (int i = upTo(12); i > 0; --i) {
      const int row = upTo(size.y - 1), begin = upTo(size.x), end = begin + upTo(size.x - begin);
      (i % 2 ? area : other).add(row, begin, end);
      for (int x = begin; x < end; ++x)
        expected.at(static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
                    static_cast<std::size_t>(x)) = 1;
    }
    area.add(other);
    const std::vector<int> counts = countsOf(area, size);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      ASSERT_LE(counts[i], 1);
      ASSERT_GE(counts[i], expected[i]);
    }
  }
}

}  // namespace
}  // namespace isolux::volume
