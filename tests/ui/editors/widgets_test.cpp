// Parts of the window on their own: numbers, colours, settings rows.
#include "tests/support/ui/window_fixture.h"

#include <cmath>
#include <set>

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QScrollArea>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include "ui/editors/setting_editor.h"
#include "ui/language/number_text.h"
#include "ui/panels/settings_panel.h"
#include "ui/widgets/color_button.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::test {

TEST(Numbers, ReadWell) {
  EXPECT_EQ(ui::numberText(300.0), "300");
  EXPECT_EQ(ui::numberText(-0.25), "-0.25");
  EXPECT_EQ(ui::numberText(1234567.0, 6), "1234567");
  EXPECT_EQ(ui::numberText(1e-20, 3), "1e-20");
  EXPECT_EQ(ui::numberText(0.1 + 0.2), "0.3");
}

TEST(NumberSpinBox, KeepsTinyAndLongValues) {
  ui::NumberSpinBox box;
  box.showValue(1.25e-20);
  EXPECT_EQ(box.value(), 1.25e-20);
  EXPECT_EQ(box.text(), "1.25e-20");
  box.showValue(0.1234567890123);
  EXPECT_EQ(box.value(), 0.1234567890123);
}

TEST(Colours, ScreenAndLinearAreInverse) {
  for (const double c : {0.0, 0.001, 0.2, 0.5, 1.0}) {
    const glm::dvec3 back = ui::linearColour(ui::screenColour(glm::dvec3(c)));
    EXPECT_NEAR(back.x, c, 2e-5);
  }
  EXPECT_EQ(ui::screenColour(glm::dvec3(0.2140)).red(), 127);  // IEC 61966-2-1
}

class SettingsPanelTest : public testing::Test {
 protected:
  void SetUp() override {
    panel_.setScene(scene_, scene_);
    QObject::connect(&panel_, &ui::SettingsPanel::edited, [this](const ui::Edit& edit) {
      scene_ = edit.scene;
      last_ = edit;
      panel_.setScene(scene_, scene_);
    });
  }
  scene::Scene scene_;
  ui::Edit last_;
  ui::SettingsPanel panel_;
};

TEST_F(SettingsPanelTest, EverySettingHasOneRowButThoseOfOtherPanels) {
  std::multiset<std::string> rows;
  for (const ui::PanelGroup& group : ui::panelGroups()) {
    EXPECT_FALSE(group.settings.empty() && group.list == nullptr) << group.title.toStdString();
    for (const scene::Setting& setting : group.settings) rows.insert(setting.path);
  }
  for (const scene::Setting& setting : scene::settings()) {
    const bool elsewhere = setting.path.starts_with("source.") || setting.path == "marks.list" ||
                           setting.path.ends_with(".name");
    EXPECT_EQ(rows.count(setting.path), elsewhere ? 0U : 1U) << setting.path;
    EXPECT_EQ(panel_.editor(QString::fromStdString(setting.path)) == nullptr, elsewhere) << setting.path;
  }
}

TEST_F(SettingsPanelTest, RowsThatDoNothingAreHiddenUntilTheyActAndASearchSaysWhy) {
  EXPECT_FALSE(panel_.shows("look.curvature_points"));
  EXPECT_FALSE(panel_.shows("hit.rate"));
  EXPECT_FALSE(panel_.shows("light.environment.azimuth"));
  EXPECT_TRUE(panel_.shows("look.shininess"));
  auto* mode = panel_.editor("look.mode")->findChild<QComboBox*>();
  mode->setCurrentIndex(mode->findData("curvature_2d"));
  EXPECT_TRUE(panel_.shows("look.curvature_points"));
  EXPECT_FALSE(panel_.shows("look.shininess"));
  EXPECT_TRUE(panel_.shows("surfaces.main.value"));
  EXPECT_TRUE(panel_.shows("isosurface.value")) << "by its path of before lists";

  panel_.searchLine()->setText("samples per  RATE");
  EXPECT_TRUE(panel_.shows("hit.rate"));
  EXPECT_FALSE(panel_.shows("look.mode"));
  const ui::SettingEditor* rate = panel_.editor("hit.rate");
  EXPECT_FALSE(rate->isEnabled());
  EXPECT_TRUE(rate->toolTip().startsWith("Has no effect: hits are exact.")) << rate->toolTip().toStdString();
  auto* method = panel_.editor("hit.method")->findChild<QComboBox*>();
  method->setCurrentIndex(method->findData("sampled"));
  EXPECT_TRUE(rate->isEnabled());
  EXPECT_FALSE(rate->toolTip().contains("Has no effect"));
  panel_.searchLine()->clear();
  EXPECT_TRUE(panel_.shows("hit.rate"));
  EXPECT_TRUE(panel_.shows("look.mode"));
}

TEST_F(SettingsPanelTest, ASearchOpensFoldedGroupsAndFindsChoices) {
  panel_.resize(350, 700);
  panel_.show();
  QWidget* projection = panel_.editor("camera.projection");
  EXPECT_FALSE(projection->isVisible());
  panel_.searchLine()->setText("orthographic");
  EXPECT_TRUE(projection->isVisible());
  panel_.searchLine()->setText("viridis");  // of a setting that does nothing under this look
  EXPECT_TRUE(panel_.editor("look.colormap")->isVisible());
  panel_.searchLine()->clear();
  EXPECT_FALSE(projection->isVisible());
  panel_.findChild<QToolButton*>("Camera")->click();
  EXPECT_TRUE(projection->isVisible());
}

