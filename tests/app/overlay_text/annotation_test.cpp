// What is written on finished pictures: where it stands, how long the bar is, and that it keeps off the
// legend.
#include "app/overlay_text/annotation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"
#include "tests/support/surfaces.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::app {
namespace {

constexpr std::uint8_t kGrey = 40;

render::ColorImage flat(glm::ivec2 size, bool transparent = false) {
  const auto bytes = 4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  render::ColorImage image{size, std::vector<std::uint8_t>(bytes, transparent ? 0 : kGrey), transparent};
  if (!transparent)
    for (std::size_t i = 3; i < bytes; i += 4) image.rgba[i] = 255;
  return image;
}

const std::uint8_t* pixelOf(const render::ColorImage& image, int x, int y) {
  return &image.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.x) +
                          static_cast<std::size_t>(x))];
}

// Pixels that are written on, in a part of the picture: fractions of its width and height.
int written(const render::ColorImage& image, glm::dvec2 from, glm::dvec2 to) {
  int count = 0;
  for (int y = static_cast<int>(from.y * image.size.y); y < static_cast<int>(to.y * image.size.y); ++y)
    for (int x = static_cast<int>(from.x * image.size.x); x < static_cast<int>(to.x * image.size.x); ++x) {
      const std::uint8_t* const pixel = pixelOf(image, x, y);
      count += image.transparent ? pixel[3] > 0 : pixel[0] != kGrey;
    }
  return count;
}

class AnnotationTest : public ::testing::Test {
 protected:
  void SetUp() override {
    base::Progress progress;
    scene_.source.path = "phantom:head:24";
    volume_ = volume::loadVolume(scene_.source, progress);
    scene_ = scene::resolve(scene_, volume_->facts);
  }
  render::ColorImage drawn(glm::ivec2 size, const std::optional<render::Tile>& legend = {}) {
    render::ColorImage image = flat(size, scene_.picture.transparent);
    drawAnnotation(annotationOf(scene_, *volume_, size), scene_, legend, image);
    return image;
  }

  scene::Scene scene_;
  std::shared_ptr<const volume::PreparedVolume> volume_;
};

TEST_F(AnnotationTest, NothingIsWrittenUnlessItIsAskedFor) {
  EXPECT_EQ(written(drawn({320, 240}), {0.0, 0.0}, {1.0, 1.0}), 0);
  EXPECT_TRUE(annotationOf(scene_, *volume_, {320, 240}).empty());
}

TEST_F(AnnotationTest, LettersStandAtTheEdgesAndSayWhatTheWindowSays) {
  scene_.picture.letters = true;
  const scene::EdgeLetters letters = annotationOf(scene_, *volume_, {320, 240}).letters;
  const scene::EdgeLetters windows = scene::edgeLetters(scene::frameOf(scene_.camera), volume_->volume.axes);
  EXPECT_EQ(letters.left, windows.left);
  EXPECT_EQ(letters.top, windows.top);
  EXPECT_EQ(letters.left, "R") << "the patient's right is at the left, seen from the front";
  for (const glm::ivec2& size : {glm::ivec2(320, 240), glm::ivec2(1280, 800), glm::ivec2(300, 900)}) {
    const render::ColorImage image = drawn(size);
    EXPECT_GT(written(image, {0.0, 0.4}, {0.15, 0.6}), 20) << "left";
    EXPECT_GT(written(image, {0.85, 0.4}, {1.0, 0.6}), 20) << "right";
    EXPECT_GT(written(image, {0.4, 0.0}, {0.6, 0.12}), 20) << "top";
    EXPECT_GT(written(image, {0.4, 0.88}, {0.6, 1.0}), 20) << "bottom";
    EXPECT_EQ(written(image, {0.2, 0.2}, {0.8, 0.8}), 0);
    EXPECT_EQ(written(image, {0.0, 0.0}, {0.3, 0.3}), 0) << "no words were asked for";
  }
}

