// FLIP against what follows from its paper, and against an independent version with whole two-dimensional
// kernels in numpy (float64), whose numbers stand here.
#include "app/image_metrics/flip.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/color.h"
#include "tests/support/picture_flip.h"

namespace isolux::app {
namespace {

template <class Function>
ComparedPicture pictureOf(glm::ivec2 size, const Function& color) {
  ComparedPicture picture{size, {}};
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) picture.linear.push_back(color(x, y));
  return picture;
}

ComparedPicture evenPicture(const glm::dvec3& color) {
  return pictureOf({16, 16}, [&](int, int) { return color; });
}

// Bytes of sRGB by a formula: numpy has the same.
ComparedPicture pattern(int seed) {
  return pictureOf({24, 18}, [&](int x, int y) {
    glm::dvec3 color;
    for (int c = 0; c < 3; ++c) {
      const int byte =
          (x * (37 + 11 * c) + y * (61 + 7 * c) + x * y * (seed + c) / 3 + seed * 53 * (c + 1)) % 256;
      color[c] = base::decodeSrgb(byte / 255.0);
    }
    return color;
  });
}

double at(const std::vector<double>& flip, int x, int y, int width = 24) {
  return flip[static_cast<std::size_t>(y * width + x)];
}

TEST(Flip, EqualPicturesDoNotDifferAndOrderDoesNotMatter) {
  for (const double flip : flipImage(pattern(1), pattern(1))) EXPECT_EQ(flip, 0.0);
  const std::vector<double> there = flipImage(pattern(1), pattern(2)),
                            back = flipImage(pattern(2), pattern(1));
  for (std::size_t i = 0; i < there.size(); ++i) {
    EXPECT_NEAR(there[i], back[i], 1e-12);
    EXPECT_GE(there[i], 0.0);
    EXPECT_LE(there[i], 1.0);
  }
}

// Even pictures have no features and lose nothing in the eye's filters: what is left is the colour. Green and
// blue are what the paper takes for the largest difference: 1. Black and white differ by 100 in L*, in a
// scale whose largest difference is 203.28 (HyAB, Hunt): 0.95 + 0.05 (100^0.7 - 0.4 m) / (0.6 m), m =
// 203.28^0.7.
TEST(Flip, EvenColoursDifferByTheirColourAlone) {
  for (const double flip : flipImage(evenPicture({0.0, 1.0, 0.0}), evenPicture({0.0, 0.0, 1.0})))
    EXPECT_NEAR(flip, 1.0, 1e-9);
  const double most = std::pow(203.28, 0.7);
  const double expected = 0.95 + 0.05 * (std::pow(100.0, 0.7) - 0.4 * most) / (0.6 * most);
  for (const double flip : flipImage(evenPicture(glm::dvec3(0.0)), evenPicture(glm::dvec3(1.0)))) {
    EXPECT_NEAR(flip, expected, 1e-4);
    EXPECT_NEAR(flip, 0.967380, 1e-6) << "numpy";
  }
}

TEST(Flip, IsWhatAnIndependentVersionComputes) {
  std::vector<double> flip = flipImage(pattern(1), pattern(2));
  EXPECT_NEAR(meanFlip(pattern(1), pattern(2)), 0.2990286457991588, 1e-6);
  EXPECT_NEAR(at(flip, 0, 0), 0.43911238518259, 1e-6);
  EXPECT_NEAR(at(flip, 11, 7), 0.11082875128160329, 1e-6);
  EXPECT_NEAR(at(flip, 23, 17), 0.38009173318438383, 1e-6);
  flip = flipImage(pattern(1), pattern(2), 30.0);
  EXPECT_NEAR(meanFlip(pattern(1), pattern(2), 30.0), 0.8011575796859276, 1e-6);
  EXPECT_NEAR(at(flip, 11, 7), 0.6447485431270393, 1e-6);
}

TEST(Flip, SmoothColoursAndALineAreThoseOfTheIndependentVersion) {
  const auto ramp = [](double scale) {
    return pictureOf({24, 18}, [&](int x, int y) {
      const glm::dvec3 color(x / 23.0, y / 17.0, (x + y) / 40.0);
      return glm::min(scale * color, glm::dvec3(1.0));
    });
  };
  const std::vector<double> flip = flipImage(ramp(1.0), ramp(1.1));
  EXPECT_NEAR(at(flip, 0, 0), 0.08364941733416865, 1e-6);
  EXPECT_NEAR(at(flip, 11, 7), 0.1736185335710601, 1e-6);
  EXPECT_NEAR(meanFlip(ramp(1.0), ramp(1.1)), 0.20183036106882377, 1e-6);

  const glm::dvec3 grey(base::decodeSrgb(0.5));
  const auto withLine = [&](int column) {
    return pictureOf({24, 24}, [&](int x, int) { return x == column ? glm::dvec3(1.0) : grey; });
  };
  const std::vector<double> line = flipImage(withLine(-1), withLine(12));
  EXPECT_NEAR(at(line, 12, 12), 0.6849754364848016, 1e-6);
  EXPECT_NEAR(at(line, 16, 12), 0.021664402049284857, 1e-6);
  EXPECT_EQ(at(line, 0, 0), 0.0);
}

TEST(Flip, NearerPixelsAreSeenBetter) {
  const auto dots = [](int shift) {
    return pictureOf({24, 18}, [&](int x, int y) { return glm::dvec3((x + y + shift) % 2); });
  };
  EXPECT_GT(meanFlip(dots(0), dots(1), 10.0), 2.0 * meanFlip(dots(0), dots(1), 67.0));
}

TEST(ComparedPicture, ReadsBothKindsOfPictures) {
  render::ColorImage bytes{{2, 1}, {0, 128, 255, 255, 255, 255, 255, 255}};
  const render::LinearImage linear{{2, 1}, {0.0f, 0.21586f, 1.0f, 1.0f, 7.0f, 1.0f, 1.0f, 1.0f}};
  EXPECT_LT(rmsDifference(comparedPicture(bytes), comparedPicture(linear)), 1e-5) << "cut off at 1";
  EXPECT_LT(test::flipOf(bytes, bytes), 1e-12);
  render::ColorImage other = bytes;
  other.rgba[4] = other.rgba[5] = other.rgba[6] = 0;
  EXPECT_NEAR(rmsDifference(comparedPicture(bytes), comparedPicture(other)), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(rmsDifference(comparedPicture(bytes), comparedPicture(other), {false, true}), 1.0, 1e-12);
  EXPECT_TRUE(std::isnan(rmsDifference(comparedPicture(bytes), comparedPicture(other), {false, false})));
  EXPECT_GT(test::flipOf(bytes, other), 0.1);
}

// Four blocks of 2 x 2: two even ones, one with an edge, one with a difference too small for one.
TEST(ComparedPicture, EdgesAreWhereABlockIsNotEven) {
  const ComparedPicture picture = pictureOf({4, 4}, [](int x, int y) {
    if (x >= 2 && y < 2) return glm::dvec3(x == 3 ? 1.0 : 0.0);
    if (x < 2 && y >= 2) return glm::dvec3(base::decodeSrgb(x == 1 ? 0.55 : 0.5));
    return glm::dvec3(0.25);
  });
  EXPECT_EQ(edgePixels(picture, 2, 0.1), (std::vector<bool>{false, true, false, false}));
  const ComparedPicture means = blockMeans(picture, 2);
  EXPECT_EQ(means.size, glm::ivec2(2));
  EXPECT_DOUBLE_EQ(means.linear[0].x, 0.25);
  EXPECT_DOUBLE_EQ(means.linear[1].y, 0.5) << "of linear light";
}

}  // namespace
}  // namespace isolux::app
