// Unsaved work is asked about on every way out: closing, quitting, the end of the desktop's session, opening
// something else by menu, recent files and drop.
#include "tests/support/ui/window_fixture.h"

#include <functional>
#include <utility>
#include <vector>

#include <QAction>
#include <QCoreApplication>
#include <QDropEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QUrl>

#include "app/documents/session.h"
#include "tests/support/ui/dialog_answers.h"
#include "ui/document/recent_files.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

void edit(ui::MainWindow& window, const char* assignment) {
  ui::Edit edit{window.document()->scene(), assignment, {}, false};
  scene::applyAssignment(edit.scene, assignment);
  window.document()->edit(edit);
}

void trigger(ui::MainWindow& window, const QString& text) {
  for (QAction* menu : window.menuBar()->actions())
    for (QAction* action : menu->menu()->actions())
      if (action->text() == text) return action->trigger();
  ADD_FAILURE() << "no entry " << text.toStdString();
}

void drop(ui::MainWindow& window, const QString& file) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &enter);
  QDropEvent drop(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window, &drop);
  QCoreApplication::processEvents();
}

}  // namespace

TEST_F(WindowTest, EveryWayOutAsksAboutWorkThatWasNeverSaved) {
  const QString other = writeBall(16);
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  edit(*window_, "isosurface.value=0.25");
  const scene::Scene scene = window_->document()->scene();
  DialogAnswers cancel(QMessageBox::Cancel);
  const std::vector<std::pair<const char*, std::function<void()>>> ways{
      {"close", [&] { EXPECT_FALSE(window_->close()); }},
      {"quit", [&] { trigger(*window_, "&Quit"); }},
      {"end of the session", [&] { EXPECT_FALSE(window_->endSession(true)); }},
      {"open", [&] { window_->openPath(other); }},
      {"open a phantom", [&] { window_->openPath("phantom:torus:16"); }},
      {"drop", [&] { drop(*window_, other); }}};
  int asked = 0;
  for (const auto& [name, leave] : ways) {
    leave();
    EXPECT_TRUE(waitUntil([&] { return cancel.questions() == asked + 1; })) << name;
    asked = cancel.questions();
    EXPECT_TRUE(cancel.lastText().contains("ball phantom")) << cancel.lastText().toStdString();
    EXPECT_TRUE(window_->isVisible()) << name;
    EXPECT_FALSE(window_->document()->loading()) << name;
    EXPECT_EQ(window_->document()->scene(), scene) << name;
  }
}

TEST_F(WindowTest, DiscardedWorkIsGoneAndSavedWorkIsNot) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  edit(*window_, "isosurface.value=0.25");
  {
    DialogAnswers discard(QMessageBox::Discard);
    ASSERT_TRUE(load(*window_, "phantom:torus:16"));
    EXPECT_EQ(discard.questions(), 1);
  }
  edit(*window_, "isosurface.value=0.5");
  const scene::Scene scene = window_->document()->scene();
  const QString file = newFile("work");
  DialogAnswers save(QMessageBox::Save, file);
  EXPECT_TRUE(window_->close());
  EXPECT_EQ(save.questions(), 1);
  EXPECT_EQ(save.proposal(), "torus.isolux");
  EXPECT_EQ(app::loadSession((file + ".isolux").toStdString()), scene);
}

TEST_F(WindowTest, NothingIsAskedWhereNothingIsLost) {
  DialogAnswers cancel(QMessageBox::Cancel);
  EXPECT_TRUE(load(*window_, "phantom:ball:16"));
  window_->viewport()->applyStandardView(scene::StandardView::left);  // looking around is no work
  EXPECT_FALSE(window_->isWindowModified()) << "the title promises no question";
  EXPECT_TRUE(load(*window_, "phantom:torus:16"));
  edit(*window_, "look.mode=normal");
  window_->document()->undo();
  EXPECT_TRUE(load(*window_, "phantom:ball:16"));
  edit(*window_, "look.mode=normal");
  ASSERT_TRUE(window_->document()->saveSession(newFile("a.isolux")));
  EXPECT_TRUE(window_->close());
  EXPECT_EQ(cancel.questions(), 0);
}

TEST_F(WindowTest, ASessionFileIsKeptUpToDateWithTheView) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  const QString file = newFile("a.isolux");
  ASSERT_TRUE(window_->document()->saveSession(file));
  window_->viewport()->applyStandardView(scene::StandardView::left);
  DialogAnswers save(QMessageBox::Save);
  EXPECT_TRUE(window_->close());
  EXPECT_EQ(save.questions(), 1);
  EXPECT_TRUE(save.lastText().contains("a.isolux")) << save.lastText().toStdString();
  EXPECT_EQ(app::loadSession(file.toStdString()), window_->document()->scene());
}

TEST_F(WindowTest, ASaveThatIsCancelledOrFailsClosesNothing) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  edit(*window_, "look.mode=normal");
  DialogAnswers saveNowhere(QMessageBox::Save);  // and then cancels the file dialog
  EXPECT_FALSE(window_->close());
  EXPECT_EQ(saveNowhere.questions(), 1);
  EXPECT_FALSE(saveNowhere.proposal().isEmpty());
}

}  // namespace isolux::test
