// The list of labels: what it says of a label map, and showing, hiding, isolating and finding labels in it.
#include <QAbstractButton>
#include <QLineEdit>
#include <QTreeWidget>

#include "tests/support/label_volumes.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/panels/labels_panel.h"
#include "ui/panels/surface_list.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::test {
namespace {

class LabelsPanelTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    const QString file = newFile("labels.mha");
    volume::writeVolume(threeLabels(), file.toStdString());
    ASSERT_TRUE(load(*window_, file));
    window_->showPanel("Labels");
  }
  ui::LabelsPanel* panel() { return window_->panel<ui::LabelsPanel>(); }
  QTreeWidgetItem* row(int index) { return panel()->list()->topLevelItem(index); }
  std::string shown() { return window_->document()->scene().source.labels; }
  std::vector<int> inField() { return window_->document()->volume()->labels->mask.labels; }
  bool waitFor(const std::string& labels) {
    return waitUntil([&] { return shown() == labels && panel()->list()->topLevelItemCount() > 0; });
  }
  void press(const char* text) {
    for (QAbstractButton* button : panel()->findChildren<QAbstractButton*>())
      if (button->text() == text) return button->click();
    FAIL() << text;
  }
};

TEST_F(LabelsPanelTest, ListsThemAndShowsThoseThatAreChecked) {
  ASSERT_EQ(panel()->list()->topLevelItemCount(), 4);
  EXPECT_EQ(row(0)->text(0), "Background");
  EXPECT_EQ(row(0)->checkState(0), Qt::Unchecked);
  EXPECT_EQ(row(2)->text(1), "2");
  EXPECT_EQ(row(2)->checkState(0), Qt::Checked);
  row(2)->setCheckState(0, Qt::Unchecked);
  ASSERT_TRUE(waitFor("1,3")) << shown();
  EXPECT_EQ(inField(), (std::vector<int>{1, 3}));
  EXPECT_EQ(window_->document()->history().undoName(), "Hide Label 2");
  window_->document()->undo();
  ASSERT_TRUE(waitUntil([&] { return inField() == std::vector<int>{1, 2, 3}; }));
  EXPECT_EQ(row(2)->checkState(0), Qt::Checked);
}

TEST_F(LabelsPanelTest, IsolatesHidesAndShowsAll) {
  row(3)->setSelected(true);
  press("Show only");
  ASSERT_TRUE(waitFor("3"));
  EXPECT_EQ(row(1)->checkState(0), Qt::Unchecked);
  row(3)->setCheckState(0, Qt::Unchecked);  // the last one
  EXPECT_EQ(row(3)->checkState(0), Qt::Checked) << "one stays";
  press("Show all");
  ASSERT_TRUE(waitFor(""));
  EXPECT_EQ(inField(), (std::vector<int>{1, 2, 3}));
}

TEST_F(LabelsPanelTest, FindsByNameAndValue) {
  panel()->searchLine()->setText("3");
  EXPECT_TRUE(row(1)->isHidden());
  EXPECT_FALSE(row(3)->isHidden());
  panel()->searchLine()->setText("backG");
  EXPECT_FALSE(row(0)->isHidden());
  EXPECT_TRUE(row(3)->isHidden());
  panel()->searchLine()->clear();
  EXPECT_FALSE(row(3)->isHidden());
}

TEST_F(LabelsPanelTest, WithoutLabelsItSaysSo) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  EXPECT_FALSE(panel()->list()->isVisibleTo(panel()));
}

TEST_F(LabelsPanelTest, GivesLabelsASurfaceOfTheirOwn) {
  EXPECT_FALSE(panel()->surfaces()->isVisible()) << "one surface needs no list";
  row(2)->setSelected(true);
  press("Own surface");
  ASSERT_TRUE(waitUntil([&] { return window_->document()->scene().surfaces.size() == 2; }));
  const scene::Surface made = window_->document()->scene().surfaces.back();
  EXPECT_EQ(made.labels, "2");
  EXPECT_LT(made.opacity, 1.0);
  ASSERT_EQ(panel()->surfaces()->rows().size(), 2u);
  EXPECT_TRUE(panel()->surfaces()->isVisible());
  const ui::SurfaceList::Row& own = panel()->surfaces()->rows().back();
  EXPECT_EQ(own.labels->text(), "2");
  EXPECT_FALSE(own.value->isVisible());
  own.labels->setText("2-3");
  Q_EMIT own.labels->editingFinished();
  EXPECT_EQ(window_->document()->scene().surfaces.back().labels, "2-3");
  row(2)->setSelected(false);
  row(3)->setSelected(true);
  press("Own surface");
  ASSERT_TRUE(waitUntil([&] { return window_->document()->scene().surfaces.size() == 3; }));
  EXPECT_EQ(window_->document()->scene().surfaces[1].labels, "2") << "3 has left it";
  window_->document()->undo();
  EXPECT_EQ(window_->document()->scene().surfaces.size(), 2u);
}

}  // namespace
}  // namespace isolux::test
