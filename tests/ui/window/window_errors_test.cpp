// What goes wrong: broken files, cancelled loading, pictures that fail, no display.
#include "tests/support/surfaces.h"
#include "tests/support/test_data.h"
#include "tests/support/ui/window_fixture.h"

#include <cstdlib>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QProcess>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QTimer>

#include "base/destroy_in_background.h"
#include "tests/support/ui/dialog_answers.h"
#include "ui/dialogs/raw_import_dialog.h"
#include "ui/panels/volume_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/viewport/viewport_overlay.h"
#include "ui/window/load_card.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

TEST_F(WindowTest, ABrokenFileIsReportedAndThePreviousVolumeStays) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  const QImage before = fullPicture(*window_);
  const auto volume = window_->document()->volume();
  const QString file = newFile("broken.mhd");
  std::ofstream(file.toStdString())
      << "ObjectType = Image\nNDims = 3\nDimSize = 0 4 4\nElementType = MET_SHORT\n"
         "ElementDataFile = nowhere.raw\n";
  EXPECT_FALSE(load(*window_, file));
  EXPECT_TRUE(window_->messageBar()->isVisible());
  EXPECT_EQ(window_->messageBar()->kind(), ui::MessageBar::Kind::error);
  EXPECT_TRUE(window_->messageBar()->text().contains("broken.mhd"))
      << window_->messageBar()->text().toStdString();
  EXPECT_EQ(window_->document()->volume(), volume);
  EXPECT_TRUE(window_->windowTitle().startsWith("ball phantom"));
  // Layout changed by the bar: close it to compare pictures of one size.
  window_->messageBar()->clear();
  EXPECT_EQ(differingPixels(before, fullPicture(*window_)), 0.0);
  EXPECT_TRUE(load(*window_, "phantom:torus:24"));  // and the program goes on
}

TEST_F(WindowTest, ASlotThatThrowsIsToldAndTheWindowGoesOn) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  QTimer::singleShot(0, [] { throw std::logic_error("no such case"); });
  EXPECT_TRUE(waitUntil([&] { return window_->messageBar()->kind() == ui::MessageBar::Kind::error; }));
  EXPECT_TRUE(window_->messageBar()->text().contains("no such case"))
      << window_->messageBar()->text().toStdString();
  EXPECT_TRUE(load(*window_, "phantom:torus:16"));
}

// 4 x 4 x 4 voxels of which some are not there.
TEST_F(WindowTest, MissingDataAreToldUntilThatIsClosed) {
  const QString file = newFile("holes.mha");
  std::ofstream stream(file.toStdString(), std::ios::binary);
  stream << "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementNumberOfChannels = 2\nElementSpacing = 1 "
            "1 1\n"
            "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n";
  for (int i = 0; i < 128; ++i) {
    const float value = i == 2 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(i);
    stream.write(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  stream.close();
  ASSERT_TRUE(load(*window_, file));
  ui::MessageBar* const bar = window_->messageBar();
  EXPECT_EQ(bar->kind(), ui::MessageBar::Kind::warning);
  EXPECT_TRUE(bar->text().startsWith("1 of 64 voxels are NaN"))
      << "the gravest: " << bar->text().toStdString();
  bar->show(ui::MessageBar::Kind::note, "Saved");
  bar->clear();  // as after some seconds
  EXPECT_TRUE(bar->isVisible());
  EXPECT_EQ(bar->kind(), ui::MessageBar::Kind::warning);
  ASSERT_TRUE(load(*window_, "phantom:torus:16"));
  EXPECT_TRUE(waitUntil([&] { return bar->kind() != ui::MessageBar::Kind::warning; })) << "of another volume";
}

TEST_F(WindowTest, AMissingFileIsReported) {
  window_->openPath("/nowhere/at/all.nii");
  EXPECT_TRUE(waitUntil([&] { return window_->messageBar()->isVisible(); }));
  EXPECT_TRUE(window_->messageBar()->text().contains("all.nii"));
}

TEST_F(WindowTest, LoadingCanBeCancelledAndThePreviousVolumeStays) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  const auto volume = window_->document()->volume();
  bool ended = false, success = true;
  QObject::connect(window_->document(), &ui::Document::loadEnded, [&](bool good) {
    ended = true;
    success = good;
  });
  window_->openPath("phantom:head:512");
  EXPECT_TRUE(window_->document()->loading());
  ASSERT_TRUE(waitUntil([&] { return window_->panel<ui::LoadCard>()->isVisible(); }));
  EXPECT_FALSE(ended);  // the window answers while it loads
  QTest::mouseClick(window_->panel<ui::LoadCard>()->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_TRUE(ended);
  EXPECT_FALSE(success);
  EXPECT_FALSE(window_->document()->loading());
  EXPECT_FALSE(window_->panel<ui::LoadCard>()->isVisible());
  EXPECT_EQ(window_->document()->volume(), volume);
  EXPECT_TRUE(window_->messageBar()->isHidden());  // what the user did is no error
  EXPECT_TRUE(base::awaitDestroyed(60.0));         // the thread that was loading has ended
  QCoreApplication::processEvents();
  EXPECT_EQ(window_->document()->volume(), volume);
}

TEST_F(WindowTest, ThePictureStaysInAnotherWindow) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  ui::Viewport* viewport = window_->viewport();
  const QImage before = fullPicture(*window_);
  const QSize size = viewport->size();
  QWidget* home = viewport->parentWidget();
  viewport->setParent(nullptr);
  viewport->resize(size);
  viewport->show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(viewport, 120000));
  EXPECT_EQ(differingPixels(before, fullPicture(*window_)), 0.0);
  viewport->setParent(home);
}

