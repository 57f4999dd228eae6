// Slices of a label map: the labels of the nearest voxels, in their colours.
#include <cmath>

#include <gtest/gtest.h>

#include "app/slices/slice_content.h"
#include "app/slices/slice_labels.h"
#include "app/slices/slice_picture.h"
#include "base/color.h"
#include "scene/rules/automatic.h"
#include "tests/support/label_volumes.h"

namespace isolux::test {
namespace {

TEST(LabelSlice, ShowsTheLabelsOfTheNearestVoxels) {
  const auto volume = loadedLabels(threeLabels(), "1,3");
  const volume::Grid labels = threeLabels();
  base::Progress progress;
  const volume::SlicePlane plane{{-2.0, 3.3, 18.4}, {0.31, 0.0, 0.0}, {0.0, 0.31, 0.0}, {180, 130}};
  const scene::Scene scene = scene::resolve(scene::Scene{}, volume->facts);
  app::SliceContent content = app::sliceContent(*volume, scene, plane, progress);
  ASSERT_FALSE(content.surfaces.empty());
  EXPECT_FALSE(content.surfaces[0].curves.curves.empty()) << "the surface of the shown labels";
  content.surfaces.clear();
  const render::ColorImage picture =
      app::slicePicture(content, scene.slice, volume->grid().geometry(), progress);
  int shown = 0, hidden = 0;
  for (int y = 0; y < plane.size.y; ++y)
    for (int x = 0; x < plane.size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y * plane.size.x + x);
      const glm::dvec3 at = plane.at({x, y});
      const float value = content.values.values[i];
      if (at.x < 0.0 || at.x > 47.0 || at.y > 39.0) {
        ASSERT_TRUE(std::isnan(value)) << x << ' ' << y;
        continue;
      }
      const double label = labels.value(glm::ivec3(glm::round(at)));
      ASSERT_EQ(value, label) << x << ' ' << y;
      const glm::vec3 color = volume::labelColor(nullptr, static_cast<int>(label));
      const std::uint8_t red = label == 0.0   ? 0
                               : label == 2.0 ? 70
                                              : base::screenByte(static_cast<double>(color.r));
      ASSERT_EQ(picture.rgba[4 * i], red) << x << ' ' << y;
      (label == 2.0 ? hidden : shown) += label != 0.0;
    }
  EXPECT_GT(shown, 500);
  EXPECT_GT(hidden, 500);
  const app::SliceWords words = app::wordsOf(content, plane, scene.slice, volume->volume);
  EXPECT_EQ(words.window, "labels of the nearest voxels");
  EXPECT_TRUE(words.key.empty());
}

}  // namespace
}  // namespace isolux::test
