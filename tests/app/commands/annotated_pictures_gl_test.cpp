// Pictures of `isolux render` that say what they are, and those without background.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "app/documents/session.h"
#include "base/color.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using test::runIsolux;

render::ColorImage rendered(const fs::path& folder, const std::string& name,
                            std::vector<std::string> settings) {
  std::vector<std::string> line{"render", "phantom:ball:24", "--size", "200x180", "--out", name};
  settings.insert(settings.begin(), {"camera.frames=volume", "light.setup=key"});
  for (const std::string& setting : settings) line.insert(line.end(), {"--set", setting});
  const test::RunResult result = runIsolux(line, {.folder = folder});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return test::readPng(folder / name);
}

TEST(AnnotatedPicturesGl, WordsAreWrittenOverAPictureThatStaysTheSame) {
  const fs::path folder = test::temporaryFolder();
  const auto plain = rendered(folder, "plain.png", {});
  const auto written = rendered(folder, "written.png", {"picture.letters=true", "picture.scale_bar=true"});
  EXPECT_FALSE(written.transparent);
  int changed = 0, inTheMiddle = 0;
  for (int y = 0; y < 180; ++y)
    for (int x = 0; x < 200; ++x) {
      const auto at = 4 * static_cast<std::size_t>(y * 200 + x);
      const bool differs = !std::equal(&plain.rgba[at], &plain.rgba[at + 4], &written.rgba[at]);
      changed += differs;
      inTheMiddle += differs && std::abs(x - 100) < 60 && std::abs(y - 90) < 50;
    }
  EXPECT_GT(changed, 100);
  EXPECT_EQ(inTheMiddle, 0);
  // From the session that the picture carries it is drawn again, bit for bit.
  const auto again = runIsolux({"render", "written.png", "--out", "again.png"}, {.folder = folder});
  EXPECT_EQ(again.exitCode, 0) << again.err;
  EXPECT_EQ(test::readPng(folder / "again.png").rgba, written.rgba);
}

// Over a background of one colour, in linear light (as the PNG specification says), a transparent picture is
// the opaque one.
void expectTheSameOverABackground(const std::vector<std::string>& settings, double value) {
  const fs::path folder = test::temporaryFolder();
  const std::string colour =
      std::to_string(value) + "," + std::to_string(value) + "," + std::to_string(value);
  std::vector<std::string> opaque = settings, clear = settings;
  for (auto* list : {&opaque, &clear})
    list->insert(list->end(), {"look.background_top=" + colour, "look.background_bottom=" + colour});
  clear.emplace_back("picture.transparent=true");
  const auto expected = rendered(folder, "opaque.png", opaque), seen = rendered(folder, "clear.png", clear);
  ASSERT_TRUE(seen.transparent);
  EXPECT_EQ(seen.rgba[3], 0) << "the corner is empty";
  int partly = 0, worst = 0;
  for (std::size_t i = 0; i < seen.rgba.size(); i += 4) {
    const double alpha = seen.rgba[i + 3] / 255.0;
    partly += seen.rgba[i + 3] > 0 && seen.rgba[i + 3] < 255;
    for (std::size_t c = 0; c < 3; ++c) {
      const double own = base::decodeSrgb(seen.rgba[i + c] / 255.0);
      const int composite = base::screenByte(own * alpha + value * (1.0 - alpha));
      worst = std::max(worst, std::abs(composite - static_cast<int>(expected.rgba[i + c])));
    }
  }
  EXPECT_GT(partly, 50) << "edges are anti-aliased";
  EXPECT_LE(worst, value < 0.01 ? 7 : 3) << "a step of alpha is worth more in the dark";
}

TEST(AnnotatedPicturesGl, ATransparentPictureOverABackgroundIsTheOpaqueOne) {
  expectTheSameOverABackground({}, 1.0);
  expectTheSameOverABackground({}, 0.2);
  expectTheSameOverABackground({}, 0.0);
  expectTheSameOverABackground({"isosurface.opacity=0.4", "look.specular=0"}, 1.0);
}

TEST(AnnotatedPicturesGl, NoEdgeIsDarkerThanTheSurfaceBesideIt) {
  const auto seen =
      rendered(test::temporaryFolder(), "white.png",
               {"picture.transparent=true", "look.mode=lambert", "look.ambient=1", "look.ambient_variation=0",
                "light.intensity=0", "isosurface.albedo=0.8,0.8,0.8"});
  int darkest = 255, brightest = 0;
  for (std::size_t i = 0; i < seen.rgba.size(); i += 4) {
    if (seen.rgba[i + 3] < 8) continue;
    darkest = std::min<int>(darkest, seen.rgba[i]);
    brightest = std::max<int>(brightest, seen.rgba[i]);
  }
  EXPECT_LE(brightest - darkest, 2) << "one colour to the very edge";
}

TEST(AnnotatedPicturesGl, ALegendIsDrawnOnATransparentPicture) {
  const std::vector<std::string> look{"look.mode=mean_curvature", "picture.transparent=true"};
  const fs::path folder = test::temporaryFolder();
  std::vector<std::string> without = look;
  without.emplace_back("look.legend=false");
  const auto with = rendered(folder, "with.png", look), none = rendered(folder, "without.png", without);
  const auto covered = [](const render::ColorImage& image) {
    int count = 0;
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) count += image.rgba[i] > 0;
    return count;
  };
  EXPECT_GT(covered(with), covered(none) + 500);
}

TEST(AnnotatedPicturesGl, AnExrHasAlphaWhereThePictureIsTransparent) {
  const fs::path folder = test::temporaryFolder();
  for (const std::string transparent : {"true", "false"}) {
    const auto result = runIsolux({"render", "phantom:ball:16", "--size", "40x30", "--out",
                                   transparent + ".exr", "--set", "picture.transparent=" + transparent},
                                  {.folder = folder});
    ASSERT_EQ(result.exitCode, 0) << result.err;
    const std::string content = test::contentOf(folder / (transparent + ".exr")).substr(0, 200);
    const bool hasAlpha = content.find(std::string("chlist\0", 7)) != std::string::npos &&
                          content.find(std::string("A\0\2", 3)) != std::string::npos;
    EXPECT_EQ(hasAlpha, transparent == "true");
  }
}

TEST(AnnotatedPicturesGl, LinesAreAsWideForTheirPictureAtAnySize) {
  const fs::path folder = test::temporaryFolder();
  const auto dark = [&](const char* size, const char* ratio) {
    const auto result = runIsolux(
        {"render", "phantom:ball:24", "--size", size, "--out", "lines.png", "--set", "look.contours=1",
         "--set", "look.contour_width=4", "--set", std::string("picture.pixel_ratio=") + ratio, "--set",
         "look.background_top=1,1,1", "--set", "look.background_bottom=1,1,1"},
        {.folder = folder});
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const auto image = test::readPng(folder / "lines.png");
    double count = 0.0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) count += image.rgba[i] < 20;
    return count / (static_cast<double>(image.size.x) * image.size.y);
  };
  const double once = dark("200x200", "1"), twice = dark("400x400", "2"), thin = dark("400x400", "1");
  EXPECT_NEAR(twice, once, 0.25 * once);
  EXPECT_LT(thin, 0.75 * once);
}

}  // namespace
}  // namespace isolux::app
