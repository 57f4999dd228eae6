// Legends: sensible ticks, texts with units, panels that hold everything and read on any background.
#include "render/legend/legend.h"
#include "base/color.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/legend/font.h"
#include "render/passes/legend_overlay.h"
#include "scene/color_maps.h"
#include "scene/curvature_map.h"

namespace isolux::render {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::Pointwise;

TEST(LegendTicksTest, AreRoundAndInside) {
  EXPECT_THAT(tickValues(-0.22, 0.22, 5), Pointwise(DoubleNear(1e-12), {-0.2, -0.1, 0.0, 0.1, 0.2}));
  EXPECT_THAT(tickValues(0.0, 1.0, 4), Pointwise(DoubleNear(1e-12), {0.0, 0.5, 1.0}));
  EXPECT_THAT(tickValues(1.0, -1.0, 4), Pointwise(DoubleNear(1e-12), {-1.0, -0.5, 0.0, 0.5, 1.0}));
  EXPECT_THAT(tickValues(-0.42, 0.42, 3),
              Pointwise(DoubleNear(1e-12), {-0.4, -0.2, 0.0, 0.2, 0.4}));  // not 0 alone
  for (double low = -3.7; low < 4.0; low += 0.61)
    for (double width = 1e-12; width < 1e12; width *= 7.3) {
      const auto ticks = tickValues(low * width, (low + 1.0) * width, 5);
      EXPECT_GE(ticks.size(), 2u);
      EXPECT_LE(ticks.size(), 7u);
      for (const double tick : ticks) {
        EXPECT_GE(tick, (low - 1e-6) * width);
        EXPECT_LE(tick, (low + 1.0 + 1e-6) * width);
      }
    }
}

TEST(LegendTicksTest, ARangeWithoutWidthHasOneTick) {
  EXPECT_THAT(tickValues(2.5, 2.5, 5), ElementsAre(2.5));
  EXPECT_THAT(tickValues(1e6, 1e6 + 1e-9, 5), ElementsAre(DoubleNear(1e6, 1e-6)));
  EXPECT_THAT(tickValues(0.0, 0.0, 5), ElementsAre(0.0));
  EXPECT_THAT(tickValues(std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), 5).size(),
              1u);
}

std::vector<std::string> texts(const std::vector<double>& ticks) {
  std::vector<std::string> result;
  for (const double tick : ticks) result.push_back(tickText(tick, tickFormat(ticks)));
  return result;
}

TEST(LegendTicksTest, TextsHaveTheDecimalsTheStepNeeds) {
  EXPECT_THAT(texts({-0.2, -0.1, 0.0, 0.1, 0.2}), ElementsAre("−0.2", "−0.1", "0.0", "0.1", "0.2"));
  EXPECT_THAT(texts({0.0, 0.05, 0.10}), ElementsAre("0.00", "0.05", "0.10"));
  EXPECT_THAT(texts({-20.0, 0.0, 20.0}), ElementsAre("−20", "0", "20"));
  const std::vector<double> tiny = {-2e-5, 0.0, 2e-5};
  EXPECT_EQ(tickFormat(tiny).exponent, -5);
  EXPECT_THAT(texts(tiny), ElementsAre("−2", "0", "2"));
  EXPECT_EQ(tickFormat({0.0, 2e6}).exponent, 6);
  EXPECT_THAT(texts({0.0123}), ElementsAre("0.0123"));
}

TEST(LegendTicksTest, TitlesCarryUnitAndPower) {
  EXPECT_EQ(axisTitle("κ₁", "1/mm", 0), "κ₁ (1/mm)");
  EXPECT_EQ(axisTitle("K", "1/mm²", -12), "K (10⁻¹² 1/mm²)");
  EXPECT_EQ(axisTitle("shape index", "", 0), "shape index");
  EXPECT_EQ(axisTitle("shape index", "", 3), "shape index (10³)");
}

