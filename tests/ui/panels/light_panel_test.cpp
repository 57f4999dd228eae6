// The environment and the lamps in the window: panels, the light probe's picture, gestures in the picture.
#include "tests/support/ui/window_fixture.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QTest>
#include <QUrl>

#include <glm/geometric.hpp>

#include "app/view_math/turning.h"
#include "scene/rules/environment.h"
#include "ui/editors/environment_preview.h"
#include "ui/editors/light_chooser.h"
#include "ui/editors/setting_editor.h"
#include "ui/panels/settings_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

// A small Radiance picture without compression (Ward, "Real Pixels", 1991): dark, with one bright pixel.
QString writeProbe(const QString& file, int width = 32, int height = 16, int brightColumn = 8) {
  std::ofstream out(file.toStdString(), std::ios::binary);
  out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << height << " +X " << width << '\n';
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool bright = y == height / 2 && x == brightColumn;
      const char grey[4] = {char(64), char(64), char(64), char(127)},
                 light[4] = {char(128), char(96), char(64), char(134)};
      out.write(bright ? light : grey, 4);
    }
  return file;
}

glm::dvec2 placeOf(const app::LampHandle& handle) {
  return handle.pixel;
}

class LightPanelTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:ball:32"));
    probe_ = writeProbe(newFile("probe.hdr"));
  }
  ui::Viewport* viewport() { return window_->viewport(); }
  ui::Document* document() { return window_->document(); }
  ui::SettingsPanel* panel() { return window_->panel<ui::SettingsPanel>(); }
  const scene::Environment& environment() { return document()->scene().light.environment; }
  QPoint centre() { return viewport()->rect().center(); }
  void set(const char* path, const nlohmann::json& value) {
    ui::Edit edit{document()->scene(), "Set", {}, false};
    scene::setting(path).set(edit.scene, value);
    document()->edit(edit);
  }
  void useProbe() {
    set("look.mode", "gi");
    set("light.environment.file", probe_.toStdString());
  }
  std::vector<app::LampHandle> lamps() {
    const scene::Scene scene = document()->resolvedScene();
    return app::lampHandles(scene, app::lampStageOf(scene, document()->volume()->facts,
                                                    {viewport()->width(), viewport()->height()}));
  }
  int steps() {  // that can be undone
    int count = 0;
    for (; document()->history().canUndo(); ++count) document()->undo();
    for (int i = 0; i < count; ++i) document()->redo();
    return count;
  }

  QString probe_;
};

}  // namespace

TEST_F(LightPanelTest, RowsAppearWithTheLookAndEditTheirSettings) {
  for (const char* path : {"light.environment.constant", "gi.mode", "picture.exposure"})
    EXPECT_FALSE(panel()->shows(path)) << path;
  set("look.mode", "gi");
  for (const char* path : {"light.environment.constant", "light.environment.file", "gi.mode", "gi.samples",
                           "gi.bounces", "gi.extent", "picture.exposure"})
    EXPECT_TRUE(panel()->shows(path)) << path;
  EXPECT_TRUE(panel()->shows("light.environment.rotation"));
  set("light.environment.constant", {1.0, 1.0, 1.0});
  EXPECT_FALSE(panel()->shows("light.environment.rotation"));  // of a sky of one colour
  auto* mode = panel()->editor("gi.mode")->findChild<QComboBox*>();
  mode->setCurrentIndex(mode->findData("transfer"));
  EXPECT_EQ(document()->scene().gi.mode, scene::GiMode::transfer);
  EXPECT_TRUE(panel()->shows("gi.sh_order"));
  EXPECT_EQ(document()->history().undoName(), "Change mode");
}