// What one picture costs must not cost the next: the viewport comes back without another volume or window.
TEST_F(WindowTest, APictureThatFailsIsSaidAndComesBackWithUndo) {
  ASSERT_TRUE(load(*window_, "phantom:ball:132"));
  ui::Viewport* viewport = window_->viewport();
  viewport->setHostSettings({.memory = {.gpuBudgetMb = 16, .layout = scene::MemoryLayout::whole},
                             .executor = scene::Executor::gpu});
  const QImage before = fullPicture(*window_);
  ui::Edit edit{window_->document()->scene(), "Other field", {}, false};  // whose textures need 17.5 MiB
  edit.scene.hit.field = scene::Field::cubic_interpolating;
  int drawing = 0;
  const auto counts =
      QObject::connect(viewport, &ui::Viewport::drawing, [&](bool begins) { drawing += begins ? 1 : -1; });
  window_->document()->edit(edit);
  ASSERT_TRUE(waitUntil([&] { return viewport->problem().has_value(); }))
      << window_->messageBar()->text().toStdString();
  EXPECT_TRUE(viewport->problem()->contains("memory.gpu_budget_mb")) << viewport->problem()->toStdString();
  EXPECT_TRUE(window_->messageBar()->isVisible());
  const auto* overlay = viewport->findChild<ui::ViewportOverlay*>();
  EXPECT_TRUE(overlay->accessibleDescription().contains("undo"));
  EXPECT_FALSE(overlay->accessibleDescription().contains("OpenGL"));  // which is not to blame
  EXPECT_EQ(drawing, 0);                                              // light goes on
  EXPECT_THROW(viewport->picture({}), base::Error);
  window_->document()->undo();
  window_->messageBar()->hide();
  EXPECT_EQ(differingPixels(before, fullPicture(*window_), 0), 0.0);
  EXPECT_FALSE(viewport->problem().has_value());
  EXPECT_TRUE(overlay->accessibleDescription().isEmpty());
  window_->document()->edit(edit);
  ASSERT_TRUE(waitUntil([&] { return viewport->problem().has_value(); }));
  DialogAnswers discard(QMessageBox::Discard);
  ASSERT_TRUE(load(*window_, "phantom:torus:24"));  // another volume, which fits
  fullPicture(*window_);
  EXPECT_FALSE(viewport->problem().has_value());
  QObject::disconnect(counts);
}

