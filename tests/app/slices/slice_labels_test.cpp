// What is written on slices stands clear of itself at every size.
#include "app/slices/slice_labels.h"

#include <gtest/gtest.h>

#include "base/color.h"
#include "scene/rules/automatic.h"
#include "tests/support/surfaces.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::test {
namespace {

app::SliceWords words(bool oblique) {
  app::SliceWords words;
  words.letters =
      oblique ? app::SliceLetters{"+X−Y", "−X+Y", "SA", "IP"} : app::SliceLetters{"R", "L", "A", "P"};
  words.place = oblique ? "oblique\nthrough −112.25, 34.5, −7.13 mm\nacross −0.71, 0.7, 0.02 mm"
                        : "sagittal · R 112.25 mm";
  words.convention = oblique ? "orientation not stated" : "radiological";
  words.window = "level 1040 · width 2233 HU · maximum of 12.5 mm";
  words.ruler = {50.0, 0.0, "50 mm"};
  words.key = {{"−300 HU", {1.0, 0.8, 0.6}}, {"1240.5 HU", {0.2, 0.5, 1.0}}};
  return words;
}

TEST(SliceLabels, StandClearOfEachOtherAndInThePicture) {
  for (const bool oblique : {false, true})
    for (const double ratio : {1.0, 2.0})
      for (const glm::ivec2& base : {glm::ivec2(160, 170), glm::ivec2(184, 200), glm::ivec2(260, 178),
                                     glm::ivec2(452, 278), glm::ivec2(900, 700)}) {
        const glm::ivec2 size = glm::ivec2(ratio * glm::dvec2(base));
        SCOPED_TRACE(std::to_string(size.x) + "x" + std::to_string(size.y) + (oblique ? " oblique" : ""));
        app::SliceWords all = words(oblique);
        all.ruler.pixels = 0.15 * size.x;
        const app::SliceWordPlaces places = app::placesOf(all, size, ratio);
        ASSERT_EQ(places.letters.size(), 4u);
        std::vector<app::WrittenText> texts = places.texts;
        texts.insert(texts.end(), places.letters.begin(), places.letters.end());
        texts.insert(texts.end(), places.key.begin(), places.key.end());
        EXPECT_TRUE(places.key.size() == 2 || (places.key.empty() && base.x < 300)) << "where there is room";
        for (std::size_t i = 0; i < texts.size(); ++i) {
          const app::TextBox& box = texts[i].box;
          EXPECT_TRUE(box.low.x >= 0.0 && box.low.y >= 0.0 && box.high().x <= size.x &&
                      box.high().y <= size.y)
              << texts[i].text;
          for (std::size_t j = 0; j < i; ++j)
            EXPECT_FALSE(app::meet(box, texts[j].box, 0.5)) << texts[i].text << " and " << texts[j].text;
        }
        // In the strips that lines of other planes leave to them.
        const glm::dvec2 border = app::letterBorder(all.letters, size, ratio);
        EXPECT_LT(places.letters[0].box.high().x, border.x);
        EXPECT_GT(places.letters[1].box.low.x, size.x - border.x);
        EXPECT_LT(places.letters[2].box.high().y, border.y);
        EXPECT_GT(places.letters[3].box.low.y, size.y - border.y);
      }
}

TEST(SliceLabels, StandInTheMiddleOfTheirEdgesWhereThereIsRoom) {
  const glm::ivec2 size(900, 700);
  app::SliceWords few = words(false);
  few.window = "level 40 · width 400 HU";
  const auto places = app::placesOf(few, size);
  for (const std::size_t i : {0u, 1u}) {
    const app::TextBox& box = places.letters[i].box;
    EXPECT_NEAR(box.low.y + box.high().y, size.y, 2.0);
  }
  for (const std::size_t i : {2u, 3u}) {
    const app::TextBox& box = places.letters[i].box;
    EXPECT_NEAR(box.low.x + box.high().x, size.x, 2.0);
  }
}

TEST(SliceLabels, TheKeyHasTheColoursOfTheCurves) {
  render::ColorImage image{{400, 300}, std::vector<std::uint8_t>(std::size_t{4} * 400 * 300, 90)};
  const app::SliceWords all = words(false);
  app::drawWords(all, image);
  const auto places = app::placesOf(all, image.size);
  ASSERT_EQ(places.key.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const app::TextBox& box = places.key[i].box;
    EXPECT_EQ(places.key[i].text, all.key[i].text);
    EXPECT_GT(box.low.x, 200.0) << "at the upper right";
    EXPECT_LT(box.high().y, 100.0);
    const glm::ivec2 middle(box.low + 0.5 * box.size.y);
    const std::uint8_t* const pixel = &image.rgba[4 * static_cast<std::size_t>(middle.y * 400 + middle.x)];
    for (int c = 0; c < 3; ++c) EXPECT_EQ(pixel[c], base::screenByte(all.key[i].color[c]));
  }
}

TEST(SliceLabels, TheConventionIsSaidWhereLeftAndRightAreSeen) {
  base::Progress progress;
  scene::Scene scene;
  scene.source.path = "phantom:head:24";
  const auto prepared = volume::loadVolume(scene.source, progress);
  scene = scene::resolve(scene, prepared->facts);
  test::surfaceAt(scene, 1).shown = true;
  test::surfaceAt(scene, 1).value = -300.0;
  const auto wordsOn = [&](volume::SliceDirection direction) {
    const volume::GridGeometry& geometry = prepared->grid().geometry();
    const volume::SliceFrame frame =
        volume::sliceFrame(direction, prepared->volume.axes, scene.slice.convention);
    const volume::SlicePlane plane =
        volume::fittedSlice(geometry, frame, app::slicePosition(scene, geometry), {80, 60});
    return app::wordsOf(app::sliceContent(*prepared, scene, plane, progress), plane, scene.slice,
                        prepared->volume);
  };
  EXPECT_EQ(wordsOn(volume::SliceDirection::axial).convention, "radiological");
  EXPECT_EQ(wordsOn(volume::SliceDirection::coronal).convention, "radiological");
  const app::SliceWords sagittal = wordsOn(volume::SliceDirection::sagittal);
  EXPECT_EQ(sagittal.convention, "");
  ASSERT_EQ(sagittal.key.size(), 2u);
  EXPECT_EQ(sagittal.key[1].text, "−300 HU");
  scene.slice.contourWidth = 0.0;
  EXPECT_TRUE(wordsOn(volume::SliceDirection::axial).key.empty()) << "no curves";
}

}  // namespace
}  // namespace isolux::test