TEST(LegendTicksTest, LogarithmicOnesAreOneTwoAndFive) {
  EXPECT_THAT(logarithmicTicks(1e-5, 1e-4), Pointwise(DoubleNear(1e-12), {1e-5, 2e-5, 5e-5, 1e-4}));
  EXPECT_THAT(logarithmicTicks(0.2, 5.0), Pointwise(DoubleNear(1e-12), {0.2, 0.5, 1.0, 2.0, 5.0}));
  EXPECT_THAT(logarithmicTicks(0.05, 50.0),
              Pointwise(DoubleNear(1e-12), {0.1, 1.0, 10.0, 50.0}));  // long, with an end of its own
  EXPECT_TRUE(areShownAsPowers({1e-5, 1e-4, 1e-3, 1e-2}));
  EXPECT_FALSE(areShownAsPowers({1e-3, 1e-2}));
  EXPECT_EQ(logarithmicTickText(0.02, false), "0.02");
  EXPECT_EQ(logarithmicTickText(2e-5, true), "2·10⁻⁵");
  EXPECT_EQ(logarithmicTickText(1e-4, true), "10⁻⁴");
}

TEST(LegendTicksTest, AHatchIsHalfOfItsPixels) {
  int dark = 0, bright = 0;
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) {
      dark += hatchAt({x, y}, 3) == Hatch::dark;
      bright += hatchAt({x, y}, 3) == Hatch::bright;
      EXPECT_EQ(hatchAt({x, y}, 3), hatchAt({x + 1, y + 11}, 3));
    }
  EXPECT_EQ(dark, 24 * 24 / 4);
  EXPECT_EQ(bright, 24 * 24 / 4);
}

TEST(FontTest, HasEverySignLegendsUse) {
  const Font font(40);
  std::string missing;  // a code point no font has: drawn as the box of missing glyphs
  const auto drawn = [&](const std::string& text) {
    std::vector<std::pair<int, int>> ink;
    font.draw(text, {0, 0}, [&](glm::ivec2 p, int coverage) {
      if (coverage > 127) ink.emplace_back(p.x, p.y);
    });
    return ink;
  };
  const auto box = drawn("\U0010FFFD");
  for (const char* sign : {"κ", "₁", "₂", "²", "⁰", "¹", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹", "⁻", "−"}) {
    EXPECT_FALSE(drawn(sign).empty()) << sign;
    EXPECT_NE(drawn(sign), box) << sign;
  }
  EXPECT_EQ(font.width(""), 0);
  EXPECT_GT(font.width("mm"), font.width("m"));
}

Legend bar() {
  Legend legend;
  legend.quantity = "κ₁";
  legend.unit = "1/mm";
  legend.low = -0.2;
  legend.high = 0.2;
  legend.colors = scene::colorMapSamples(scene::ColorMap::coolwarm, 256);
  return legend;
}

Legend square() {
  Legend legend = bar();
  legend.quantityVertical = "κ₂";
  legend.colors = scene::curvatureTexels({}, 32);
  return legend;
}

double luminance(const LegendImage& image, std::size_t pixel, double background) {
  const auto value = [&](std::size_t c) {
    return image.rgba[4 * pixel + c] / 255.0 + background * (1.0 - image.rgba[4 * pixel + 3] / 255.0);
  };
  return base::luminance(
      glm::dvec3(base::decodeSrgb(value(0)), base::decodeSrgb(value(1)), base::decodeSrgb(value(2))));
}

TEST(LegendTest, ScalesWithThePictureAndFitsIt) {
  for (const Legend& legend : {bar(), square()})
    for (const int height : {192, 256, 512, 1024, 2160}) {
      const LegendImage image = drawLegend(legend, height);
      ASSERT_EQ(image.rgba.size(),
                static_cast<std::size_t>(image.size.x) * static_cast<std::size_t>(image.size.y) * 4);
      EXPECT_LT(image.size.y, height * 7 / 10);
      EXPECT_GT(image.size.y, height / 4);
      EXPECT_LT(image.size.x, height * 7 / 10);
    }
}

TEST(LegendTest, IsSmallerInASmallPictureAndAsBeforeInALargeOne) {
  Legend wide = bar();
  wide.quantity = "Error of depth by arithmetic";
  wide.hatched = {"not certain"};
  for (const glm::ivec2& picture : {glm::ivec2(427, 430), glm::ivec2(264, 480), glm::ivec2(460, 400)}) {
    const LegendImage image = legendFor(wide, picture),
                      before = drawLegend(wide, std::min(picture.y, 2 * picture.x));
    EXPECT_LT(image.size.x, before.size.x);
    EXPECT_LT(image.size.x * image.size.y, picture.x * picture.y / 4) << picture.x << ' ' << picture.y;
  }
  EXPECT_EQ(legendFor(wide, {1600, 1000}).size, drawLegend(wide, 1000).size);
  for (const Legend& legend : {bar(), square()})
    EXPECT_EQ(legendFor(legend, {640, 480}).size, drawLegend(legend, 480).size);
  EXPECT_EQ(legendFor(wide, {120, 120}).size, glm::ivec2(0)) << "no room";
}

// WCAG 2.1 contrast of the text against the panel, over black and over white.
TEST(LegendTest, ReadsOnDarkAndLight) {
  const LegendImage image = drawLegend(bar(), 512);
  for (const double background : {0.0, 1.0}) {
    double brightest = 0.0;
    const auto rows = static_cast<std::size_t>(20 * image.size.x);  // the title
    for (std::size_t i = 0; i < rows; ++i) brightest = std::max(brightest, luminance(image, i, background));
    const double panel =
        luminance(image, static_cast<std::size_t>(3 * image.size.x + image.size.x / 2), background);
    const double text =
        background == 1.0 ? 0.85 : brightest;  // over white the rounded corner is brighter than text
    EXPECT_GT((text + 0.05) / (panel + 0.05), 4.5) << background;
  }
}

TEST(LegendTest, IsPremultipliedAndNothingIsCutOff) {
  for (const Legend& legend : {bar(), square()}) {
    const LegendImage image = drawLegend(legend, 512);
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      for (std::size_t c = 0; c < 3; ++c) ASSERT_LE(image.rgba[i + c], image.rgba[i + 3]);
    // The border of the panel is bare: no ink was clipped by the canvas.
    const auto bright = [&](int x, int y) {
      return image.rgba[4 * static_cast<std::size_t>(y * image.size.x + x)] > 60;
    };
    for (int x = 0; x < image.size.x; ++x) EXPECT_FALSE(bright(x, 1) || bright(x, image.size.y - 2)) << x;
    for (int y = 0; y < image.size.y; ++y) EXPECT_FALSE(bright(1, y) || bright(image.size.x - 2, y)) << y;
  }
}

TEST(LegendTest, TheBarShowsTheMapsEnds) {
  const LegendImage image = drawLegend(bar(), 512);
  const Legend legend = bar();
  const auto holds = [&](const glm::vec3& linear) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
      bool same = true;
      for (std::size_t c = 0; c < 3; ++c)
        same = same &&
               std::fabs(image.rgba[i + c] -
                         255.0 * base::encodeSrgb(static_cast<double>(linear[static_cast<int>(c)]))) <= 1.0;
      if (same) return true;
    }
    return false;
  };
  EXPECT_TRUE(holds(legend.colors.front()));
  EXPECT_TRUE(holds(legend.colors.back()));
}

