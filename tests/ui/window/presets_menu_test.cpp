// The menu of presets, and the picture as a command.
#include <cstdlib>
#include <fstream>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QInputDialog>
#include <QMenu>
#include <QTimer>

#include "app/documents/command_text.h"
#include "app/presets/preset_list.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"
#include "tests/support/ui/dialog_answers.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/document/baked_light.h"
#include "ui/panels/volume_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

QAction* entry(ui::MainWindow& window, const QString& text) {
  Q_EMIT window.presetsMenu()->aboutToShow();
  for (QAction* action : window.presetsMenu()->actions())
    if (action->text().startsWith(text)) return action;
  return nullptr;
}

// The user's folder of presets is elsewhere while it lives.
struct OtherConfig {
  OtherConfig() { ::setenv("XDG_CONFIG_HOME", temporaryFolder().c_str(), 1); }
  ~OtherConfig() { ::unsetenv("XDG_CONFIG_HOME"); }
};

}  // namespace

TEST_F(WindowTest, PresetsOfThisKindOfDataAreOfferedEachOneStepOfUndo) {
  const OtherConfig other;
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  EXPECT_EQ(entry(*window_, "CT bone"), nullptr) << "it is a distance field";
  EXPECT_NE(entry(*window_, "Distance"), nullptr);
  EXPECT_NE(entry(*window_, "&Data: Distance"), nullptr);

  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  const scene::Scene before = window_->document()->scene();
  EXPECT_NE(entry(*window_, "&Data: CT in Hounsfield units"), nullptr);
  QAction* const bone = entry(*window_, "CT bone");
  ASSERT_NE(bone, nullptr);
  bone->trigger();
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, 300.0);
  EXPECT_EQ(window_->document()->history().undoName(), "Preset CT bone");
  window_->document()->undo();
  EXPECT_EQ(window_->document()->scene(), before);
}

TEST_F(WindowTest, AnotherKindOfDataIsChosenInTheVolumePanel) {
  const OtherConfig other;
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  const auto* const panel = window_->findChild<ui::VolumePanel*>();
  QComboBox* const kind = panel->kindChoice();
  EXPECT_EQ(kind->currentText(), "CT in Hounsfield units (automatic)");
  EXPECT_TRUE(kind->toolTip().contains("its file states it")) << kind->toolTip().toStdString();
  kind->setCurrentIndex(kind->findText("MR"));
  Q_EMIT kind->activated(kind->currentIndex());
  ASSERT_TRUE(waitUntil([&] { return window_->document()->volume()->kind.kind == scene::DataKind::mr; }));
  EXPECT_EQ(window_->document()->volume()->volume.unit, "");
  EXPECT_EQ(entry(*window_, "CT bone"), nullptr);
  EXPECT_NE(entry(*window_, "MR skin"), nullptr);
  window_->document()->undo();
  ASSERT_TRUE(waitUntil([&] { return window_->document()->volume()->kind.kind == scene::DataKind::ct_hu; }));
  EXPECT_NE(entry(*window_, "CT bone"), nullptr);
}

TEST_F(WindowTest, APresetOfOnesOwnIsSavedByTheMenuAndShownInIt) {
  const OtherConfig other;
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  scene::Scene scene = window_->document()->scene();
  scene.surfaces.front().value = 512.0;
  scene.look.mode = scene::LookMode::tone;
  window_->document()->edit({scene, "Try", {}, false});
  // The dialog runs a loop of its own: answered from within it.
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, [&] {
    for (QWidget* widget : QApplication::topLevelWidgets())
      if (auto* dialog = qobject_cast<QInputDialog*>(widget); dialog && dialog->isVisible()) {
        dialog->setTextValue("My look & more");
        dialog->accept();
      }
  });
  answer.start(10);
  QAction* const save = entry(*window_, "&Save as preset");
  ASSERT_NE(save, nullptr);
  save->trigger();
  answer.stop();
  EXPECT_EQ(window_->messageBar()->text(), "Saved my_look_more.isolux-preset.json");
  window_->document()->undo();
  QAction* const own = entry(*window_, "My look && more");
  ASSERT_NE(own, nullptr);
  EXPECT_TRUE(own->isEnabled());
  own->trigger();
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, 512.0);
  EXPECT_EQ(window_->document()->scene().look.mode, scene::LookMode::tone);
}

