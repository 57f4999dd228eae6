// Settings of the machine: they act at once, are kept for the user, and are no part of the document.
#include "ui/dialogs/preferences_dialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>

#include "tests/support/ui/window_fixture.h"
#include "ui/document/preferences.h"
#include "ui/editors/setting_editor.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

class PreferencesTest : public WindowTest {
 protected:
  void SetUp() override {
    QSettings().remove("machine");
    WindowTest::SetUp();
  }
  void TearDown() override {
    WindowTest::TearDown();
    QSettings().remove("machine");
  }
  ui::PreferencesDialog* openDialog() {
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->text().startsWith("&Preferences")) action->trigger();
    return window_->findChild<ui::PreferencesDialog*>();
  }
};

// Whose tip says the path of this setting.
ui::ValueWidget* valueWidget(const ui::PreferencesDialog& dialog, const QString& path) {
  for (auto* widget : dialog.findChildren<ui::ValueWidget*>())
    if (widget->toolTip().contains("\n" + path + "\n")) return widget;
  return nullptr;
}

}  // namespace

TEST_F(PreferencesTest, AChangeActsAtOnceIsKeptAndIsNoEdit) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  ui::PreferencesDialog* dialog = openDialog();
  ASSERT_NE(dialog, nullptr);
  const auto boxes = dialog->findChildren<QCheckBox*>();
  const auto automatic = std::ranges::find(boxes, "auto", &QCheckBox::text);  // of the threads
  ASSERT_TRUE(automatic != boxes.end() && (*automatic)->isChecked());
  EXPECT_FALSE(valueWidget(*dialog, "gi.threads")->isEnabled());
  (*automatic)->click();
  EXPECT_TRUE(valueWidget(*dialog, "gi.threads")->isEnabled());
  valueWidget(*dialog, "gi.threads")->findChild<QSpinBox*>()->setValue(3);
  valueWidget(*dialog, "memory.gpu_budget_mb")->findChild<QSpinBox*>()->setValue(640);
  EXPECT_EQ(window_->host().threads, 3);
  EXPECT_EQ(window_->host().memory.gpuBudgetMb, 640);
  EXPECT_EQ(ui::savedHostSettings(), window_->host());
  EXPECT_FALSE(window_->document()->modified());
  EXPECT_FALSE(window_->document()->history().canUndo());

  const ui::MainWindow next;  // the user comes back
  EXPECT_EQ(next.host(), window_->host());
}

TEST_F(PreferencesTest, TheBudgetReachesTheRenderer) {
  ui::PreferencesDialog* dialog = openDialog();
  // The processor reads voxels where they are.
  valueWidget(*dialog, "picture.executor")->findChild<QComboBox*>()->setCurrentIndex(1);
  ASSERT_EQ(window_->host().executor, scene::Executor::gpu);
  valueWidget(*dialog, "memory.gpu_budget_mb")->findChild<QSpinBox*>()->setValue(16);
  bool inBricks = false;
  QObject::connect(window_->viewport(), &ui::Viewport::reported,
                   [&](const render::FrameReport& report) { inBricks = report.bricks.inUse; });
  ASSERT_TRUE(load(*window_, "phantom:ball:180"));  // 22 MiB
  ASSERT_TRUE(waitUntil([&] { return window_->viewport()->complete(); }));
  EXPECT_TRUE(inBricks);
  dialog->restoreDefaults();
  ASSERT_TRUE(waitUntil([&] { return window_->viewport()->complete() && !inBricks; }));
}

TEST_F(PreferencesTest, DefaultsComeBackAndAreForgotten) {
  ui::PreferencesDialog* dialog = openDialog();
  auto* adaptive = valueWidget(*dialog, "picture.adaptive")->findChild<QCheckBox*>();
  EXPECT_TRUE(valueWidget(*dialog, "picture.motion_target")->isEnabled());
  adaptive->click();
  EXPECT_FALSE(window_->host().adaptive);
  EXPECT_FALSE(valueWidget(*dialog, "picture.motion_target")->isEnabled());
  EXPECT_FALSE(QSettings().value("machine/picture.adaptive").isNull());
  dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::RestoreDefaults)->click();
  EXPECT_EQ(window_->host(), scene::HostSettings{});
  EXPECT_TRUE(QSettings().value("machine/picture.adaptive").isNull());
  EXPECT_TRUE(adaptive->isChecked());
}

TEST_F(PreferencesTest, WhatTheCommandLineSaysHoldsForOneRun) {
  app::WindowRequest request;
  request.scene.source.path = "phantom:ball:24";
  request.host = {"gi.threads=2"};
  window_->open(request);
  EXPECT_EQ(window_->host().threads, 2);
  EXPECT_FALSE(ui::savedHostSettings().threads);
}

TEST_F(PreferencesTest, WhatDoesNotFitIsPassedOver) {
  scene::HostSettings expected = ui::savedHostSettings();
  expected.motionTarget = 70.0;
  QSettings().setValue("machine/memory.gpu_budget_mb", "-5");
  QSettings().setValue("machine/memory.layout", "[[[");
  QSettings().setValue("machine/picture.motion_target", "70.0");
  EXPECT_EQ(ui::savedHostSettings(), expected);
}

}  // namespace isolux::test
