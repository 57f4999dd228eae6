// The window's thread waits for no picture: a view that is turned while light is baked, or while the Accuracy
// panel measures and searches. By the clock, turns and answers are printed; on a machine that others use they
// are what those leave.
#include "tests/support/ui/watchdog.h"
#include "tests/support/ui/window_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <QPushButton>
#include <QTest>

#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/error_overlay_box.h"
#include "ui/accuracy/target_box.h"
#include "ui/document/baked_light.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

// Milliseconds of the processor, four times what a turn may take for a window to stay fluent.
constexpr double mostWorkOfATurn = 4.0 * 30.0;

struct Orbit {
  std::vector<double> answers;  // from a mouse move to a picture that shows it, milliseconds, sorted
  int answeredWithinMoves = 0;  // pictures that came while a move was handled
};

// Drags on a circle, by as many moves, 60 a second where the machine lets it.
Orbit orbit(ui::Viewport* viewport, int moves) {
  constexpr int pause = 16;
  Orbit result;
  bool moving = false;
  const auto connection = QObject::connect(viewport, &ui::Viewport::answered, [&](double milliseconds) {
    result.answers.push_back(milliseconds);
    result.answeredWithinMoves += moving;
  });
  const QPoint centre = viewport->rect().center();
  const auto at = [&](int i) {
    return centre +
           QPoint(static_cast<int>(60.0 * std::cos(0.05 * i)), static_cast<int>(60.0 * std::sin(0.05 * i)));
  };
  QTest::mousePress(viewport, Qt::LeftButton, Qt::NoModifier, at(0));
  for (int i = 1; i <= moves; ++i) {
    const QPointF position = at(i);
    QMouseEvent move(QEvent::MouseMove, position, viewport->mapToGlobal(position), Qt::NoButton,
                     Qt::LeftButton, Qt::NoModifier);
    moving = true;
    QCoreApplication::sendEvent(viewport, &move);
    moving = false;
    QTest::qWait(pause);
  }
  EXPECT_TRUE(waitUntil([&] { return !result.answers.empty(); })) << "no picture follows";
  QTest::mouseRelease(viewport, Qt::LeftButton, Qt::NoModifier, at(moves));
  QObject::disconnect(connection);
  std::sort(result.answers.begin(), result.answers.end());
  return result;
}

}  // namespace

TEST_F(WindowTest, TurningBesideABakeNeverBlocksTheWindow) {
  ASSERT_TRUE(load(*window_, "phantom:head:64"));
  ui::Edit edit{window_->document()->scene(), "Light", {}, false};
  edit.scene.look.mode = scene::LookMode::gi;
  edit.scene.gi.samples = 1000000;  // never complete
  window_->document()->edit(edit);
  ASSERT_TRUE(waitUntil([&] { return window_->light()->state().counters.rays > 0; }));
  orbit(window_->viewport(), 30);  // programs are compiled, the size of drafts is found
  const auto raysBefore = window_->light()->state().counters.rays;
  const Watchdog watchdog;
  constexpr int moves = 180;
  const Orbit turned = orbit(window_->viewport(), moves);
  ASSERT_FALSE(turned.answers.empty());
  std::printf(
      "turns: %zu, longest %.1f ms of the processor, %.1f ms in all, 99 %% within %.1f ms; "
      "%zu pictures for %d moves, median answer %.1f ms, longest %.1f ms\n",
      watchdog.turns().size(), watchdog.longestProcessor(), watchdog.longestWall(),
      watchdog.wallQuantile(0.99), turned.answers.size(), moves, turned.answers[turned.answers.size() / 2],
      turned.answers.back());
  EXPECT_GT(watchdog.turns().size(), static_cast<std::size_t>(moves) / 2);
  EXPECT_EQ(turned.answeredWithinMoves, 0) << "a move waited for its picture";
  EXPECT_LE(watchdog.longestProcessor(), mostWorkOfATurn);
  EXPECT_TRUE(waitUntil([&] { return window_->light()->state().counters.rays > raysBefore; }))
      << "and light is baked";
}

TEST_F(WindowTest, TurningBesideTheAccuracyPanelNeverBlocksTheWindow) {
  ASSERT_TRUE(load(*window_, "phantom:head:64"));
  fullPicture(*window_);
  orbit(window_->viewport(), 30);
  window_->showPanel("Accuracy");
  auto* const panel = window_->panel<ui::AccuracyPanel>();
  const auto study = [&] { return panel->working() || panel->complete(); };
  const auto picture = [&] { return panel->picture().working() || panel->picture().known().has_value(); };
  const auto search = [&] {
    if (!panel->findChild<ui::TargetBox*>()->searching()) {
      panel->findChild<ui::TargetBox*>()->askError(app::Quantity::depthMm,
                                                   1e-9);  // all combinations are tried
      QTest::mouseClick(panel->findChild<ui::TargetBox*>()->findButton(), Qt::LeftButton);
    }
    return app::runningSearches() > 0;
  };
  struct Work {
    const char* name;
    std::function<bool()> runs;
  };
  const auto overlay = [&] {
    panel->overlay()->choose(app::ErrorImage::depth);
    return window_->viewport()->showsOver(ui::Viewport::Over::errors);
  };
  for (const Work& work :
       {Work{"picture", picture}, Work{"study", study}, Work{"search", search}, Work{"overlay", overlay}}) {
    ASSERT_TRUE(waitUntil(work.runs, 120000)) << work.name;
    const Watchdog watchdog;
    constexpr int moves = 90;
    const Orbit turned = orbit(window_->viewport(), moves);
    std::printf("%s: turns: %zu, longest %.1f ms of the processor, %.1f ms in all, 95 %% within %.1f ms\n",
                work.name, watchdog.turns().size(), watchdog.longestProcessor(), watchdog.longestWall(),
                watchdog.wallQuantile(0.95));
    EXPECT_GT(watchdog.turns().size(), static_cast<std::size_t>(moves) / 2) << work.name;
    EXPECT_EQ(turned.answeredWithinMoves, 0) << work.name << ": a move waited for its picture";
    EXPECT_LE(watchdog.longestProcessor(), mostWorkOfATurn) << work.name;
    EXPECT_FALSE(panel->findChild<ui::TargetBox*>()->searching());
  }
}

}  // namespace isolux::test
