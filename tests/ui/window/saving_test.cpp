// Saving: names and formats, what is proposed, what is said about it, and what a picture tells about its
// maker.
#include "tests/support/ui/window_fixture.h"

#include <csignal>
#include <filesystem>
#include <fstream>

#include <sys/resource.h>

#include <QAction>
#include <QFile>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>

#include "app/documents/recording.h"
#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "tests/support/test_data.h"
#include "tests/support/ui/dialog_answers.h"
#include "ui/dialogs/raw_import_dialog.h"
#include "ui/panels/light_status.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

void triggerEntry(ui::MainWindow& window, const QString& text) {
  for (QAction* menu : window.menuBar()->actions())
    for (QAction* action : menu->menu()->actions())
      if (action->text().startsWith(text)) return action->trigger();
  ADD_FAILURE() << "no entry " << text.toStdString();
}

std::string contentOf(const QString& file) {
  QFile stream(file);
  return stream.open(QIODevice::ReadOnly) ? stream.readAll().toStdString() : std::string();
}

std::string barText(const ui::MainWindow& window) {
  return window.messageBar()->text().toStdString();
}

}  // namespace

TEST_F(WindowTest, ANameWithoutSuffixIsAskedAboutBeforeItReplacesAFile) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  const QString file = newFile("head");
  std::ofstream((file + ".isolux").toStdString()) << "precious";
  {
    DialogAnswers answers(QMessageBox::Save, file);  // and No to overwriting
    triggerEntry(*window_, "Save session &as");
    EXPECT_EQ(answers.overwriteQuestions(), 1);
  }
  EXPECT_EQ(contentOf(file + ".isolux"), "precious");
  DialogAnswers answers(QMessageBox::Save, file + "2");
  triggerEntry(*window_, "Save session &as");
  EXPECT_EQ(window_->document()->sessionFile(), file + "2.isolux");
  EXPECT_EQ(barText(*window_), "Saved head2.isolux");
  ASSERT_EQ(window_->messageBar()->buttons().size(), 1u);
  EXPECT_EQ(window_->messageBar()->buttons().front()->text(), "Show in folder");
}

TEST_F(WindowTest, SavingIsProposedBesideTheVolumeByItsName) {
  const QString volume = writeBall(16);
  ASSERT_TRUE(load(*window_, volume));
  DialogAnswers answers(QMessageBox::Cancel);
  triggerEntry(*window_, "Save session &as");
  EXPECT_EQ(answers.proposal(), "ball.isolux");
  EXPECT_EQ(answers.folder(), QFileInfo(volume).absolutePath());
  triggerEntry(*window_, "Save &image");
  EXPECT_TRUE(waitUntil([&] { return answers.proposal() == "ball.png"; }))
      << answers.proposal().toStdString();
  EXPECT_EQ(answers.folder(), QFileInfo(volume).absolutePath());
}

TEST_F(WindowTest, APictureIsWrittenInTheFormatOfItsNameOrRefused) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  const QString file = newFile("ball");
  EXPECT_FALSE(window_->savePicture(file + ".jpg"));
  EXPECT_FALSE(QFileInfo::exists(file + ".jpg"));
  EXPECT_EQ(window_->messageBar()->kind(), ui::MessageBar::Kind::error);
  EXPECT_NE(barText(*window_).find("ball.jpg"), std::string::npos) << barText(*window_);
  EXPECT_NE(barText(*window_).find(".exr"), std::string::npos) << barText(*window_);
  EXPECT_TRUE(window_->savePicture(file + ".PNG"));
  EXPECT_EQ(contentOf(file + ".PNG").substr(1, 3), "PNG");
  EXPECT_TRUE(window_->savePicture(file + ".exr"));
  EXPECT_EQ(contentOf(file + ".exr").substr(0, 4), "\x76\x2f\x31\x01");
  DialogAnswers answers(QMessageBox::Cancel, file);
  triggerEntry(*window_, "Save &image");
  EXPECT_TRUE(waitUntil([&] { return barText(*window_) == "Saved ball.png"; })) << barText(*window_);
  EXPECT_TRUE(QFileInfo::exists(file + ".png"));
}

TEST_F(WindowTest, ASavedPictureNamesNoFolderAndIsOpenedAgainAllTheSame) {
  const QString volume = writeBall(16);
  ASSERT_TRUE(load(*window_, volume));
  const QString file = newFile("ball.png");
  ASSERT_TRUE(window_->savePicture(file));
  const std::string text = app::readSessionText(file.toStdString());
  EXPECT_NE(text.find("ball.mhd"), std::string::npos);
  EXPECT_EQ(text.find(QFileInfo(volume).absolutePath().toStdString()), std::string::npos) << text;
  EXPECT_EQ(text.find('/'), std::string::npos) << text;
  const auto fresh = makeWindow();
  ASSERT_TRUE(load(*fresh, file));
  scene::Scene saved = window_->document()->scene();
  EXPECT_EQ(saved.camera.eye, std::nullopt);
  saved.camera = window_->document()->resolvedScene().camera;  // written down as it fits this window
  EXPECT_EQ(fresh->document()->scene(), saved);

  ASSERT_TRUE(window_->savePicture(file, false));
  EXPECT_EQ(app::readSessionText(file.toStdString()), "") << "picture only";
}