TEST_F(AnnotationTest, TheBarIsAsLongAsItSays) {
  scene_.picture.scaleBar = true;
  scene_.camera.projection = scene::Projection::orthographic;
  const scene::CameraFrame frame = scene::frameOf(scene_.camera);
  for (const int height : {200, 800, 3200}) {
    const auto bar = scaleBarOf(frame, height, 0.175 * height);
    ASSERT_TRUE(bar);
    EXPECT_NEAR(bar->pixels, bar->mm * height / (2.0 * frame.halfHeight), 1e-9 * height);
    EXPECT_LE(bar->pixels, 0.175 * height);
    EXPECT_GT(bar->pixels, 0.05 * height);
  }
  const render::ColorImage image = drawn({800, 600});
  const auto bar = annotationOf(scene_, *volume_, {800, 600}).scaleBar;
  ASSERT_TRUE(bar);
  EXPECT_EQ(bar->text.find("centre"), std::string::npos) << "a length holds everywhere";
  int longest = 0;  // run of bright pixels of one row
  for (int y = 500; y < 600; ++y) {
    int run = 0;
    for (int x = 0; x < 400; ++x) {
      run = pixelOf(image, x, y)[0] > 200 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  EXPECT_NEAR(longest, bar->pixels, 1.0);
  scene_.camera.projection = scene::Projection::perspective;
  EXPECT_NE(annotationOf(scene_, *volume_, {800, 600}).scaleBar->text.find("at the centre"),
            std::string::npos);
}

TEST_F(AnnotationTest, IsovaluesAreThoseOfTheSurfacesThatAreShown) {
  scene_.picture.isovalue = true;
  scene_.surfaces.front().value = -12.5;
  ASSERT_EQ(annotationOf(scene_, *volume_, {320, 240}).values.size(), 1u);
  EXPECT_TRUE(annotationOf(scene_, *volume_, {320, 240}).values[0].text.starts_with("\u221212.5"));
  test::surfaceAt(scene_, 2).shown = true;
  test::surfaceAt(scene_, 2).value = 300.0;
  test::surfaceAt(scene_, 2).albedo = glm::dvec3(1.0, 0.0, 0.0);
  ASSERT_EQ(annotationOf(scene_, *volume_, {320, 240}).values.size(), 2u);
  const render::ColorImage image = drawn({640, 480});
  bool red = false;
  for (int y = 0; y < 100; ++y)
    for (int x = 0; x < 100; ++x) {
      const std::uint8_t* const pixel = pixelOf(image, x, y);
      red = red || (pixel[0] == 255 && pixel[1] == 0 && pixel[2] == 0);
    }
  EXPECT_TRUE(red) << "its colour stands before it";
  scene_.surfaces.front().opacity = 0.0;
  EXPECT_EQ(annotationOf(scene_, *volume_, {320, 240}).values.size(), 1u);
}

// Unasked: a picture that leaves out pieces or shows slices that nobody measured says so.
TEST_F(AnnotationTest, CaveatsAreWrittenUnasked) {
  scene_.pieces.keep = 1;
  scene_.surfaces.front().value = 300.0;
  base::Progress progress;
  ASSERT_FALSE(volume::hiddenOf(scene_, *volume_->pieces, progress).empty());
  const Caveats caveats = caveatsOf(scene_, *volume_);
  EXPECT_GT(caveats.hidden, 0u);
  EXPECT_EQ(caveats.hidden, caveats.pieces - 1);
  auto gaps = std::make_shared<volume::PreparedVolume>(*volume_);
  gaps->volume.warnings.push_back("slices are missing in 13 places; these are interpolated");
  volume_ = gaps;
  EXPECT_EQ(annotationOf(scene_, *volume_, {640, 480}).caveats,
            (std::vector<std::string>{"13 gaps interpolated", std::to_string(caveats.hidden) + " of " +
                                                                  std::to_string(caveats.pieces) +
                                                                  " pieces hidden"}));
  EXPECT_GT(written(drawn({640, 480}), {0.7, 0.85}, {1.0, 1.0}), 100) << "at the lower right";
  EXPECT_EQ(written(drawn({640, 480}), {0.0, 0.0}, {0.6, 1.0}), 0);
  scene_.picture.caveats = false;
  EXPECT_EQ(written(drawn({640, 480}), {0.0, 0.0}, {1.0, 1.0}), 0);
}

TEST_F(AnnotationTest, NothingIsWrittenOverTheLegend) {
  scene_.pieces.keep = 1;
  base::Progress progress;
  volume::hiddenOf(scene_, *volume_->pieces, progress);
  scene_.picture.letters = scene_.picture.scaleBar = scene_.picture.isovalue = true;
  const glm::ivec2 size(640, 480);
  const int all = written(drawn(size), {0.0, 0.0}, {1.0, 1.0});
  // From below: in each corner, and large ones that reach the places of letters.
  for (const render::Tile& legend : {render::Tile{{8, 8}, {120, 180}}, render::Tile{{512, 8}, {120, 180}},
                                     render::Tile{{8, 292}, {120, 180}}, render::Tile{{512, 292}, {120, 180}},
                                     render::Tile{{8, 8}, {150, 320}}, render::Tile{{300, 8}, {332, 320}}}) {
    const render::ColorImage image = drawn(size, legend);
    int over = 0;
    for (int y = size.y - legend.origin.y - legend.size.y; y < size.y - legend.origin.y; ++y)
      for (int x = legend.origin.x; x < legend.origin.x + legend.size.x; ++x)
        over += pixelOf(image, x, y)[0] != kGrey;
    EXPECT_EQ(over, 0) << legend.origin.x << ", " << legend.origin.y;
    EXPECT_NEAR(written(image, {0.0, 0.0}, {1.0, 1.0}), all, 0.02 * all) << "all of it stands somewhere";
  }
}

TEST_F(AnnotationTest, InkIsDarkOnABrightBackground) {
  scene_.picture.letters = true;
  scene_.look.backgroundTop = scene_.look.backgroundBottom = glm::dvec3(1.0);
  const render::ColorImage image = drawn({320, 240});
  int darkest = 255;
  for (int y = 100; y < 140; ++y)
    for (int x = 0; x < 40; ++x) darkest = std::min<int>(darkest, pixelOf(image, x, y)[0]);
  EXPECT_LT(darkest, 20);
}

TEST_F(AnnotationTest, ATransparentPictureIsCoveredWhereSomethingIsWrittenAndNowhereElse) {
  scene_.picture.letters = scene_.picture.transparent = true;
  const render::ColorImage image = drawn({320, 240});
  EXPECT_GT(written(image, {0.0, 0.4}, {0.15, 0.6}), 20);
  EXPECT_EQ(written(image, {0.2, 0.2}, {0.8, 0.8}), 0);
  int most = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) most = std::max<int>(most, image.rgba[i]);
  EXPECT_EQ(most, 255);
}

TEST_F(AnnotationTest, TinyPicturesHaveLettersOrNothing) {
  scene_.picture.letters = scene_.picture.scaleBar = scene_.picture.isovalue = true;
  EXPECT_EQ(written(drawn({47, 47}), {0.0, 0.0}, {1.0, 1.0}), 0);
  const render::ColorImage small = drawn({120, 120});
  EXPECT_GT(written(small, {0.0, 0.0}, {1.0, 1.0}), 0);
  EXPECT_EQ(written(small, {0.0, 0.0}, {0.3, 0.3}), 0);
  drawn({1, 2000});
}

}  // namespace
}  // namespace isolux::app
