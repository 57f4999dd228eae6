// Pictures that leave the window: what is written on them, their size, the clipboard, what they tell of
// folders, and sessions whose volume has gone.
#include "tests/support/png_reader.h"
#include "tests/support/ui/window_fixture.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QTest>

#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "tests/support/test_data.h"
#include "tests/support/ui/run_program.h"
#include "ui/dialogs/picture_dialog.h"
#include "ui/document/recent_files.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

class PicturesTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    QSettings().remove("picture");
    app::WindowRequest request;
    request.scene.source.path = "phantom:ball:24";
    window_->open(request);
    ASSERT_TRUE(waitUntil([&] { return window_->document()->volume() != nullptr; }));
    fullPicture(*window_);
  }
  void TearDown() override {
    QSettings().remove("picture");
    WindowTest::TearDown();
  }
  ui::PictureDialog* opened() {
    QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
    EXPECT_TRUE(waitUntil([&] { return window_->findChild<ui::PictureDialog*>() != nullptr; }));
    return window_->findChild<ui::PictureDialog*>();
  }
  std::string barText() { return window_->messageBar()->text().toStdString(); }
};

}  // namespace

TEST_F(PicturesTest, ANewDocumentWritesOnItsPicturesAndTheWindowsOwnStaysAsItIs) {
  const scene::Picture written = window_->document()->scene().picture;
  EXPECT_TRUE(written.letters && written.scaleBar && written.isovalue);
  EXPECT_FALSE(written.transparent);
  const QImage before = fullPicture(*window_);
  ui::Edit edit{window_->document()->scene(), "Words", {}, false};
  edit.scene.picture.letters = false;
  edit.scene.picture.transparent = true;
  window_->document()->edit(edit);
  EXPECT_EQ(differingPixels(before, fullPicture(*window_), 0), 0.0);
}

TEST_F(PicturesTest, TheDialogSaysWhatIsWrittenAndHowLarge) {
  ui::PictureDialog* dialog = opened();
  ASSERT_NE(dialog, nullptr);
  EXPECT_TRUE(dialog->letters->isChecked());
  EXPECT_FALSE(dialog->legend->isEnabled()) << "no colours stand for numbers";
  EXPECT_FALSE(dialog->width->isEnabled());
  const QImage with = dialog->preview->pixmap().toImage();
  ASSERT_FALSE(with.isNull());
  QTest::mouseClick(dialog->letters, Qt::LeftButton, {}, QPoint(8, dialog->letters->height() / 2));
  EXPECT_FALSE(dialog->letters->isChecked());
  EXPECT_GT(differingPixels(with, dialog->preview->pixmap().toImage()), 0.0) << "the preview follows";
  dialog->size->setCurrentIndex(3);
  EXPECT_TRUE(dialog->width->isEnabled());
  dialog->width->setValue(300);
  dialog->height->setValue(200);
  QTest::mouseClick(dialog->copy, Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return barText().starts_with("Copied the image: 300 × 200"); })) << barText();
  EXPECT_EQ(QGuiApplication::clipboard()->image().size(), QSize(300, 200));
  EXPECT_FALSE(window_->document()->scene().picture.letters);
  EXPECT_EQ(window_->document()->history().undoName(), "Change image annotations");
  EXPECT_FALSE(ui::withKeptWords({}).letters) << "kept for the next document";
}