// Of each format that may carry a session, whatever its name.
TEST_F(WindowTest, SavingASessionNeverReplacesThePictureItCameFrom) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  const QString png = newFile("ball.png"), exr = newFile("ball.exr"), bare = newFile("ball");
  ASSERT_TRUE(window_->savePicture(png));
  ASSERT_TRUE(window_->savePicture(exr));
  ASSERT_TRUE(QFile::copy(png, bare));
  for (const QString& picture : {png, exr, bare}) {
    const std::string before = contentOf(picture);
    const auto fresh = makeWindow();
    ASSERT_TRUE(load(*fresh, picture));
    EXPECT_EQ(fresh->document()->sessionFile(), QString()) << picture.toStdString();
    const QString session = newFile("kept.isolux");
    DialogAnswers answers(QMessageBox::Save, session);
    triggerEntry(*fresh, "&Save session");
    EXPECT_TRUE(QFileInfo::exists(session)) << "a name is asked for";
    EXPECT_EQ(contentOf(picture), before);
  }
}

TEST(LightStatus, UnfinishedLightIsToldInPerCent) {
  using Phase = app::LightState::Phase;
  app::LightState state;
  EXPECT_EQ(ui::unfinishedLightText(state, false), "");
  state.counters.samplesWanted = 1000;
  state.counters.samplesDone = 95;
  for (const Phase phase : {Phase::baking, Phase::paused}) {
    state.phase = phase;
    EXPECT_EQ(ui::unfinishedLightText(state, false), "light 9 % complete");
  }
  state.phase = Phase::preparing;
  EXPECT_EQ(ui::unfinishedLightText(state, false), "light 0 % complete");
  state.phase = Phase::finished;
  EXPECT_EQ(ui::unfinishedLightText(state, false), "");
  EXPECT_EQ(ui::unfinishedLightText(state, true), "light 9 % complete") << "stopped on its way";
}

TEST_F(WindowTest, ARecordingSaysWhereItWentAndIsKnownWhenItIsOpened) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  const QString file = newFile("tour");
  DialogAnswers answers(QMessageBox::Cancel, file);
  triggerEntry(*window_, "Start &recording");
  ASSERT_TRUE(window_->document()->recording());
  triggerEntry(*window_, "Stop &recording");
  EXPECT_NE(barText(*window_).find("Saved tour.jsonl"), std::string::npos) << barText(*window_);
  EXPECT_NE(barText(*window_).find("isolux replay tour.jsonl --out"), std::string::npos) << barText(*window_);
  window_->messageBar()->clear();
  window_->openPath(file + ".jsonl");
  EXPECT_TRUE(window_->findChildren<ui::RawImportDialog*>().isEmpty());
  EXPECT_NE(barText(*window_).find("render it with isolux replay tour.jsonl"), std::string::npos)
      << barText(*window_);
}

TEST_F(WindowTest, AFileThatIsNoRecordingIsNotRecordedInto) {
  const QString volume = writeBall(16);
  ASSERT_TRUE(load(*window_, volume));
  const std::string before = contentOf(volume);
  EXPECT_FALSE(window_->document()->startRecording(volume));
  EXPECT_EQ(contentOf(volume), before);
  EXPECT_NE(barText(*window_).find("ball.mhd"), std::string::npos) << barText(*window_);
}

TEST_F(WindowTest, NothingIsSavedOverTheVolume) {
  const QString volume = writeBall(16);
  ASSERT_TRUE(load(*window_, volume));
  const QString data = QString(volume).replace(".mhd", ".raw");
  for (const QString& file : {volume, data}) {
    const std::string before = contentOf(file);
    EXPECT_FALSE(window_->document()->saveSession(file));
    EXPECT_EQ(contentOf(file), before);
    EXPECT_NE(barText(*window_).find("would be written over"), std::string::npos) << barText(*window_);
  }
}

TEST_F(WindowTest, AFullDiskStopsTheRecordingAndIsToldOnce) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  const QString file = newFile("tour.jsonl");
  ASSERT_TRUE(window_->document()->startRecording(file));
  int told = 0;
  QObject::connect(window_->document(), &ui::Document::failed, [&] { ++told; });
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);  // a limit on the size of files stands for the disk
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  rlimit little = before;
  little.rlim_cur = static_cast<rlim_t>(QFileInfo(file).size()) + 10;
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
  window_->viewport()->applyStandardView(scene::StandardView::left);
  window_->viewport()->applyStandardView(scene::StandardView::right);
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_FALSE(window_->document()->recording());
  EXPECT_EQ(told, 1);
  EXPECT_NE(barText(*window_).find("ecording stopped"), std::string::npos) << barText(*window_);
  EXPECT_NO_THROW(app::loadRecording(file.toStdString()));
}

TEST_F(WindowTest, TheTitleNamesAFileOnlyWhenItIsShown) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  ASSERT_TRUE(waitUntil([&] { return window_->windowTitle().startsWith("ball phantom"); }));
  QString titleBefore;
  const auto connection = QObject::connect(window_->document(), &ui::Document::loadEnded,
                                           [&] { titleBefore = window_->windowTitle(); });
  window_->openPath("phantom:torus:16");
  ASSERT_TRUE(waitUntil([&] { return window_->windowTitle().startsWith("torus phantom"); }));
  EXPECT_TRUE(titleBefore.startsWith("ball phantom")) << titleBefore.toStdString();
  QObject::disconnect(connection);
}

}  // namespace isolux::test
