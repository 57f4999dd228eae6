// The table of passes: what it says about a picture, and what it costs while the picture moves.
#include "ui/panels/passes_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include "tests/support/ui/window_fixture.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

using render::PassState;

render::FrameReport sample() {
  render::FrameReport report;
  report.passes = {{"blocks", PassState::cached, "nothing it depends on changed", 0.0, 1200},
                   {"cast", PassState::ran, "camera changed", 12.5, 4000000},
                   {"flow", PassState::skipped, "nobody reads it", 0.0, 0}};
  report.milliseconds = 14.0;
  report.blocksActive = 25;
  report.blocksTotal = 100;
  report.gpuBytes = 5000000;
  return report;
}

render::FrameReport still() {
  render::FrameReport report = sample();
  report.passes[1] = {"cast", PassState::cached, "nothing it depends on changed", 0.0, 4000000};
  report.milliseconds = 0.1;
  return report;
}

QString allLabels(const ui::PassesPanel& panel) {
  QStringList texts;
  for (const QLabel* label : panel.findChildren<QLabel*>()) texts += label->text();
  return texts.join('\n');
}

}  // namespace

TEST(PassesPanel, SaysOfEachPassWhetherItRanWhyHowLongAndHowMuch) {
  ui::PassesPanel panel;
  panel.resize(350, 500);
  panel.setReport(sample(), {});
  panel.show();
  ASSERT_EQ(panel.findChild<QTreeWidget*>()->topLevelItemCount(), 3);
  const QTreeWidgetItem* cast = panel.findChild<QTreeWidget*>()->topLevelItem(1);
  EXPECT_EQ(cast->text(0), "cast");
  EXPECT_EQ(cast->text(1), "ran");
  EXPECT_EQ(cast->text(2), "12.5 ms");
  EXPECT_EQ(cast->text(3), "4 MB");
  EXPECT_EQ(cast->child(0)->text(0), "camera changed");
  EXPECT_EQ(panel.findChild<QTreeWidget*>()->topLevelItem(2)->text(1), "skipped");
  EXPECT_TRUE(allLabels(panel).contains("25 of 100 (25 %)")) << allLabels(panel).toStdString();
  EXPECT_TRUE(allLabels(panel).contains("5 MB"));
}

TEST(PassesPanel, AStillPictureIsSaidToCostNothingAndKeepsTheLastTable) {
  ui::PassesPanel panel;
  panel.resize(350, 500);
  panel.show();
  panel.setReport(sample(), {});
  for (int i = 0; i < 3; ++i) panel.setReport(still(), {});
  EXPECT_TRUE(waitUntil([&] { return allLabels(panel).contains("Redrawn 3 times"); }));
  EXPECT_EQ(panel.findChild<QTreeWidget*>()->topLevelItem(1)->text(1), "ran");
}

TEST(PassesPanel, IsWrittenAFewTimesASecondAtMost) {
  ui::PassesPanel panel;
  panel.resize(350, 500);
  panel.show();
  int changes = 0;
  QObject::connect(panel.findChild<QTreeWidget*>(), &QTreeWidget::itemChanged,
                   [&](QTreeWidgetItem* item, int column) {
                     if (column == 2 && item->text(0) == "cast") ++changes;
                   });
  render::FrameReport report = sample();
  for (int i = 0; i < 200; ++i) {
    report.passes[1].milliseconds = 10.0 + i;
    panel.setReport(report, {});
  }
  EXPECT_EQ(changes, 0);  // no picture waits for the table
  EXPECT_TRUE(waitUntil([&] {
    return panel.findChild<QTreeWidget*>()->topLevelItemCount() == 3 &&
           panel.findChild<QTreeWidget*>()->topLevelItem(1)->text(2) == "209 ms";
  }));
}

TEST(PassesPanel, CopiesItsTable) {
  ui::PassesPanel panel;
  panel.setReport(sample(), {});
  panel.findChild<QToolButton*>()->click();
  const QStringList lines = QApplication::clipboard()->text().split('\n');
  ASSERT_GE(lines.size(), 5);
  EXPECT_EQ(lines[0], "pass\tstate\tms\tbytes\twhy");
  EXPECT_EQ(lines[2], "cast\tran\t12.5\t4000000\tcamera changed");
}

TEST_F(WindowTest, ThePassesOfTheLastPictureAreShownAndPaintingItAgainDrawsNone) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  window_->showPanel("passes");
  fullPicture(*window_);
  ui::PassesPanel* panel = window_->panel<ui::PassesPanel>();
  ASSERT_TRUE(waitUntil([&] { return panel->findChild<QTreeWidget*>()->topLevelItemCount() > 4; }));
  int reports = 0;
  QObject::connect(window_->viewport(), &ui::Viewport::reported, [&] { ++reports; });
  window_->viewport()->repaint();
  window_->viewport()->repaint();
  QTest::qWait(100);  // nothing but time: a picture would have been drawn by now
  EXPECT_EQ(reports, 0);
}

}  // namespace isolux::test