TEST_F(PicturesTest, ASavedPictureHasWhatIsWrittenAndIsDrawnAgainByItsSession) {
  ui::PictureRequest asked;
  asked.factor = 2.0;
  ui::savePictureRequest(asked);
  const QString file = newFile("ball.png");
  ASSERT_TRUE(window_->savePicture(file));
  EXPECT_EQ(barText(), "Saved ball.png");
  const render::ColorImage saved = test::readPng(file.toStdString());
  EXPECT_EQ(saved.size, 2 * window_->viewport()->pixelSize());
  const scene::Scene scene = app::loadSession(file.toStdString());
  EXPECT_TRUE(scene.picture.letters);
  EXPECT_DOUBLE_EQ(scene.picture.pixelRatio, 2.0 * window_->viewport()->devicePixelRatioF());
  const std::filesystem::path path = file.toStdString();
  ASSERT_EQ(runProgram("render ball.png --out again.png", path.parent_path()), 0);
  EXPECT_EQ(test::readPng(path.parent_path() / "again.png").rgba, saved.rgba);

  ui::Edit edit{window_->document()->scene(), "Words", {}, false};
  edit.scene.picture.letters = edit.scene.picture.scaleBar = edit.scene.picture.isovalue = false;
  window_->document()->edit(edit);
  ASSERT_TRUE(window_->savePicture(file));
  EXPECT_NE(test::readPng(path).rgba, saved.rgba) << "there was something written";
}

TEST_F(PicturesTest, ThePictureIsCopiedByItsKeyAndWithoutBackgroundWhereThatIsWished) {
  ui::Edit edit{window_->document()->scene(), "Transparent", {}, false};
  edit.scene.picture.transparent = true;
  window_->document()->edit(edit);
  window_->viewport()->setFocus();
  QTest::keyClick(window_->viewport(), Qt::Key_C, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([&] { return barText().starts_with("Copied the image"); })) << barText();
  const QImage copied = QGuiApplication::clipboard()->image();
  ASSERT_FALSE(copied.isNull());
  ASSERT_TRUE(copied.hasAlphaChannel());
  EXPECT_EQ(copied.pixelColor(copied.width() / 4, 2).alpha(), 0);
  EXPECT_EQ(copied.pixelColor(copied.width() / 2, copied.height() / 2).alpha(), 255);
}

TEST_F(PicturesTest, FullPathsAreInAFileOnlyWhereThatIsWished) {
  const QString volume = writeBall(16);
  ASSERT_TRUE(load(*window_, volume));
  const std::string folder = QFileInfo(volume).absolutePath().toStdString();
  const QString file = newFile("ball.png");
  for (const bool full : {false, true}) {
    ui::PictureRequest asked;
    asked.fullPaths = full;
    ui::savePictureRequest(asked);
    ASSERT_TRUE(window_->savePicture(file));
    EXPECT_EQ(app::readSessionText(file.toStdString()).find(folder) != std::string::npos, full);
  }
}

TEST_F(PicturesTest, AVolumeThatHasGoneIsAskedForAndOneOfItsNameIsProposed) {
  const QString volume = writeBall(16);
  ASSERT_TRUE(load(*window_, volume));
  const QString session = newFile("ball.isolux");
  ASSERT_TRUE(window_->document()->saveSession(session));
  const scene::Scene saved = window_->document()->scene();
  const QString elsewhere = QFileInfo(newFile("x")).absolutePath();
  for (const QString end : {"mhd", "raw"})
    ASSERT_TRUE(QFile::rename(QString(volume).replace("mhd", end), elsewhere + "/ball." + end));
  ui::addRecentFile({elsewhere + "/ball.mhd"});
  window_->openPath(session);
  EXPECT_EQ(window_->messageBar()->kind(), ui::MessageBar::Kind::question);
  EXPECT_NE(barText().find("ball.isolux shows ball.mhd"), std::string::npos) << barText();
  ASSERT_EQ(window_->messageBar()->buttons().size(), 2u);
  EXPECT_EQ(window_->messageBar()->buttons()[1]->text(), "Find it…");
  const auto before = window_->document()->volume();
  QTest::mouseClick(window_->messageBar()->buttons()[0], Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return window_->document()->volume() != before; }));
  EXPECT_EQ(window_->document()->scene().source.path, (elsewhere + "/ball.mhd").toStdString());
  EXPECT_EQ(window_->document()->scene().isosurface, saved.isosurface);
  ui::clearRecentFiles();
}

}  // namespace isolux::test
