// Texts that give way leave out whole parts and words, never half a number.
#include "ui/editors/elided_label.h"

#include <gtest/gtest.h>

namespace isolux::test {
namespace {

TEST(ElidedLabelTest, LeavesOutPartsThenWords) {
  const QLabel label;
  const QFontMetrics metrics(label.font());
  const QString text = "L 12.3   A 2.0   S 3.5 mm      voxel 1.0, 2.0, 3.0      value 721 HU";
  const auto fitting = [&](const QString& shown) {
    return ui::textThatFits(text, metrics, metrics.horizontalAdvance(shown));
  };
  EXPECT_EQ(fitting(text), text);
  EXPECT_EQ(fitting("L 12.3   A 2.0   S 3.5 mm      voxel 1.0, 2.0, 3.0      valu"),
            "L 12.3   A 2.0   S 3.5 mm      voxel 1.0, 2.0, 3.0 …");
  EXPECT_EQ(fitting("L 12.3   A 2."), "L 12.3 …");
  EXPECT_EQ(ui::textThatFits("Light: 57 % · 264 thousand rays/s", metrics,
                             metrics.horizontalAdvance("Light: 57 % · 26")),
            "Light: 57 % …");
  EXPECT_EQ(ui::textThatFits("Overview of everything", metrics, metrics.horizontalAdvance("Overview of eve")),
            "Overview of …");
  for (int width = 0; width <= metrics.horizontalAdvance(text); ++width) {
    QString shown = ui::textThatFits(text, metrics, width);
    EXPECT_LE(metrics.horizontalAdvance(shown), width);
    if (shown == text || shown == "…" || shown.isEmpty()) continue;
    ASSERT_TRUE(shown.endsWith(" …"));
    shown.chop(2);
    EXPECT_TRUE(text.startsWith(shown) && text[shown.size()] == ' ') << shown.toStdString();
  }
}

TEST(ElidedLabelTest, GivesWayAsFarAsItMay) {
  ui::ElidedLabel label;
  label.setText("Overview: level 2 · may hide structure in 3 % of the picture");
  EXPECT_EQ(label.minimumSizeHint().width(), 0);
  label.keepFirstPart();
  const int least = label.minimumSizeHint().width();
  EXPECT_LT(least, label.sizeHint().width() / 2);
  label.resize(least, 20);
  EXPECT_EQ(label.shownText(), "Overview: level 2 …");
  label.resize(label.sizeHint());
  EXPECT_EQ(label.shownText(), label.text());
}

}  // namespace
}  // namespace isolux::test
