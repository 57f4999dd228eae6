// The window's words for directions: of anatomy only where the file states them.
#include "tests/support/ui/window_fixture.h"

#include <QAction>
#include <QLabel>
#include <QStatusBar>

#include "ui/panels/volume_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/wrapped_text.h"

namespace isolux::test {
namespace {

class OrientationTest : public WindowTest {
 protected:
  QAction* leftView() {
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->shortcut() == QKeySequence("3")) return action;
    return nullptr;
  }
  QString axes() {
    for (const ui::WrappedText* text : window_->panel<ui::VolumePanel>()->findChildren<ui::WrappedText*>())
      if (text->text().startsWith("x →")) return text->text();
    return {};
  }
  QString pointed(glm::dvec3 worldMm) {
    app::Pick pick{};
    pick.worldMm = worldMm;
    Q_EMIT window_->viewport()->pointed(pick);
    return window_->statusBar()->findChild<QLabel*>()->text();
  }
};

TEST_F(OrientationTest, AFileThatStatesNoneHasXYZ) {
  ASSERT_TRUE(load(*window_, writeBall(16)));
  EXPECT_EQ(leftView()->iconText(), "+X");
  EXPECT_EQ(leftView()->text(), "From +X");
  EXPECT_EQ(leftView()->toolTip(), "From +X (3)");
  EXPECT_EQ(axes(), "x → +X, y → +Y, z → +Z\norientation not stated");
  EXPECT_TRUE(pointed({1.0, -2.0, 3.0}).startsWith("X 1.0   Y −2.0   Z 3.0 mm"))
      << pointed({1.0, -2.0, 3.0}).toStdString();
}

TEST_F(OrientationTest, AHeadHasItsSides) {
  ASSERT_TRUE(load(*window_, "phantom:head:24"));
  EXPECT_EQ(leftView()->iconText(), "L");
  EXPECT_EQ(leftView()->text(), "Left");
  EXPECT_EQ(leftView()->toolTip(), "From left (3)");
  EXPECT_EQ(axes(), "x → L, y → P, z → S");
  EXPECT_TRUE(pointed({1.0, -2.0, 3.0}).startsWith("L 1.0   A 2.0   S 3.0 mm"));
}

}  // namespace
}  // namespace isolux::test
