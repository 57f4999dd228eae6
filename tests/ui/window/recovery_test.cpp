// What was open in a window that was killed is offered by the next start and comes back whole.
#include "tests/support/ui/window_fixture.h"

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <QCoreApplication>
#include <QProcess>
#include <QPushButton>
#include <QTest>

#include "app/documents/autosave.h"
#include "scene/settings/settings.h"
#include "tests/support/test_data.h"
#include "ui/document/document_keeper.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

constexpr auto folderVariable = "ISOLUX_TEST_AUTOSAVES";

const char* const tenEdits[] = {
    "isosurface.value=0.25", "look.mode=lambert",      "camera.fov=35",  "camera.projection=orthographic",
    "look.mode=normal",      "isosurface.value=0.125", "look.mode=tone", "isosurface.albedo=0.2,0.5,0.9",
    "camera.fov=50",         "look.mode=shape_index"};

void edit(ui::Document* document, const char* assignment) {
  ui::Edit edit{document->scene(), assignment, {}, false};
  scene::applyAssignment(edit.scene, assignment);
  document->edit(edit);
}

// All scenes that undoing everything passes through, the present one first.
std::vector<scene::Scene> undone(app::History history) {
  std::vector<scene::Scene> scenes{history.scene()};
  while (history.canUndo()) {
    history.undo();
    scenes.push_back(history.scene());
  }
  return scenes;
}

// Whether the folder's autosave is the document as it is now.
bool isKept(const std::filesystem::path& folder, const ui::Document& document) {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    if (entry.path().extension() != ".autosave") continue;
    std::ostringstream text;
    text << std::ifstream(entry.path()).rdbuf();
    return undone(app::parseAutosave(text.str(), "").document.history) == undone(document.history());
  }
  return false;
}

void runKilledWindow(const std::filesystem::path& folder) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(folderVariable, QString::fromStdString(folder.string()));
  QProcess process;
  process.setProcessEnvironment(environment);
  process.start(
      QCoreApplication::applicationFilePath(),
      {"--gtest_also_run_disabled_tests", "--gtest_filter=WindowTest.DISABLED_EditsTenTimesAndIsKilled"});
  ASSERT_TRUE(process.waitForStarted());
  const auto leftovers =
      std::filesystem::temp_directory_path() / ("isolux-test-" + std::to_string(process.processId()));
  ASSERT_TRUE(process.waitForFinished(120000));
  std::filesystem::remove_all(leftovers);  // of a killed process's temporaryFolder()
  ASSERT_EQ(process.exitStatus(), QProcess::CrashExit) << process.readAllStandardOutput().toStdString();
}

}  // namespace

// The window that is killed: run in a process of its own by the test below.
TEST_F(WindowTest, DISABLED_EditsTenTimesAndIsKilled) {
  const char* folder = std::getenv(folderVariable);
  ASSERT_NE(folder, nullptr);
  window_->keepDocument(folder);
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  for (const char* assignment : tenEdits) edit(window_->document(), assignment);
  // Nobody asks for an autosave: it comes of itself.
  ASSERT_TRUE(waitUntil([&] { return isKept(folder, *window_->document()); }));
  std::raise(SIGKILL);
}

TEST_F(WindowTest, AfterAKillTheNextStartOffersTheDocumentAndOneClickRestoresSceneAndUndoList) {
  const std::filesystem::path folder = temporaryFolder() / "autosave";
  runKilledWindow(folder);
  if (HasFatalFailure()) return;

  // What the killed window showed, made here by the same steps.
  ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  for (const char* assignment : tenEdits) edit(window_->document(), assignment);
  const QImage picture = fullPicture(*window_);
  const app::History expected = window_->document()->history();

  const auto next = makeWindow();
  next->keepDocument(folder);
  ASSERT_TRUE(load(*next, "phantom:torus:16"));  // as at a start; the offer outlives it
  ui::MessageBar* bar = next->messageBar();
  ASSERT_TRUE(bar->isVisible());
  EXPECT_TRUE(bar->text().startsWith("Continue: ball")) << bar->text().toStdString();
  EXPECT_TRUE(bar->text().endsWith("s ago")) << bar->text().toStdString();
  ASSERT_EQ(bar->buttons().size(), 2u);
  QTest::mouseClick(bar->buttons().front(), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return next->document()->history().canUndo(); }));
  EXPECT_EQ(undone(next->document()->history()), undone(expected));
  EXPECT_EQ(next->document()->history().undoName(), expected.undoName());
  EXPECT_TRUE(next->isWindowModified());
  EXPECT_FALSE(bar->isVisible());
  EXPECT_EQ(differingPixels(picture, fullPicture(*next)), 0.0);
  EXPECT_TRUE(app::takeLostAutosaves(folder).found.empty()) << "it has a window again";
}