TEST_F(SettingsPanelTest, UnitIntervalsAreSlidersAndTogglesCheckBoxes) {
  for (const scene::Setting& setting : scene::settings()) {
    const ui::SettingEditor* editor = panel_.editor(QString::fromStdString(setting.path));
    if (editor == nullptr) continue;
    const bool unit =
        setting.type == scene::SettingType::number && setting.minimum == 0.0 && setting.maximum == 1.0;
    if (unit) {
      EXPECT_NE(editor->findChild<QSlider*>(), nullptr) << setting.path;
    }
    if (setting.type == scene::SettingType::toggle) {
      EXPECT_NE(editor->findChild<QCheckBox*>(), nullptr) << setting.path;
    }
    if (setting.unit == "linear RGB") {
      EXPECT_NE(editor->findChild<ui::ColorButton*>(), nullptr) << setting.path;
    }
  }
}

TEST_F(SettingsPanelTest, EveryRowFitsTheNarrowestPanel) {
  panel_.resize(panel_.minimumWidth(), 700);
  panel_.show();
  panel_.searchLine()->setText(".");  // all rows of all groups
  const auto* scroll = panel_.findChild<QScrollArea*>();
  EXPECT_LE(scroll->widget()->minimumSizeHint().width(), scroll->viewport()->width());
  for (const scene::Setting& setting : scene::settings()) {
    const ui::SettingEditor* editor = panel_.editor(QString::fromStdString(setting.path));
    if (editor == nullptr) continue;
    EXPECT_LE(editor->minimumSizeHint().width(), editor->isWide() ? 290 : 190) << setting.path;
  }
}

TEST_F(SettingsPanelTest, AChoiceThatIsCalledAutoIsShownAndChosenLikeTheOthers) {
  scene_.look.mode = scene::LookMode::kappa1;
  panel_.setScene(scene_, scene_);
  ui::SettingEditor* editor = panel_.editor("look.colormap");
  auto* combo = editor->findChild<QComboBox*>();
  EXPECT_FALSE(editor->valueWidget()->isHidden());
  combo->setCurrentIndex(combo->findData("viridis"));
  EXPECT_EQ(scene_.look.colormap, scene::ColorMap::viridis);
  editor->resetToDefault();
  EXPECT_EQ(combo->currentText(), "Auto");
}

TEST_F(SettingsPanelTest, AnAutomaticValueThatOnlyThePictureKnowsCanBeFixed) {
  scene_.look.mode = scene::LookMode::kappa1;
  panel_.setScene(scene_, scene_);
  ui::SettingEditor* editor = panel_.editor("look.range_high");
  EXPECT_TRUE(editor->valueWidget()->isHidden());  // there is no number to show
  editor->findChild<QCheckBox*>()->click();
  EXPECT_FALSE(editor->valueWidget()->isHidden());
  EXPECT_EQ(scene_.look.rangeHigh, 0.0);
  editor->findChild<QCheckBox*>()->click();
  EXPECT_FALSE(scene_.look.rangeHigh.has_value());
}

TEST_F(SettingsPanelTest, AChoiceEditsTheSceneAndCanBeReset) {
  auto* combo = panel_.editor("look.mode")->findChild<QComboBox*>();
  EXPECT_EQ(combo->currentText(), "Blinn-Phong");
  combo->setCurrentIndex(combo->findData("normal"));
  EXPECT_EQ(scene_.look.mode, scene::LookMode::normal);
  EXPECT_EQ(last_.name, "Change mode");
  panel_.editor("look.mode")->resetToDefault();
  EXPECT_EQ(scene_.look.mode, scene::Scene{}.look.mode);
  EXPECT_EQ(combo->currentText(), "Blinn-Phong");
}

TEST_F(SettingsPanelTest, ANumberFollowsItsSliderAndStaysInItsRange) {
  auto* slider = panel_.editor("look.ambient")->findChild<QSlider*>();
  ASSERT_NE(slider, nullptr);
  slider->setValue(slider->maximum());
  EXPECT_EQ(scene_.look.ambient, 1.0);
  EXPECT_FALSE(last_.mergeKey.isEmpty());
  auto* box = panel_.editor("look.ambient")->findChild<ui::NumberSpinBox*>();
  box->setValue(0.5);
  EXPECT_EQ(scene_.look.ambient, 0.5);
  EXPECT_EQ(slider->value(), slider->maximum() / 2);
}

TEST_F(SettingsPanelTest, AnAutomaticSettingCanBeFixedAndFreed) {
  scene::Scene resolved = scene_;
  resolved.surfaces.front().value = 42.0;
  panel_.setScene(scene_, resolved);
  auto* automatic = panel_.editor("isosurface.value")->findChild<QCheckBox*>();
  EXPECT_TRUE(automatic->isChecked());
  EXPECT_EQ(panel_.editor("isosurface.value")->findChild<ui::NumberSpinBox*>()->value(), 42.0);
  automatic->click();
  EXPECT_EQ(scene_.surfaces.front().value, 42.0);
  automatic->click();
  EXPECT_FALSE(scene_.surfaces.front().value.has_value());
}

TEST_F(SettingsPanelTest, AValueThatIsRefusedIsReportedAndShownAsItWas) {
  QString message;
  QObject::connect(&panel_, &ui::SettingsPanel::failed, [&](const QString& text) { message = text; });
  auto* editor = panel_.editor("light.direction");
  const auto boxes = editor->findChildren<ui::NumberSpinBox*>();
  ASSERT_EQ(boxes.size(), 3);
  boxes[0]->setValue(0.0);
  boxes[1]->setValue(0.0);
  boxes[2]->setValue(0.0);  // no direction at all
  EXPECT_TRUE(message.contains("light.direction")) << message.toStdString();
  EXPECT_EQ(boxes[2]->value(), scene_.light.direction.z);
  EXPECT_NE(scene_.light.direction.z, 0.0);
}

}  // namespace isolux::test
