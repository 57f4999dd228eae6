// Which rows of the settings panel are seen, and when they come and go.
#include "tests/support/ui/window_fixture.h"

#include <map>
#include <random>

#include <QCheckBox>
#include <QCoreApplication>
#include <QEvent>
#include <QScrollArea>
#include <QSlider>
#include <QStyle>

#include "ui/editors/setting_editor.h"
#include "ui/panels/settings_panel.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::test {
namespace {

class SettingsRowsTest : public testing::Test {
 protected:
  SettingsRowsTest() { open(panel_); }

  static void open(ui::SettingsPanel& panel) {
    panel.resize(360, 900);
    panel.show();
  }
  // The rows that are seen, and where they stand in the panel.
  static std::map<std::string, int> rows(ui::SettingsPanel& panel) {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    QCoreApplication::processEvents();
    std::map<std::string, int> places;
    QWidget* content = panel.findChild<QScrollArea*>()->widget();
    for (const scene::Setting& setting : scene::settings()) {
      QWidget* editor = panel.editor(QString::fromStdString(setting.path));
      if (editor == nullptr || !editor->isVisible()) continue;
      EXPECT_GE(editor->height(), editor->minimumSizeHint().height()) << setting.path;
      places[setting.path] = editor->mapTo(content, QPoint(0, 0)).y();
    }
    return places;
  }
  void show(const scene::Scene& scene) {
    scene_ = scene;
    panel_.setScene(scene, scene);
  }

  scene::Scene scene_;
  ui::SettingsPanel panel_;
};

TEST_F(SettingsRowsTest, EveryLookHasTheRowsOfAFreshStartHoweverOftenLooksChange) {
  const auto looks = static_cast<int>(scene::setting("look.mode").choices.size());
  std::vector<std::map<std::string, int>> fresh;
  for (int look = 0; look < looks; ++look) {
    ui::SettingsPanel panel;
    open(panel);
    scene::Scene scene;
    scene.look.mode = static_cast<scene::LookMode>(look);
    panel.setScene(scene, scene);
    fresh.push_back(rows(panel));
  }
  scene::Scene scene;
  const auto check = [&](int look) {
    scene.look.mode = static_cast<scene::LookMode>(look);
    show(scene);
    EXPECT_EQ(rows(panel_), fresh[static_cast<std::size_t>(look)]) << "look " << look;
  };
  for (int look = 0; look < looks; ++look) check(look);
  for (int look = looks - 1; look >= 0; --look) check(look);
  std::mt19937 random(1);
  for (int i = 0; i < looks; ++i) check(static_cast<int>(random() % static_cast<unsigned>(looks)));
}

TEST_F(SettingsRowsTest, EndsThatAPictureFoundAreShownBesideAutoAndKeptWhenItGoesOff) {
  QObject::connect(&panel_, &ui::SettingsPanel::edited, [this](const ui::Edit& edit) { show(edit.scene); });
  scene_.look.mode = scene::LookMode::kappa1;
  show(scene_);
  ui::SettingEditor* editor = panel_.editor("look.range_high");
  EXPECT_FALSE(editor->valueWidget()->isVisibleTo(editor));
  render::FrameReport report;
  report.found["look.range_high"] = 0.375;
  panel_.setReport(report, {});
  EXPECT_TRUE(editor->valueWidget()->isVisibleTo(editor));
  EXPECT_EQ(editor->valueWidget()->value(), 0.375);
  EXPECT_FALSE(scene_.look.rangeHigh.has_value());
  editor->findChild<QCheckBox*>()->click();
  EXPECT_EQ(scene_.look.rangeHigh, 0.375);
  editor->findChild<QCheckBox*>()->click();
  panel_.setReport({}, {});
  EXPECT_FALSE(editor->valueWidget()->isVisibleTo(editor));
}

TEST_F(SettingsRowsTest, NoRowMovesWhileAValueIsDraggedOrTurned) {
  QObject::connect(&panel_, &ui::SettingsPanel::edited, [this](const ui::Edit& edit) { show(edit.scene); });
  scene_.look.contours = 0.0;
  show(scene_);
  const auto before = rows(panel_);
  ASSERT_TRUE(before.contains("look.contours"));
  ASSERT_FALSE(panel_.shows("look.contour_width"));
  auto* slider = panel_.editor("look.contours")->findChild<QSlider*>();
  slider->setSliderDown(true);  // pressed
  slider->setValue(slider->maximum() / 2);
  EXPECT_GT(*scene_.look.contours, 0.0);
  EXPECT_EQ(rows(panel_), before);
  slider->setSliderDown(false);
  EXPECT_TRUE(panel_.shows("look.contour_width"));

  // Typed, or by the wheel: when it rests.
  const auto shown = rows(panel_);
  panel_.editor("look.contours")->findChild<ui::NumberSpinBox*>()->setValue(0.0);
  EXPECT_EQ(scene_.look.contours, 0.0);
  EXPECT_EQ(rows(panel_), shown);
  EXPECT_TRUE(waitUntil([&] { return !panel_.shows("look.contour_width"); }));
  EXPECT_EQ(rows(panel_), before);
}

}  // namespace
}  // namespace isolux::test
