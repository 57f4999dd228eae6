// The window's thread waits for no picture: a view that is turned while light is baked, or while the Accuracy
// panel measures and searches.
#include "tests/support/ui/watchdog.h"
#include "tests/support/ui/window_fixture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include <QElapsedTimer>
#include <QPushButton>
#include <QTest>

#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/error_overlay_box.h"
#include "ui/accuracy/target_box.h"
#include "ui/document/baked_light.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

constexpr double longestTurn = 30.0, longestAnswer = 50.0;  // milliseconds

struct Orbit {
  std::vector<double> answers;  // from a mouse move to a picture that shows it, milliseconds, sorted
  int moves = 0;
};

// Drags on a circle, 60 moves a second.
Orbit orbit(ui::Viewport* viewport, double seconds) {
  constexpr int pause = 16;
  Orbit result;
  const auto connection = QObject::connect(viewport, &ui::Viewport::answered, [&](double milliseconds) {
    result.answers.push_back(milliseconds);
  });
  const QPoint centre = viewport->rect().center();
  const auto at = [&](int i) {
    return centre +
           QPoint(static_cast<int>(60.0 * std::cos(0.05 * i)), static_cast<int>(60.0 * std::sin(0.05 * i)));
  };
  QTest::mousePress(viewport, Qt::LeftButton, Qt::NoModifier, at(0));
  QElapsedTimer timer;
  timer.start();
  while (static_cast<double>(timer.elapsed()) < 1e3 * seconds) {
    QTest::mouseMove(viewport, at(++result.moves));
    QTest::qWait(pause);
  }
  QTest::mouseRelease(viewport, Qt::LeftButton, Qt::NoModifier, at(result.moves));
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
  orbit(window_->viewport(), 0.5);  // programs are compiled, the size of drafts is found
  const auto raysBefore = window_->light()->state().counters.rays;
  const Watchdog watchdog;
  const Orbit turned = orbit(window_->viewport(), 3.0);
  const double median = turned.answers.empty() ? 1e9 : turned.answers[turned.answers.size() / 2];
  std::printf(
      "turns: %zu, longest %.1f ms of the processor, %.1f ms in all, 99 %% within %.1f ms; "
      "%zu pictures for %d moves, median answer %.1f ms, longest %.1f ms\n",
      watchdog.turns().size(), watchdog.longestProcessor(), watchdog.longestWall(),
      watchdog.wallQuantile(0.99), turned.answers.size(), turned.moves, median,
      turned.answers.empty() ? 0.0 : turned.answers.back());
  EXPECT_GT(watchdog.turns().size(), 100u);
  EXPECT_LE(watchdog.longestProcessor(), longestTurn);
  EXPECT_LE(watchdog.wallQuantile(0.95), longestTurn);
  EXPECT_LE(median, longestAnswer);
  EXPECT_GT(window_->light()->state().counters.rays, raysBefore);  // and light was baked
}

TEST_F(WindowTest, TurningBesideTheAccuracyPanelNeverBlocksTheWindow) {
  ASSERT_TRUE(load(*window_, "phantom:head:64"));
  fullPicture(*window_);
  orbit(window_->viewport(), 0.5);
  const double alone = [&] {  // of this machine, with whatever else it does
    const Watchdog watchdog;
    orbit(window_->viewport(), 1.5);
    return watchdog.wallQuantile(0.95);
  }();
  window_->showPanel("Accuracy");
  auto* const panel = window_->panel<ui::AccuracyPanel>();
  const auto study = [&] { return panel->working() || panel->complete(); };
  const auto picture = [&] { return panel->picture().working() || panel->picture().known().has_value(); };
  const auto search = [&] {
    if (!panel->target()->searching()) {
      panel->target()->askError(app::Quantity::depthMm, 1e-9);  // all combinations are tried
      QTest::mouseClick(panel->target()->findButton(), Qt::LeftButton);
    }
    return app::TargetJob::running() > 0;
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
    orbit(window_->viewport(), 1.5);
    std::printf("%s: turns: %zu, longest %.1f ms of the processor, %.1f ms in all, 95 %% within %.1f ms\n",
                work.name, watchdog.turns().size(), watchdog.longestProcessor(), watchdog.longestWall(),
                watchdog.wallQuantile(0.95));
    EXPECT_GT(watchdog.turns().size(), 10u) << work.name;
    EXPECT_LE(watchdog.longestProcessor(), longestTurn) << work.name;
    EXPECT_LE(watchdog.wallQuantile(0.95), std::max(longestTurn, 2.0 * alone)) << work.name;
    EXPECT_FALSE(panel->target()->searching());
  }
}

}  // namespace isolux::test