TEST_F(LightPanelTest, LightsAreAddedNamedAndRemoved) {
  set("look.mode", "gi");
  const auto button = [&](const char* text) {
    QCoreApplication::processEvents();  // new rows are shown
    for (QAbstractButton* one : panel()->findChildren<QAbstractButton*>())
      if (one->isVisibleTo(panel()) && (one->text() == text || one->accessibleName() == text)) return one;
    return static_cast<QAbstractButton*>(nullptr);
  };
  for (int light = 1; light <= 3; ++light) {
    ASSERT_TRUE(button("Add light")->isEnabled()) << light;
    button("Add light")->click();
  }
  EXPECT_FALSE(button("Add light")->isEnabled()) << "there are three";
  ASSERT_EQ(document()->scene().lamps.size(), 3U);
  EXPECT_TRUE(panel()->shows("lamps.light2.position"));
  EXPECT_FALSE(panel()->shows("lamps.light2.direction")) << "of a distant light";
  set("lamps.light2.kind", "directional");
  EXPECT_TRUE(panel()->shows("lamps.light2.direction"));
  set("lamps.light2.shown", false);
  EXPECT_FALSE(panel()->shows("lamps.light2.direction"));
  set("lamps.light1.name", "Window");
  const auto labels = [&] {
    QStringList texts;
    for (const QLabel* label : panel()->findChildren<QLabel*>()) texts += label->text();
    return texts;
  };
  EXPECT_TRUE(labels().contains("Window"));
  EXPECT_TRUE(labels().contains("Light 2"));
  button("Remove light")->click();  // the first
  EXPECT_EQ(document()->history().undoName(), "Remove light");
  ASSERT_EQ(document()->scene().lamps.size(), 2U);
  EXPECT_EQ(document()->scene().lamps[0].id, "light2");
  EXPECT_EQ(panel()->editor("lamps.light1.kind"), nullptr);
  document()->undo();
  EXPECT_EQ(document()->scene().lamps.at(0).name, "Window");
  EXPECT_TRUE(panel()->shows("lamps.light1.kind"));
}

TEST_F(LightPanelTest, AFileIsEnteredAndShownAndAMissingOneIsOneLine) {
  set("look.mode", "gi");
  const ui::ValueWidget* const file = panel()->editor("light.environment.file")->valueWidget();
  file->findChild<QLineEdit*>()->setFocus();
  file->findChild<QLineEdit*>()->selectAll();
  QTest::keyClicks(file->findChild<QLineEdit*>(), probe_);
  QTest::keyClick(file->findChild<QLineEdit*>(), Qt::Key_Return);
  EXPECT_EQ(environment().file, probe_.toStdString());
  EXPECT_TRUE(waitUntil([&] { return panel()->findChild<ui::EnvironmentPreview*>()->loaded(); }));
  EXPECT_TRUE(panel()->shows("light.environment.rotation"));

  set("light.environment.file", "/nowhere/sky.hdr");
  EXPECT_TRUE(waitUntil([&] { return window_->messageBar()->isVisible(); }));
  EXPECT_EQ(window_->messageBar()->kind(), ui::MessageBar::Kind::error);
  EXPECT_TRUE(window_->messageBar()->text().contains("sky.hdr"))
      << window_->messageBar()->text().toStdString();
  EXPECT_FALSE(window_->messageBar()->text().contains('\n'));
  EXPECT_FALSE(panel()->findChild<ui::EnvironmentPreview*>()->loaded());
}

TEST_F(LightPanelTest, OneClickOnAThumbnailTakesABuiltInLight) {
  useProbe();
  set("light.environment.constant", {0.5, 0.5, 0.5});
  ui::LightChooser* lights = panel()->findChild<ui::LightChooser*>();
  QToolButton* sunset = lights->button(scene::BuiltInLight::sunset);
  EXPECT_FALSE(sunset->isChecked());
  ASSERT_TRUE(sunset->isVisible());
  EXPECT_TRUE(waitUntil([&] { return !sunset->icon().isNull(); }));
  EXPECT_TRUE(sunset->toolTip().contains("sun"));
  const int before = steps();
  QTest::mouseClick(sunset, Qt::LeftButton);
  EXPECT_EQ(scene::kindOf(environment()), scene::EnvironmentKind::builtIn);
  EXPECT_EQ(environment().builtIn, scene::BuiltInLight::sunset);
  EXPECT_TRUE(sunset->isChecked());
  EXPECT_FALSE(lights->button(scene::BuiltInLight::studio)->isChecked());
  EXPECT_TRUE(waitUntil([&] { return panel()->findChild<ui::EnvironmentPreview*>()->loaded(); }));
  EXPECT_EQ(steps(), before + 1);
  EXPECT_EQ(document()->history().undoName(), "Choose light");
  QTest::mouseClick(sunset, Qt::LeftButton);  // again: nothing changes
  EXPECT_TRUE(sunset->isChecked());
  EXPECT_EQ(steps(), before + 1);
  document()->undo();
  EXPECT_EQ(environment().file, probe_.toStdString());
  EXPECT_FALSE(sunset->isChecked());
}

