// Colour maps: published values, even and monotone lightness, symmetric divergence.
#include "scene/color_maps.h"
#include "base/color.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

namespace isolux::scene {
namespace {

std::vector<glm::vec3> samples(ColorMap map, LookMode mode = LookMode::kappa1) {
  return colorMapSamples(map, 256, lookInfo(mode).colors);
}

// CIE lightness of a linear colour, from its luminance alone (not by the way of the code under test).
double lightness(const glm::vec3& c) {
  const double y = 0.2126 * static_cast<double>(c.x) + 0.7152 * static_cast<double>(c.y) +
                   0.0722 * static_cast<double>(c.z);
  return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : y * 24389.0 / 27.0;
}

void expectSrgb(const glm::vec3& linear, const glm::dvec3& published, double tolerance) {
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(base::encodeSrgb(static_cast<double>(linear[c])), published[c], tolerance) << "channel " << c;
}

// Rows of the published 256 entries that are not knots of our tables.
TEST(ColorMapsTest, UniformMapsHavePublishedColors) {
  constexpr double tolerance = 2.0 / 255.0;
  const auto viridis = samples(ColorMap::viridis);
  expectSrgb(viridis[20], {0.2832, 0.1157, 0.4361}, tolerance);
  expectSrgb(viridis[77], {0.2049, 0.3757, 0.5535}, tolerance);
  expectSrgb(viridis[130], {0.1254, 0.5743, 0.5491}, tolerance);
  expectSrgb(viridis[240], {0.8456, 0.8873, 0.0997}, tolerance);
  const auto cividis = samples(ColorMap::cividis);
  expectSrgb(cividis[77], {0.3133, 0.3431, 0.4251}, tolerance);
  expectSrgb(cividis[200], {0.7694, 0.7070, 0.4085}, tolerance);
  const auto inferno = samples(ColorMap::inferno);
  expectSrgb(inferno[77], {0.4225, 0.0925, 0.4327}, tolerance);
  expectSrgb(inferno[130], {0.7471, 0.2224, 0.3229}, tolerance);
  expectSrgb(inferno[240], {0.9476, 0.9174, 0.4107}, tolerance);
}

// Moreland 2009 lists (59, 76, 192), (221, 221, 221) and (180, 4, 38) of 255 as ends and middle.
TEST(ColorMapsTest, CoolwarmIsMorelands) {
  const auto map = colorMapSamples(ColorMap::coolwarm, 257);
  expectSrgb(map.front(), glm::dvec3(59, 76, 192) / 255.0, 2.5 / 255.0);
  expectSrgb(map[128], glm::dvec3(221, 221, 221) / 255.0, 2.5 / 255.0);
  expectSrgb(map.back(), glm::dvec3(180, 4, 38) / 255.0, 2.5 / 255.0);
}

TEST(ColorMapsTest, LightnessOfUniformMapsRisesEvenly) {
  for (const ColorMap map : {ColorMap::viridis, ColorMap::cividis, ColorMap::inferno, ColorMap::gray}) {
    const auto colors = samples(map);
    const double mean = (lightness(colors.back()) - lightness(colors.front())) / 255.0;
    for (std::size_t i = 1; i < colors.size(); ++i) {
      const double step = lightness(colors[i]) - lightness(colors[i - 1]);
      EXPECT_GT(step, 0.0) << static_cast<int>(map) << " at " << i;
      EXPECT_LT(step, 2.0 * mean) << static_cast<int>(map) << " at " << i;
    }
  }
}

TEST(ColorMapsTest, DivergingMapsAreSymmetricInLightness) {
  for (const ColorMap map : {ColorMap::coolwarm, ColorMap::blue_orange, ColorMap::purple_green}) {
    const auto colors = samples(map);
    for (std::size_t i = 0; i < 128; ++i) {
      EXPECT_NEAR(lightness(colors[i]), lightness(colors[255 - i]), 1.5)
          << static_cast<int>(map) << " at " << i;
      if (i > 0) {
        EXPECT_GT(lightness(colors[i]), lightness(colors[i - 1])) << static_cast<int>(map) << " at " << i;
      }
    }
    const glm::vec3 middle = 0.5f * (colors[127] + colors[128]);
    EXPECT_LT(std::max({middle.x, middle.y, middle.z}) - std::min({middle.x, middle.y, middle.z}), 0.03f);
    EXPECT_GT(glm::distance(colors.front(), colors.back()), 0.3f);
  }
}

TEST(ColorMapsTest, AutomaticFitsTheMeasure) {
  EXPECT_EQ(samples(ColorMap::automatic, LookMode::mean_curvature), samples(ColorMap::coolwarm));
  EXPECT_EQ(samples(ColorMap::automatic, LookMode::curvedness), samples(ColorMap::viridis));
  const auto shape = colorMapSamples(ColorMap::automatic, 9, LookColors::shape);
  EXPECT_GT(shape.front().y, shape.front().x);  // cup: green
  EXPECT_GT(shape.back().x, shape.back().y);    // cap: red
  EXPECT_GT(lightness(shape[4]), 90.0);         // saddle: white
}

TEST(ColorMapsTest, PointsAreJoinedLinearlyAndHeldBeyondTheEnds) {
  const std::vector<ColorPoint> points = {
      {0.2, {0.0, 0.0, 1.0}}, {0.6, {1.0, 0.5, 0.0}}, {0.6, {0.0, 1.0, 0.0}}, {0.8, {1.0, 1.0, 1.0}}};
  EXPECT_EQ(colorOfPoints(points, 0.0), glm::dvec3(0.0, 0.0, 1.0));
  EXPECT_EQ(colorOfPoints(points, 1.0), glm::dvec3(1.0));
  EXPECT_LT(glm::distance(colorOfPoints(points, 0.3), glm::dvec3(0.25, 0.125, 0.75)), 1e-12);
  EXPECT_LT(glm::distance(colorOfPoints(points, 0.7), glm::dvec3(0.5, 1.0, 0.5)), 1e-12);
  EXPECT_EQ(colorOfPoints(points, 0.6), glm::dvec3(0.0, 1.0, 0.0));  // a step
  const auto sampled = pointSamples(points, 11);
  EXPECT_LT(glm::distance(sampled[3], glm::vec3(0.25f, 0.125f, 0.75f)), 1e-6f);
}

TEST(ColorMapsTest, TheStartOfAnOwnFunctionIsTheAutomaticMap) {
  Look look;
  look.mode = LookMode::gaussian_curvature;
  const auto map = colorMapSamples(ColorMap::coolwarm, 256);
  const auto points = pointSamples(automaticColorPoints(look), 256);
  for (std::size_t i = 0; i < map.size(); ++i) EXPECT_LT(glm::distance(map[i], points[i]), 0.03f) << i;
}

}  // namespace
}  // namespace isolux::scene