TEST_F(WindowTest, AMistakeOfOurOwnCostsOnePictureAndNotTheWork) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  ui::Viewport* viewport = window_->viewport();
  const QImage before = fullPicture(*window_);
  int drawing = 0;
  const auto counts =
      QObject::connect(viewport, &ui::Viewport::drawing, [&](bool begins) { drawing += begins ? 1 : -1; });
  const scene::Scene good = window_->document()->resolvedScene();
  scene::Scene bad = good;
  test::surfaceAt(bad, 1).shown = true;  // and nobody has said where it is: std::bad_optional_access
  test::surfaceAt(bad, 1).value.reset();
  viewport->setScene(bad, bad);
  ASSERT_TRUE(waitUntil([&] { return viewport->problem().has_value(); }));
  EXPECT_TRUE(viewport->problem()->contains("internal error")) << viewport->problem()->toStdString();
  EXPECT_EQ(drawing, 0);
  viewport->setScene(good, good);
  window_->messageBar()->hide();
  EXPECT_EQ(differingPixels(before, fullPicture(*window_), 0), 0.0);
  EXPECT_FALSE(viewport->problem().has_value());
  QObject::disconnect(counts);
}

TEST_F(WindowTest, ASettingOutOfRangeIsRefusedWithAMessage) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  ui::Edit edit{window_->document()->scene(), "Change ambient", {}, false};
  edit.scene.look.ambient = 7.0;
  window_->document()->edit(edit);
  EXPECT_NE(window_->document()->scene().look.ambient, 7.0);
  EXPECT_TRUE(window_->messageBar()->text().contains("look.ambient"));
}

TEST_F(WindowTest, UndoOfAChangedSourceLoadsTheOtherVolumeAgain) {
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  ui::Edit edit{window_->document()->scene(), "Choose another", {}, false};
  edit.scene.source.path = "phantom:torus:20";
  window_->document()->edit(edit);
  ASSERT_TRUE(waitUntil([&] { return window_->document()->volume()->grid().dims().x == 20; }));
  window_->document()->undo();
  EXPECT_TRUE(waitUntil([&] { return window_->document()->volume()->grid().dims().x == 24; }));
  EXPECT_EQ(window_->document()->scene().source.path, "phantom:ball:24");
}

namespace {
struct ProgramResult {
  int exitCode;
  QString errors;
};
ProgramResult runWithout(const QStringList& removed, const QStringList& arguments,
                         const QString& display = {}) {
  QProcess process;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  for (const QString& name : removed) environment.remove(name);
  if (!display.isEmpty()) environment.insert("DISPLAY", display);
  process.setProcessEnvironment(environment);
  process.start(ISOLUX_PROGRAM, arguments);
  process.waitForFinished(120000);
  return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
          QString::fromUtf8(process.readAllStandardError())};
}
}  // namespace

TEST(NoDisplay, TheWindowIsRefusedWithOneLineAndExitCode4) {
  const QStringList all{"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"};
  for (const QString& display : {QString(), QString(":987")}) {
    const ProgramResult result = runWithout(all, {"phantom:ball:16"}, display);
    EXPECT_EQ(result.exitCode, 4) << result.errors.toStdString();
    EXPECT_EQ(result.errors.count('\n'), 1) << result.errors.toStdString();
    EXPECT_TRUE(result.errors.contains("isolux render")) << result.errors.toStdString();
  }
}

// Run by CTest with MESA_GL_VERSION_OVERRIDE=3.3.
TEST(OldGraphics, TheWindowSaysWhyThereIsNoPicture) {
  if (std::getenv("MESA_GL_VERSION_OVERRIDE") == nullptr) {
    GTEST_SKIP() << "graphics are not old: set MESA_GL_VERSION_OVERRIDE=3.3";
  }
  ui::MainWindow window;
  window.show();
  ASSERT_TRUE(waitUntil([&] { return window.viewport()->problem().has_value(); }));
  EXPECT_TRUE(window.messageBar()->isVisible());
  window.openPath("phantom:ball:16");  // everything but the picture still works
  EXPECT_TRUE(waitUntil([&] { return window.document()->volume() != nullptr; }));
  EXPECT_FALSE(window.savePicture(QString::fromStdString((temporaryFolder() / "none.png").string())));
}

}  // namespace isolux::test