TEST(LegendPlace, IsTheCornerAskedForOrTheOneWithLeastSurface) {
  using enum scene::LegendCorner;
  const glm::ivec2 legend(100, 60), picture(500, 400);  // a margin of 8
  const auto place = [&](scene::LegendCorner corner, const std::vector<volume::Rectangle>& surface) {
    return legendPlace(corner, legend, picture, [&](const volume::Rectangle& part) {
      std::int64_t pixels = 0;
      for (const volume::Rectangle& one : surface) {
        const glm::ivec2 both = volume::common(one, part).size;
        pixels += std::int64_t{both.x} * both.y;
      }
      return pixels;
    });
  };
  EXPECT_EQ(place(upper_left, {}), glm::ivec2(8, 332));
  EXPECT_EQ(place(lower_left, {}), glm::ivec2(8, 8));
  EXPECT_EQ(place(upper_right, {}), glm::ivec2(392, 332));
  EXPECT_EQ(place(automatic, {}), glm::ivec2(392, 8));
  // The lower half, its left part empty.
  EXPECT_EQ(place(automatic, {{{120, 0}, {380, 200}}}), glm::ivec2(8, 8));
  EXPECT_EQ(place(automatic, {{{0, 0}, {500, 200}}}), glm::ivec2(392, 332));
  EXPECT_EQ(place(automatic, {{{0, 0}, {500, 200}}, {{300, 200}, {200, 200}}}), glm::ivec2(8, 332));
  // Everywhere alike, or hardly anything.
  EXPECT_EQ(place(automatic, {{{0, 0}, {500, 400}}}), glm::ivec2(392, 8));
  EXPECT_EQ(place(automatic, {{{392, 8}, {10, 10}}}), glm::ivec2(392, 8));
}

}  // namespace
}  // namespace isolux::render
