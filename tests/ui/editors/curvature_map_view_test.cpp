// The editor of the (kappa1, kappa2) colour map: mouse, keys, and what reaches the scene.
#include "ui/editors/curvature_map_view.h"

#include <QCheckBox>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

#include "app/documents/history.h"
#include "scene/curvature_map.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/editors/setting_editor.h"
#include "ui/panels/settings_panel.h"
#include "ui/widgets/color_button.h"

namespace isolux::test {

namespace {

// A flat middle, a cap, a ridge, a saddle, a valley and a cup.
const std::vector<scene::CurvaturePoint> kPoints = {
    {0.0, 0.0, {0.82, 0.82, 0.80}},  {1.0, 1.0, {0.85, 0.30, 0.12}},  {1.0, 0.0, {0.95, 0.72, 0.25}},
    {1.0, -1.0, {0.45, 0.72, 0.35}}, {0.0, -1.0, {0.20, 0.50, 0.72}}, {-1.0, -1.0, {0.30, 0.16, 0.52}}};

class CurvatureMapEditorTest : public testing::Test {
 protected:
  void SetUp() override {
    scene::Scene scene;
    scene.look.mode = scene::LookMode::curvature_2d;
    scene.look.curvaturePoints = kPoints;
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
  ui::PointsEditor* editor() {
    return panel_.editor("look.curvature_points")->findChild<ui::PointsEditor*>();
  }
  ui::PointsView* view() { return editor()->view(); }
  const std::vector<scene::CurvaturePoint>& points() { return *history_.scene().look.curvaturePoints; }
  QPoint at(glm::dvec2 kappa) { return view()->positionOf(kappa).toPoint(); }

  app::History history_;
  ui::SettingsPanel panel_;
};

}  // namespace

TEST_F(CurvatureMapEditorTest, PixelsAndKappasAreInverseAndTheSquareHasASize) {
  const glm::dvec2 kappa = view()->placeAt(view()->positionOf({0.3, -0.7}));
  EXPECT_NEAR(kappa.x, 0.3, 1e-12);
  EXPECT_NEAR(kappa.y, -0.7, 1e-12);
  EXPECT_GT(view()->positionOf({1.0, 0.0}).x() - view()->positionOf({-1.0, 0.0}).x(), 120.0);
  EXPECT_LT(view()->positionOf({0.0, 1.0}).y(), view()->positionOf({0.0, -1.0}).y());  // kappa2 points up
}

TEST_F(CurvatureMapEditorTest, ADragIsOneStepAndStaysWhereCurvaturesCanBe) {
  const auto before = points();
  drag(view(), at({1.0, 0.0}), at({0.5, -0.5}));
  EXPECT_NEAR(points()[2].kappa1, 0.5, 0.03);
  EXPECT_NEAR(points()[2].kappa2, -0.5, 0.03);
  EXPECT_EQ(view()->selected(), 2);
  drag(view(), at({points()[2].kappa1, points()[2].kappa2}), at({-0.6, 0.6}));  // above the diagonal
  EXPECT_NEAR(points()[2].kappa1, 0.0, 0.03);
  EXPECT_DOUBLE_EQ(points()[2].kappa1, points()[2].kappa2);
  history_.undo();
  history_.undo();
  EXPECT_EQ(points(), before);
  EXPECT_FALSE(history_.canUndo());
}

TEST_F(CurvatureMapEditorTest, DoubleClickAddsAPointInTheColourOfTheMap) {
  const auto before = points();
  const glm::dvec2 place = view()->placeAt(at({0.4, -0.4}));
  QTest::mouseDClick(view(), Qt::LeftButton, Qt::NoModifier, at({0.4, -0.4}));
  ASSERT_EQ(points().size(), before.size() + 1);
  EXPECT_NEAR(points().back().kappa1, place.x, 1e-3);
  EXPECT_EQ(view()->selected(), static_cast<int>(before.size()));
  const glm::dvec3 expected = scene::curvatureColor(before, {points().back().kappa1, points().back().kappa2});
  EXPECT_NEAR(points().back().color.g, expected.g, 1e-12);
  QTest::keyClick(view(), Qt::Key_Delete);
  EXPECT_EQ(points(), before);
}

TEST_F(CurvatureMapEditorTest, OnePointAlwaysStays) {
  for (int i = 0; i < 10; ++i) QTest::keyClick(view(), Qt::Key_Delete);
  EXPECT_EQ(points().size(), 1U);
  EXPECT_FALSE(editor()->removeButton()->isEnabled());
}

TEST_F(CurvatureMapEditorTest, ArrowKeysAndTheColourButtonChangeTheSelectedPoint) {
  view()->select(3);  // the saddle, (1, -1)
  QTest::keyClick(view(), Qt::Key_Left);
  QTest::keyClick(view(), Qt::Key_Up);
  EXPECT_NEAR(points()[3].kappa1, 0.98, 1e-9);
  EXPECT_NEAR(points()[3].kappa2, -0.98, 1e-9);
  Q_EMIT editor()->findChild<ui::ColorButton*>()->chosen({0.1, 0.2, 0.3});
  EXPECT_EQ(points()[3].color, glm::dvec3(0.1, 0.2, 0.3));
  history_.undo();  // keys and colours in a row are one gesture until it pauses
  EXPECT_EQ(points(), kPoints);
}

TEST_F(CurvatureMapEditorTest, APointFromASessionAboveTheDiagonalKeepsItsPlaceWhenOnlyItsColourChanges) {
  scene::Scene scene = history_.scene();
  scene.look.curvaturePoints = {{-0.5, 0.5, glm::dvec3(0.5)}};
  history_.reset(scene);
  show();
  Q_EMIT editor()->findChild<ui::ColorButton*>()->chosen({1.0, 0.0, 0.0});
  EXPECT_EQ(points()[0], (scene::CurvaturePoint{-0.5, 0.5, {1.0, 0.0, 0.0}}));
}

TEST_F(CurvatureMapEditorTest, AnOwnMapStartsFromTheAutomaticOne) {
  scene::Scene scene = history_.scene();
  scene.look.curvaturePoints.reset();
  history_.reset(scene);
  show();
  ui::SettingEditor* own = panel_.editor("look.curvature_points");
  own->findChild<QCheckBox*>()->click();
  EXPECT_EQ(points(), scene::automaticCurvaturePoints());
}

}  // namespace isolux::test
