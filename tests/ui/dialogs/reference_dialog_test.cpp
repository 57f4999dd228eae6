// The path traced picture's dialog: it traces, refines, stops, and saves picture and variance.
#include "tests/support/png_reader.h"
#include "tests/support/ui/window_fixture.h"

#include <cmath>

#include <QPushButton>
#include <QSpinBox>
#include <QTest>

#include <ImfChannelList.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include "app/files/image_io.h"
#include "ui/dialogs/reference_dialog.h"

namespace isolux::test {

namespace {

class ReferenceDialogTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:ball:24"));
    scene::Scene resolved = window_->document()->resolvedScene();
    resolved.look.mode = scene::LookMode::gi;
    dialog_ = std::make_unique<ui::ReferenceDialog>(window_->document()->volume(), resolved, resolved,
                                                    QSize(40, 30), std::nullopt);
    dialog_->show();
  }
  void TearDown() override {
    dialog_.reset();
    WindowTest::TearDown();
  }
  bool ended() {
    return waitUntil([&] { return dialog_->startButton()->text() == "Trace"; });
  }
  // Empty when the file was written, else what the dialog says.
  static QString saved(ui::ReferenceDialog& dialog, const QString& file) {
    if (!dialog.saveAs(file)) return "not begun";
    if (!waitUntil([&] { return !dialog.saving(); })) return "not ended";
    return dialog.text().startsWith("Saved as ") ? QString() : dialog.text();
  }
  std::unique_ptr<ui::ReferenceDialog> dialog_;
};

}  // namespace

TEST_F(ReferenceDialogTest, TracesThePictureAndSavesItWithItsVariance) {
  EXPECT_FALSE(dialog_->saveButton()->isEnabled());
  dialog_->samplesBox()->setValue(16);
  dialog_->startButton()->click();
  EXPECT_EQ(dialog_->startButton()->text(), "Stop");
  ASSERT_TRUE(ended());
  ASSERT_NE(dialog_->image(), nullptr);
  EXPECT_EQ(dialog_->image()->size, glm::ivec2(40, 30));
  EXPECT_TRUE(dialog_->text().startsWith("Complete: noise ")) << dialog_->text().toStdString();
  const QString exr = newFile("still.exr"), png = newFile("still.png");
  ASSERT_EQ(saved(*dialog_, exr), "");
  ASSERT_EQ(saved(*dialog_, png), "");
  const Imf::InputFile file(exr.toStdString().c_str());
  EXPECT_NE(file.header().channels().findChannel("variance"), nullptr);
  EXPECT_FALSE(app::readSessionText(png.toStdString()).empty());
  const render::ColorImage picture = test::readPng(png.toStdString());
  EXPECT_EQ(picture.size, glm::ivec2(40, 30));
  const std::size_t middle = 4U * (15U * 40U + 20U);
  EXPECT_GT(picture.rgba[middle], picture.rgba[0] + 20);  // the ball is brighter than the background
}

TEST_F(ReferenceDialogTest, StoppingLeavesWhatThereIs) {
  dialog_->samplesBox()->setValue(1000000);
  dialog_->startButton()->click();
  ASSERT_TRUE(waitUntil([&] { return dialog_->image() != nullptr; }));
  EXPECT_TRUE(dialog_->tracing());
  dialog_->startButton()->click();
  ASSERT_TRUE(ended());
  EXPECT_TRUE(dialog_->text().startsWith("Stopped")) << dialog_->text().toStdString();
  EXPECT_TRUE(dialog_->saveButton()->isEnabled());
  EXPECT_EQ(saved(*dialog_, newFile("part.exr")), "");
  EXPECT_TRUE(saved(*dialog_, "/nowhere/at/all.exr").contains("all.exr")) << dialog_->text().toStdString();
}

TEST_F(ReferenceDialogTest, WhatCannotBeTracedIsSaidInOneLine) {
  scene::Scene resolved = window_->document()->resolvedScene();
  resolved.look.mode = scene::LookMode::gi;
  resolved.light.environment.file = "/nowhere/sky.hdr";
  ui::ReferenceDialog dialog(window_->document()->volume(), resolved, resolved, QSize(8, 8), std::nullopt);
  dialog.startButton()->click();
  ASSERT_TRUE(waitUntil([&] { return dialog.startButton()->text() == "Trace"; }));
  EXPECT_TRUE(dialog.text().contains("sky.hdr")) << dialog.text().toStdString();
  EXPECT_FALSE(dialog.saveButton()->isEnabled());
  EXPECT_FALSE(dialog.saveAs(newFile("none.exr")));
}

}  // namespace isolux::test