TEST_F(LightPanelTest, ASkyOfOneColourShinesFromTheFirst) {
  set("look.mode", "gi");
  auto* automatic = panel()->editor("light.environment.constant")->findChild<QCheckBox*>();
  ASSERT_NE(automatic, nullptr);
  EXPECT_TRUE(automatic->isChecked());
  automatic->setChecked(false);
  ASSERT_TRUE(environment().constant);
  EXPECT_GT(environment().constant->x, 0.0);
  EXPECT_FALSE(panel()->findChild<ui::LightChooser*>()->button(scene::BuiltInLight::studio)->isChecked());
}

TEST_F(LightPanelTest, AzimuthAndElevationTurnABuiltInLightAndLetItMove) {
  set("look.mode", "gi");
  for (const char* path : {"light.environment.azimuth", "light.environment.elevation"}) {
    ASSERT_TRUE(panel()->shows(path));
    auto* box = panel()->editor(path)->findChild<ui::NumberSpinBox*>();
    ASSERT_NE(box, nullptr) << path;
    box->setValue(30.0);
  }
  EXPECT_EQ(environment().azimuth, 30.0);
  EXPECT_EQ(environment().elevation, 30.0);
  EXPECT_TRUE(environment().moves);
}

TEST_F(LightPanelTest, ADroppedLightProbeLightsTheSurface) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(probe_)});
  QDragEnterEvent enter(QPoint(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &enter);
  QDropEvent drop(QPointF(100, 100), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &drop);
  ASSERT_TRUE(waitUntil([&] { return environment().file == probe_.toStdString(); }));
  EXPECT_EQ(document()->scene().look.mode, scene::LookMode::gi);
  EXPECT_EQ(document()->scene().source.path, "phantom:ball:32");
  document()->undo();  // one step
  EXPECT_EQ(document()->scene().look.mode, scene::Scene{}.look.mode);
  EXPECT_TRUE(environment().file.empty());
}

TEST_F(LightPanelTest, AnglesEditTheRotationAndStayAsEntered) {
  useProbe();
  const ui::ValueWidget* const rotation = panel()->editor("light.environment.rotation")->valueWidget();
  rotation->findChildren<ui::NumberSpinBox*>()[0]->setValue(30.0);
  rotation->findChildren<ui::NumberSpinBox*>()[2]->setValue(20.0);
  rotation->findChildren<ui::NumberSpinBox*>()[1]->setValue(90.0);
  const glm::dvec4 wanted = app::rotationOf({30.0, 90.0, 20.0});
  EXPECT_LT(glm::distance(environment().rotation, wanted), 1e-15);
  EXPECT_EQ(rotation->findChildren<ui::NumberSpinBox*>()[0]->value(), 30.0);
  EXPECT_EQ(rotation->findChildren<ui::NumberSpinBox*>()[2]->value(), 20.0);
  set("light.environment.rotation", {0.0, 0.0, 0.0, 2.0});
  EXPECT_EQ(rotation->findChildren<ui::NumberSpinBox*>()[0]->value(), 180.0);
  EXPECT_EQ(rotation->findChildren<ui::NumberSpinBox*>()[1]->value(), 0.0);
}

