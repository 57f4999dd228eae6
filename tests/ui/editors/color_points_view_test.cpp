// The editor of one-dimensional transfer functions: mouse, keys, and what reaches the scene.
#include "ui/editors/color_points_view.h"

#include <QCheckBox>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include "app/documents/history.h"
#include "scene/color_maps.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/editors/setting_editor.h"
#include "ui/panels/settings_panel.h"
#include "ui/widgets/color_button.h"

namespace isolux::test {

namespace {

using Points = std::vector<scene::ColorPoint>;

const Points kBarPoints = {
    {0.0, {0.0, 0.0, 1.0}}, {0.25, {0.0, 1.0, 0.0}}, {0.75, {1.0, 1.0, 0.0}}, {1.0, {1.0, 0.0, 0.0}}};

class ColorPointsEditorTest : public testing::Test {
 protected:
  void SetUp() override {
    scene::Scene scene;
    scene.look.mode = scene::LookMode::mean_curvature;
    scene.look.colormapPoints = kBarPoints;
    history_.reset(scene);
    panel_.resize(350, 900);
    panel_.show();
    show();
    // As the window and its document do it.
    QObject::connect(&panel_, &ui::SettingsPanel::edited, [this](const ui::Edit& edit) {
      history_.edit(edit.scene, edit.name.toStdString(), edit.mergeKey.toStdString());
      show();
    });
    QObject::connect(&panel_, &ui::SettingsPanel::dragEnded, [this] { history_.seal(); });
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel_, 120000));
  }
  void show() { panel_.setScene(history_.scene(), history_.scene()); }
  ui::PointsEditor* editor() { return panel_.editor("look.colormap_points")->findChild<ui::PointsEditor*>(); }
  ui::PointsView* view() { return editor()->view(); }
  const Points& points() { return *history_.scene().look.colormapPoints; }
  QPoint at(double position) { return view()->positionOf({position, 0.0}).toPoint(); }

  app::History history_;
  ui::SettingsPanel panel_;
};

}  // namespace

TEST_F(ColorPointsEditorTest, AClickAddsAPointInTheColourOfTheBarInOneStep) {
  QTest::mouseClick(view(), Qt::LeftButton, Qt::NoModifier, at(0.5));
  ASSERT_EQ(points().size(), 5U);
  EXPECT_NEAR(points()[2].position, 0.5, 0.01);
  EXPECT_EQ(view()->selected(), 2);
  const glm::dvec3 expected = scene::colorOfPoints(kBarPoints, points()[2].position);
  EXPECT_NEAR(points()[2].color.r, expected.r, 0.01);
  EXPECT_NEAR(points()[2].color.g, expected.g, 0.01);
  history_.undo();
  EXPECT_EQ(points(), kBarPoints);
  EXPECT_FALSE(history_.canUndo());
}

TEST_F(ColorPointsEditorTest, ADragIsOneStepAndEndsAtTheNeighbour) {
  drag(view(), at(0.25), at(0.4));
  EXPECT_NEAR(points()[1].position, 0.4, 0.02);
  EXPECT_EQ(points()[1].color, kBarPoints[1].color);
  drag(view(), at(points()[1].position), at(0.9));
  EXPECT_DOUBLE_EQ(points()[1].position, 0.75);
  history_.undo();
  history_.undo();
  EXPECT_EQ(points(), kBarPoints);
  EXPECT_FALSE(history_.canUndo());
}

TEST_F(ColorPointsEditorTest, KeysReachEverything) {
  view()->setFocus(Qt::TabFocusReason);
  EXPECT_EQ(view()->selected(), 0);
  QTest::keyClick(view(), Qt::Key_Tab);
  EXPECT_EQ(view()->selected(), 1);
  EXPECT_TRUE(view()->accessibleDescription().contains("0.25"));
  QTest::keyClick(view(), Qt::Key_Right);
  QTest::keyClick(view(), Qt::Key_Right);
  EXPECT_NEAR(points()[1].position, 0.27, 1e-9);
  QTest::keyClick(view(), Qt::Key_Left);
  EXPECT_NEAR(points()[1].position, 0.26, 1e-9);
  QTest::keyClick(view(), Qt::Key_Insert);  // between this point and the next
  ASSERT_EQ(points().size(), 5U);
  EXPECT_EQ(view()->selected(), 2);
  EXPECT_NEAR(points()[2].position, 0.505, 1e-9);
  QTest::keyClick(view(), Qt::Key_Tab, Qt::ShiftModifier);
  EXPECT_EQ(view()->selected(), 1);
  for (int i = 0; i < 5; ++i) QTest::keyClick(view(), Qt::Key_Delete);
  EXPECT_EQ(points().size(), 2U);
  EXPECT_FALSE(editor()->removeButton()->isEnabled());
  view()->select(0);
  QTest::keyClick(view(), Qt::Key_Tab);
  QTest::keyClick(view(), Qt::Key_Tab);  // leaves the bar behind its last point
  EXPECT_FALSE(view()->hasFocus());
}

TEST_F(ColorPointsEditorTest, TheColourButtonColoursTheSelectedPoint) {
  view()->select(2);
  Q_EMIT editor()->findChild<ui::ColorButton*>()->chosen({0.1, 0.2, 0.3});
  EXPECT_EQ(points()[2], (scene::ColorPoint{0.75, {0.1, 0.2, 0.3}}));
}

TEST_F(ColorPointsEditorTest, AnOwnFunctionStartsFromTheAutomaticOne) {
  scene::Scene scene = history_.scene();
  scene.look.colormapPoints.reset();
  scene.look.colormap = scene::ColorMap::inferno;
  scene.look.accessibility = 0.5;
  history_.reset(scene);
  show();
  panel_.editor("look.colormap_points")->findChild<QCheckBox*>()->click();
  EXPECT_EQ(points(), scene::automaticColorPoints(scene.look));
  panel_.editor("look.accessibility_points")->findChild<QCheckBox*>()->click();
  EXPECT_EQ(history_.scene().look.accessibilityPoints, scene::automaticAccessibilityPoints());
}

}  // namespace isolux::test