TEST_F(WindowTest, APresetOfNearlyTheSameNameIsReplacedAfterAQuestionOnly) {
  const OtherConfig other;
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  scene::Scene scene = window_->document()->scene();
  scene.look.mode = scene::LookMode::tone;
  window_->document()->edit({scene, "Try", {}, false});
  window_->keepPresetAs("my bone");
  for (const auto button : {QMessageBox::No, QMessageBox::Yes}) {
    DialogAnswers answers(button);
    window_->keepPresetAs("My Bone");
    EXPECT_EQ(answers.questions(), 1);
    EXPECT_EQ(app::findPreset("my_bone").title, button == QMessageBox::Yes ? "My Bone" : "my bone");
  }
}

TEST_F(WindowTest, WhatWaitsForTheVolumeIsShownWhenItIsThere) {
  app::WindowRequest request;
  request.scene.source.path = "phantom:head:32";
  request.completed = [](const volume::PreparedVolume& volume) {
    return app::withPreset({}, app::findPreset("ct_skin"), volume);
  };
  window_->open(request);
  ASSERT_TRUE(waitUntil([&] { return window_->document()->volume() != nullptr; }));
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, -200.0);
  EXPECT_EQ(window_->document()->scene().source.path, "phantom:head:32");
  EXPECT_FALSE(window_->document()->history().canUndo());
}

namespace {

void expectTheCopiedCommandDraws(const ui::MainWindow& window, const QString& saved) {
  const std::string line = window.commandText().toStdString();
  const std::filesystem::path folder = std::filesystem::path(saved.toStdString()).parent_path(),
                              binaries = std::filesystem::canonical("/proc/self/exe").parent_path();
  std::ofstream(folder / "run.sh") << "cd " << app::shellWord(folder.string())
                                   << "\nPATH=" << app::shellWord(binaries.string()) << ":$PATH\n"
                                   << line << '\n';
  ASSERT_EQ(std::system(("sh " + app::shellWord((folder / "run.sh").string())).c_str()), 0) << line;
  const render::ColorImage expected = test::readPng(saved.toStdString()),
                           drawn = test::readPng(folder / "torus.png");
  EXPECT_EQ(drawn.size, expected.size);
  EXPECT_TRUE(drawn.rgba == expected.rgba) << line;
}

}  // namespace

TEST_F(WindowTest, TheCopiedCommandDrawsTheSavedPictureBitForBit) {
  ASSERT_TRUE(load(*window_, "phantom:torus:24"));
  scene::Scene scene = window_->document()->scene();
  scene.look.mode = scene::LookMode::mean_curvature;
  scene.look.fog = 0.125;
  window_->document()->edit({scene, "Try", {}, false});
  window_->viewport()->applyStandardView(scene::StandardView::left);
  const QString saved = newFile("saved.png");
  ASSERT_TRUE(window_->savePicture(saved));
  expectTheCopiedCommandDraws(*window_, saved);
}

TEST_F(WindowTest, TheCopiedCommandDrawsStoredLightBitForBit) {
  ASSERT_TRUE(load(*window_, "phantom:torus:24"));
  scene::Scene scene = window_->document()->scene();
  scene.look.mode = scene::LookMode::gi;
  scene.gi.samples = 16;
  window_->document()->edit({scene, "Light", {}, false});
  fullPicture(*window_);
  ASSERT_TRUE(waitUntil([&] { return window_->light()->state().phase == app::LightState::Phase::finished; }));
  const QString saved = newFile("saved.png");
  ASSERT_TRUE(window_->savePicture(saved));
  expectTheCopiedCommandDraws(*window_, saved);
}

}  // namespace isolux::test