TEST_F(LightPanelTest, DraggingThePreviewTurnsItsPictureByTheDrag) {
  useProbe();
  ui::EnvironmentPreview* preview = panel()->findChild<ui::EnvironmentPreview*>();
  ASSERT_TRUE(waitUntil([&] { return preview->loaded(); }));
  EXPECT_TRUE(preview->hasProbe());
  const int before = steps();
  const QPoint from = preview->rect().center();
  drag(preview, from, from + QPoint(preview->width() / 4, 0));
  // A quarter of the width to the right: clockwise as seen from above.
  EXPECT_NEAR(environment().azimuth, -360.0 * (preview->width() / 4) / preview->width(), 1e-6);
  EXPECT_EQ(document()->history().undoName(), "Turn environment");
  EXPECT_EQ(steps(), before + 1);
}

TEST_F(LightPanelTest, ThePreviewShowsTheBrightPixelWhereItLights) {
  useProbe();
  ui::EnvironmentPreview* preview = panel()->findChild<ui::EnvironmentPreview*>();
  ASSERT_TRUE(waitUntil([&] { return preview->loaded(); }));
  set("light.environment.exposure", -6.0);  // not so bright that it is white
  const auto brightest = [&] {
    const QImage image = preview->grab().toImage();
    QPoint best;
    int most = -1;
    for (int y = image.height() / 4; y < image.height() * 3 / 4; ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor c = image.pixelColor(x, y);
        if (c.saturation() > 20 && c.red() > most) most = c.red(), best = {x, y};  // marks are grey
      }
    return best;
  };
  const double width = preview->width(), height = preview->height();
  EXPECT_NEAR(brightest().x(), 8.5 / 32.0 * width, 6.0);  // column 8 of 32
  EXPECT_NEAR(brightest().y(), 8.5 / 16.0 * height, 6.0);
  set("light.environment.rotation", {std::sqrt(0.5), 0.0, 0.0, -std::sqrt(0.5)});  // a quarter clockwise
  EXPECT_NEAR(brightest().x(), (8.5 / 32.0 + 0.25) * width, 6.0);
}

TEST_F(LightPanelTest, ShiftRightDragTurnsTheEnvironmentInOneStepAndLetsItMove) {
  useProbe();
  const int before = steps();
  const scene::Camera camera = document()->resolvedScene().camera;
  const glm::dvec2 size(viewport()->width(), viewport()->height());
  const auto place = [&](QPoint p) {
    return glm::dvec2(p.x() - 0.5 * size.x, 0.5 * size.y - p.y()) / (0.5 * std::min(size.x, size.y));
  };
  const glm::dvec4 wanted = app::turnedByDrag({1, 0, 0, 0}, scene::frameOf(camera), place(centre()),
                                              place(centre() + QPoint(60, 0)));
  drag(viewport(), centre(), centre() + QPoint(60, 0), Qt::RightButton, Qt::ShiftModifier);
  EXPECT_LT(glm::distance(environment().rotation, wanted), 1e-12);
  EXPECT_EQ(document()->resolvedScene().camera, camera);  // Shift: no zoom
  EXPECT_TRUE(environment().moves);
  EXPECT_TRUE(window_->messageBar()->isVisible());
  EXPECT_EQ(window_->messageBar()->kind(), ui::MessageBar::Kind::note);
  EXPECT_EQ(steps(), before + 1);
  window_->messageBar()->clear();
  drag(viewport(), centre(), centre() + QPoint(0, 40), Qt::RightButton, Qt::ShiftModifier);
  EXPECT_FALSE(window_->messageBar()->isVisible());  // said once
  document()->undo();
  document()->undo();
  EXPECT_FALSE(environment().moves);
  EXPECT_EQ(environment().rotation, glm::dvec4(1, 0, 0, 0));
}

TEST_F(LightPanelTest, AModeThatIsChosenStaysWhenTheEnvironmentTurns) {
  useProbe();
  set("gi.mode", "irradiance");
  drag(viewport(), centre(), centre() + QPoint(30, 0), Qt::RightButton, Qt::ShiftModifier);
  EXPECT_NE(environment().rotation, glm::dvec4(1, 0, 0, 0));
  EXPECT_FALSE(environment().moves);
}