TEST_F(WindowTest, ADiscardedAutosaveIsGoneAndAnUnansweredOneIsOfferedAgain) {
  const std::filesystem::path folder = temporaryFolder() / "autosave";
  const auto leaveOne = [&] {  // as a killed window would: a file whose lock nobody holds
    std::filesystem::create_directories(folder);
    app::OpenDocument document;
    document.name = "head phantom";
    scene::Scene scene;
    scene.source.path = "phantom:head:16";
    document.history.reset(scene);
    std::ofstream(folder / "1-1.autosave")
        << app::autosaveText({document, std::chrono::system_clock::now() - std::chrono::seconds(20)});
  };
  leaveOne();
  for (int start = 0; start < 2; ++start) {
    const auto window = makeWindow();
    window->keepDocument(folder);
    const QString text = window->messageBar()->text();
    EXPECT_TRUE(text.startsWith("Continue: head phantom, ")) << start << ": " << text.toStdString();
    EXPECT_TRUE(text.endsWith(" s ago")) << start << ": " << text.toStdString();
    EXPECT_TRUE(window->close());
  }
  window_->keepDocument(folder);
  ASSERT_EQ(window_->messageBar()->buttons().size(), 2u);
  QTest::mouseClick(window_->messageBar()->buttons().back(), Qt::LeftButton);
  EXPECT_FALSE(window_->messageBar()->isVisible());
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(WindowTest, ADamagedAutosaveIsToldAndKeptAside) {
  const std::filesystem::path folder = temporaryFolder();
  std::ofstream(folder / "1-1.autosave") << "{\"isolux_autosave\": 1, \"scene\": {";
  window_->keepDocument(folder);
  EXPECT_EQ(window_->messageBar()->kind(), ui::MessageBar::Kind::note);
  EXPECT_TRUE(window_->messageBar()->text().contains("1-1.autosave.damaged"));
  EXPECT_TRUE(std::filesystem::exists(folder / "1-1.autosave.damaged"));
}

TEST_F(WindowTest, ACleanExitLeavesNoAutosave) {
  const std::filesystem::path folder = temporaryFolder() / "autosave";
  window_->keepDocument(folder);
  ASSERT_TRUE(load(*window_, writeBall(16)));
  ASSERT_TRUE(waitUntil([&] {
    return std::filesystem::exists(folder) && !std::filesystem::is_empty(folder);
  })) << "an opened volume is autosaved";
  EXPECT_TRUE(window_->close());
  window_->keeper()->finish();
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(WindowTest, WhenTheDesktopsSessionEndsWithoutAQuestionTheWorkIsKept) {
  const std::filesystem::path folder = temporaryFolder() / "autosave";
  window_->keepDocument(folder);
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  edit(window_->document(), "isosurface.value=0.25");
  EXPECT_TRUE(window_->endSession(false));
  window_.reset();  // ended by the system: not closed by the user
  const app::LostAutosaves lost = app::takeLostAutosaves(folder);
  ASSERT_EQ(lost.found.size(), 1u);
  EXPECT_EQ(lost.found[0].content.document.history.scene().surfaces.front().value, 0.25);
}

TEST_F(WindowTest, AQuestionInTheBarOutlastsNotesAndErrors) {
  ui::MessageBar* bar = window_->messageBar();
  int answered = 0;
  bar->show(ui::MessageBar::Kind::question, "Which?", {{"This", [&] { ++answered; }}});
  bar->show(ui::MessageBar::Kind::note, "By the way");
  EXPECT_EQ(bar->text(), "By the way");
  EXPECT_TRUE(bar->buttons().empty());
  bar->clear();
  EXPECT_EQ(bar->text(), "Which?");
  bar->clear();
  EXPECT_EQ(bar->text(), "Which?");
  QTest::mouseClick(bar->buttons().front(), Qt::LeftButton);
  EXPECT_EQ(answered, 1);
  EXPECT_TRUE(bar->isHidden());
}

}  // namespace isolux::test
