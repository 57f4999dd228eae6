#include "app/tasks/reference_task.h"

#include <cmath>

#include <gtest/gtest.h>

namespace isolux::app {

TEST(ReferencePreview, IsOfTheMeansOfSquares) {
  render::ColorImage image{{5, 2}, std::vector<std::uint8_t>(4 * 10, 255)};
  for (int i = 0; i < 10; ++i) image.rgba[4U * static_cast<unsigned>(i)] = static_cast<std::uint8_t>(10 * i);
  const render::ColorImage small = reduced(image, 3);  // squares of 2
  ASSERT_EQ(small.size, glm::ivec2(3, 1));
  EXPECT_EQ(small.rgba[0], (0 + 10 + 50 + 60) / 4);
  EXPECT_EQ(small.rgba[4], (20 + 30 + 70 + 80) / 4);
  EXPECT_EQ(small.rgba[8], (40 + 90) / 2);
  EXPECT_EQ(small.rgba[1], 255);
  EXPECT_EQ(small.rgba[3], 255);
  EXPECT_EQ(reduced(image, 5).rgba, image.rgba);
}

TEST(ReferenceNoise, IsTheStandardErrorInPartsOfTheMean) {
  gi::ReferenceImage image;
  image.size = {2, 1};
  image.irradiance = {glm::vec3(2.0F), glm::vec3(4.0F)};
  image.variance = {0.09F, 0.27F};  // of the means
  image.samples = {16, 16};
  image.hit = {1, 1};
  EXPECT_NEAR(noiseOf(image).value_or(0.0), std::sqrt(0.18) / 3.0, 1e-6);
  image.samples = {1, 1};
  EXPECT_FALSE(noiseOf(image).has_value());
}

}  // namespace isolux::app
