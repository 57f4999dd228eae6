// The overlay of errors: colours by the legend's scale, and hatching where a bound exceeds its limit, nowhere
// else.
#include "app/accuracy/error_overlay.h"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/legend/legend.h"

namespace isolux::app {
namespace {

constexpr glm::ivec2 kSize{320, 240};
constexpr float kNoSurface = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinite = std::numeric_limits<float>::infinity();

// A band of surface, columns 40 to 279: its bounds rise tenfold each 60 columns, from 1e-5.
PictureErrors band() {
  const auto count = static_cast<std::size_t>(kSize.x * kSize.y);
  PictureErrors errors;
  errors.size = kSize;
  for (std::vector<float>* const image :
       {&errors.depthMm, &errors.normalDegrees, &errors.curvature, &errors.relativeCurvature, &errors.light,
        &errors.normalNoiseDegrees, &errors.curvatureNoise})
    image->assign(count, kNoSurface);
  errors.certain.assign(count, 1);
  errors.meanIrradiance = 2.0;
  for (int y = 60; y < 180; ++y)
    for (int x = 40; x < 280; ++x) {
      const auto i = static_cast<std::size_t>(y * kSize.x + x);
      const auto bound = static_cast<float>(1e-5 * std::pow(10.0, (x - 40) / 60.0));
      errors.depthMm[i] = errors.normalDegrees[i] = errors.curvature[i] = errors.relativeCurvature[i] = bound;
      errors.light[i] = bound;
    }
  return errors;
}

render::ColorImage grey() {
  render::ColorImage image{kSize, {}, false};
  for (int i = 0; i < kSize.x * kSize.y; ++i) image.rgba.insert(image.rgba.end(), {120, 120, 120, 255});
  return image;
}

std::array<int, 3> colorAt(const render::ColorImage& image, int x, int y) {
  const std::uint8_t* const p = &image.rgba[4 * static_cast<std::size_t>(y * kSize.x + x)];
  return {p[0], p[1], p[2]};
}

bool isIn(const std::optional<render::Tile>& tile, int x, int y) {
  const int fromBelow = kSize.y - 1 - y;
  return tile && x >= tile->origin.x && x < tile->origin.x + tile->size.x && fromBelow >= tile->origin.y &&
         fromBelow < tile->origin.y + tile->size.y;
}

std::optional<render::Tile> paint(const PictureErrors& errors, const std::string& overlay,
                                  const std::string& limits, render::ColorImage& image) {
  return paintErrors(errors,
                     parseOverlay(overlay, limits.empty() ? std::vector<Limit>{} : parseErrorTarget(limits)),
                     0.5, scene::LegendCorner::automatic, {}, image);
}

TEST(ErrorOverlay, PixelsAboveTheLimitAreHatchedAndOthersUntouched) {
  for (const char* const overlay : {"limits", "depth"}) {
    render::ColorImage plain = grey(), limited = grey();
    const std::optional<render::Tile> without =
        std::string(overlay) == "depth" ? paint(band(), overlay, "", plain) : std::nullopt;
    const std::optional<render::Tile> with = paint(band(), overlay, "depth=0.00101mm", limited);
    ASSERT_TRUE(with.has_value());
    int dark = 0, bright = 0;
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        if (isIn(with, x, y) || isIn(without, x, y)) continue;
        const bool above = y >= 60 && y < 180 && x > 160 && x < 280;  // 1.01e-3 mm between columns
        const render::Hatch line = render::hatchAt({x, y}, 1);
        if (above && line != render::Hatch::none) {
          const auto color = colorAt(limited, x, y);
          EXPECT_EQ(color[0], color[1]);
          EXPECT_TRUE(line == render::Hatch::dark ? color[0] < 30 : color[0] > 230);
          ++(line == render::Hatch::dark ? dark : bright);
        } else {
          EXPECT_EQ(colorAt(limited, x, y), colorAt(plain, x, y)) << overlay << " " << x << ", " << y;
        }
      }
    EXPECT_GT(dark, 1700) << overlay;
    EXPECT_GT(bright, 1700) << overlay;
  }
}

TEST(ErrorOverlay, LimitsAreInTheirOwnUnits) {
  const auto firstColumn = [](const std::string& overlay, const std::string& limits) {
    const std::vector<std::uint8_t> hatched =
        hatchedPixels(band(), parseOverlay(overlay, parseErrorTarget(limits)), 0.5);
    for (int x = 0; x < kSize.x; ++x)
      if (hatched[static_cast<std::size_t>(100 * kSize.x + x)]) return x;
    return -1;
  };
  EXPECT_EQ(firstColumn("limits", "depth=0.00101mm"), 161);
  EXPECT_EQ(firstColumn("limits", "depth=0.00202vox"), 161);  // of 0.5 mm
  EXPECT_EQ(firstColumn("limits", "normal=0.00101deg"), 161);
  EXPECT_EQ(firstColumn("limits", "curvature=0.101%"), 161);
  EXPECT_EQ(firstColumn("limits", "light=0.0505%"), 161);                        // of a mean of 2
  EXPECT_EQ(firstColumn("normal", "normal=0.00101deg,depth=0.0000101mm"), 161);  // its own alone
  EXPECT_EQ(firstColumn("limits", "normal=0.00101deg,depth=0.000101mm"), 101);
}

TEST(ErrorOverlay, WhatIsNotCertainIsHatchedWithoutALimit) {
  PictureErrors errors = band();
  for (int y = 100; y < 110; ++y)
    for (int x = 50; x < 60; ++x) {
      const auto i = static_cast<std::size_t>(y * kSize.x + x);
      errors.certain[i] = 0;
      errors.depthMm[i] = kInfinite;
    }
  render::ColorImage image = grey();
  paint(errors, "depth", "", image);
  std::set<std::array<int, 3>> colors;
  for (int x = 50; x < 60; ++x) colors.insert(colorAt(image, x, 105));
  EXPECT_EQ(colors.size(), 3u);  // dark, bright, grey
}

// Cividis gets lighter with the bound; what shows no surface stays.
TEST(ErrorOverlay, ColoursFollowTheLogarithm) {
  render::ColorImage image = grey();
  const auto legend = paint(band(), "depth", "", image);
  ASSERT_TRUE(legend.has_value());
  EXPECT_FALSE(isIn(legend, 160, 120));
  const auto light = [&](int x) { return colorAt(image, x, 120)[0] + colorAt(image, x, 120)[1]; };
  for (int x = 60; x < 260; x += 20) EXPECT_LT(light(x - 20 + 5), light(x + 5)) << x;
  EXPECT_EQ(colorAt(image, 20, 120), colorAt(grey(), 20, 120));
}

// Noise turns normals by 3 degrees and bends the surface by 0.2 / mm where arithmetic does nearly nothing:
// each overlay has the numbers of its own kind.
TEST(ErrorOverlay, NoiseAndArithmeticAreKindsOfTheirOwn) {
  PictureErrors errors = band();
  for (std::size_t i = 0; i < errors.depthMm.size(); ++i)
    if (!std::isnan(errors.depthMm[i])) {
      errors.normalNoiseDegrees[i] = 3.0f;
      errors.curvatureNoise[i] = 0.2f;
    }
  EXPECT_EQ(&(errors.*errorImage(ErrorImage::normalNoise).bounds), &errors.normalNoiseDegrees);
  EXPECT_EQ(&(errors.*errorImage(ErrorImage::kappaNoise).bounds), &errors.curvatureNoise);
  for (const char* overlay : {"normal_noise", "kappa_noise"}) {
    render::ColorImage image = grey();
    ASSERT_TRUE(paint(errors, overlay, "normal=0.001deg,curvature=1%", image).has_value());
    EXPECT_EQ(colorAt(image, 60, 120), colorAt(image, 240, 120)) << overlay;  // even, and not hatched
    EXPECT_NE(colorAt(image, 60, 120), colorAt(grey(), 60, 120)) << overlay;
  }
}

TEST(ErrorOverlay, WhatCannotBeAskedForIsSaid) {
  EXPECT_THROW(parseOverlay("hue", {}), base::Error);
  EXPECT_THROW(parseOverlay("limits", {}), base::Error);
  EXPECT_THROW(parseOverlay("limits", parseErrorTarget("missed=1%")), base::Error);
  EXPECT_FALSE(parseOverlay("", {}).asked);
  PictureErrors errors = band();
  errors.light.clear();
  render::ColorImage image = grey();
  EXPECT_THROW(paint(errors, "light", "", image), base::Error);
}

}  // namespace
}  // namespace isolux::app