TEST_F(LightPanelTest, WhatCannotBeTurnedSaysWhy) {
  set("look.mode", "gi");
  set("light.environment.constant", {1.0, 1.0, 1.0});
  const scene::Scene before = document()->scene();
  drag(viewport(), centre(), centre() + QPoint(30, 10), Qt::RightButton, Qt::ShiftModifier);
  EXPECT_EQ(document()->scene(), before);
  EXPECT_TRUE(window_->messageBar()->text().contains("constant environment"))
      << window_->messageBar()->text().toStdString();
}

TEST_F(LightPanelTest, ALampIsDraggedInItsPlaneAndAlongTheDepth) {
  set("look.mode", "gi");
  set("lamps.light1.kind", "point");
  ASSERT_EQ(lamps().size(), 1U);
  const auto pixelOf = [&] {
    return QPoint(static_cast<int>(std::lround(placeOf(lamps()[0]).x)),
                  static_cast<int>(std::lround(placeOf(lamps()[0]).y)));
  };
  const QPoint wanted = centre() + QPoint(80, -60);
  const int before = steps();
  drag(viewport(), pixelOf(), wanted);
  EXPECT_EQ(pixelOf(), wanted);
  EXPECT_EQ(document()->history().undoName(), "Move light 1");
  EXPECT_EQ(steps(), before + 1);
  ASSERT_TRUE(document()->scene().lamps.at(0).position.has_value());
  const glm::dvec3 placed = *document()->scene().lamps.at(0).position;
  const glm::dvec3 back = scene::frameOf(document()->resolvedScene().camera).back;
  drag(viewport(), wanted, wanted - QPoint(0, 50), Qt::LeftButton, Qt::ControlModifier);
  EXPECT_EQ(pixelOf(), wanted);  // only its depth
  EXPECT_LT(glm::dot(*document()->scene().lamps.at(0).position - placed, back), -1.0);
  const glm::dvec3 far = *document()->scene().lamps.at(0).position;
  const scene::Camera camera = document()->scene().camera;
  wheel(viewport(), wanted, -2);
  EXPECT_GT(glm::dot(*document()->scene().lamps.at(0).position - far, back), 1.0);
  EXPECT_EQ(document()->scene().camera, camera);  // the wheel does not zoom here
}

TEST_F(LightPanelTest, ADistantLampAndASpheresOutlineAreDragged) {
  set("look.mode", "gi");
  set("lamp2.shown", true);
  set("lamp2.kind", "directional");
  const auto handle = [&] { return lamps().at(0); };
  const QPoint wanted = centre() + QPoint(-40, -30);
  drag(viewport(), QPoint(int(std::lround(handle().pixel.x)), int(std::lround(handle().pixel.y))), wanted);
  EXPECT_LT(glm::distance(handle().pixel, glm::dvec2(wanted.x(), wanted.y())), 1.5);
  EXPECT_FALSE(document()->scene().lamps.at(1).position.has_value());  // not touched

  set("lamp2.kind", "sphere");
  set("lamp2.position", {0.0, 0.0, 0.0});
  const double before = handle().ringPixels;
  ASSERT_GT(before, 15.0);
  const QPoint middle(int(std::lround(handle().pixel.x)), int(std::lround(handle().pixel.y)));
  const QPoint edge = middle + QPoint(int(std::lround(before)), 0);
  drag(viewport(), edge, edge + QPoint(30, 0));
  EXPECT_NEAR(handle().ringPixels, before + 30.0, 1.5);
  EXPECT_EQ(document()->history().undoName(), "Resize light 2");
}

TEST_F(LightPanelTest, WithoutALampOrTheLookALeftDragRotates) {
  set("lamps.light1.kind", "point");  // under a local look lamps do nothing and have no handles
  EXPECT_TRUE(lamps().empty());
  set("look.mode", "gi");
  set("lamps.light1.shown", false);
  EXPECT_TRUE(lamps().empty());
  drag(viewport(), centre(), centre() + QPoint(30, 0));
  EXPECT_EQ(document()->history().undoName(), "Rotate");
}

}  // namespace isolux::test
