// The animated flow: real time, no edits, still when paused, and what is saved is what is seen.
#include "tests/support/ui/window_fixture.h"

#include <QAction>
#include <QElapsedTimer>
#include <QTest>

#include "app/documents/recording.h"
#include "app/documents/session.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

class AnimationTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:ball:24"));
    QObject::connect(document(), &ui::Document::flowMoved, [this] { ++ticks_; });
  }
  ui::Document* document() { return window_->document(); }
  double shownTime() { return document()->shownScene().flow.time; }
  void startFlow() {
    ui::Edit edit{document()->scene(), "Flow", {}, false};
    edit.scene.flow.strength = 0.5;
    edit.scene.flow.animate = true;
    document()->edit(edit);
  }
  void pause(int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    waitUntil([&] { return timer.elapsed() > milliseconds; });
  }
  int ticks_ = 0;
};

}  // namespace

TEST_F(AnimationTest, FollowsRealTimeWithoutEdits) {
  // The flow begins between the two and is read between two looks at them: so also on a busy machine.
  QElapsedTimer before, after;
  before.start();
  startFlow();
  after.start();
  const scene::Scene scene = document()->scene();
  const std::string step = document()->history().undoName();
  const auto inSeconds = [](const QElapsedTimer& timer) {
    return static_cast<double>(timer.nsecsElapsed()) * 1e-9;
  };
  pause(500);
  const double least = inSeconds(after);  // the next tick is behind it
  ticks_ = 0;
  ASSERT_TRUE(waitUntil([&] { return ticks_ > 0; }));
  EXPECT_GE(shownTime(), 0.5 * least);  // a tick loses what passes while it is counted
  EXPECT_LE(shownTime(), inSeconds(before));
  EXPECT_EQ(document()->scene(), scene);
  EXPECT_EQ(document()->history().undoName(), step);
}

TEST_F(AnimationTest, StandsWhereItIsSeenWhenPausedAndCostsNothingThen) {
  startFlow();
  ASSERT_TRUE(waitUntil([&] { return shownTime() > 0.1; }));
  QTest::keyClick(window_->viewport(), Qt::Key_Space);
  EXPECT_FALSE(document()->scene().flow.animate);
  EXPECT_EQ(document()->history().undoName(), "Pause flow");
  const double stands = document()->scene().flow.time;
  EXPECT_GT(stands, 0.1);
  fullPicture(*window_);
  ticks_ = 0;
  int passes = 0;
  QObject::connect(window_->viewport(), &ui::Viewport::reported, [&](const render::FrameReport& report) {
    for (const render::PassReport& pass : report.passes)
      passes += pass.state == render::PassState::ran ? 1 : 0;
  });
  pause(250);
  EXPECT_EQ(ticks_, 0);
  EXPECT_EQ(passes, 0);
  EXPECT_EQ(shownTime(), stands);
  QTest::keyClick(window_->viewport(), Qt::Key_Space);  // goes on from there
  EXPECT_TRUE(waitUntil([&] { return shownTime() > stands; }));
}

TEST_F(AnimationTest, NothingMovesWithoutAFlowToShow) {
  ui::Edit edit{document()->scene(), "Animate", {}, false};
  edit.scene.flow.animate = true;
  document()->edit(edit);
  pause(150);
  EXPECT_EQ(ticks_, 0);
  EXPECT_EQ(shownTime(), 0.0);
  QTest::keyClick(window_->viewport(), Qt::Key_Space);  // disabled: nothing to animate
  EXPECT_TRUE(document()->scene().flow.animate);
}

TEST_F(AnimationTest, SavedPictureCarriesTheTimeShown) {
  startFlow();
  ASSERT_TRUE(waitUntil([&] { return shownTime() > 0.1; }));
  const double shown = shownTime();
  const QString file = newFile("flow.png");
  ASSERT_TRUE(window_->savePicture(file));
  EXPECT_EQ(app::loadSession(file.toStdString()).flow.time, shown);
}

TEST_F(AnimationTest, ARecordingBeginsAtTheTimeShownAndEndsWhereItWasPaused) {
  startFlow();
  ASSERT_TRUE(waitUntil([&] { return shownTime() > 0.05; }));
  const double begin = shownTime();
  const QString file = newFile("flow.jsonl");
  ASSERT_TRUE(document()->startRecording(file));
  pause(200);
  document()->toggleFlow();
  document()->stopRecording();
  const app::Recording recording = app::loadRecording(file.toStdString());
  EXPECT_EQ(recording.start.flow.time, begin);
  EXPECT_EQ(app::Playback(recording).at(1e3), document()->scene());
  const double half = app::Playback(recording).at(0.5 * recording.duration()).flow.time;
  EXPECT_NEAR(half, begin + 0.5 * recording.duration(), 1e-6);
}

}  // namespace isolux::test
