// The first start: hints once, and a tour that goes on when the user has done what it says.
#include "tests/support/ui/window_fixture.h"

#include <QAction>
#include <QComboBox>
#include <QPointer>
#include <QPushButton>
#include <QSettings>
#include <QTest>

#include "ui/dialogs/picture_dialog.h"
#include "ui/editors/histogram_slider.h"
#include "ui/panels/isovalue_panel.h"
#include "ui/slices/slice_board.h"
#include "ui/tour/tour.h"
#include "ui/tour/tour_card.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

class TourTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    QSettings().remove("hints");
    ASSERT_TRUE(load(*window_, "phantom:ball:24"));
    fullPicture(*window_);
  }
  void TearDown() override {
    QSettings().remove("hints");
    WindowTest::TearDown();
  }
  bool comesTo(std::size_t step) {
    return waitUntil([&] { return window_->tour() && window_->tour()->step() == step; });
  }
};

}  // namespace

TEST_F(TourTest, HintsAreShownOnceAndLeadToTheTour) {
  window_->greet();
  ASSERT_TRUE(waitUntil([&] { return window_->greeting() && window_->greeting()->isVisible(); }));
  QPointer<ui::TourCard> card = window_->greeting();
  EXPECT_TRUE(window_->viewport()
                  ->rect()
                  .translated(window_->viewport()->mapTo(window_.get(), QPoint()))
                  .contains(card->geometry()));
  QTest::mouseClick(card->leaveButton(), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return card.isNull(); }));
  window_->greet();
  EXPECT_EQ(window_->greeting(), nullptr) << "once";
  QSettings().remove("hints");
  window_->greet();
  ASSERT_TRUE(waitUntil([&] { return window_->greeting() && window_->greeting()->isVisible(); }));
  QTest::mouseClick(window_->greeting()->nextButton(), Qt::LeftButton);
  EXPECT_NE(window_->tour(), nullptr);
  window_->greet();
  EXPECT_EQ(window_->greeting(), nullptr);
}

TEST_F(TourTest, EachStepWaitsForTheRealControl) {
  window_->startTour();
  ASSERT_NE(window_->tour(), nullptr);
  QPointer<ui::Tour> tour = window_->tour();
  ui::TourCard* card = tour->card();
  EXPECT_TRUE(card->isVisible());
  EXPECT_TRUE(card->frame()->isVisible());
  // The frame stands about the widget, and the card beside it.
  const QRect histogram(window_->isovaluePanel()->mapTo(window_.get(), QPoint()),
                        window_->isovaluePanel()->size());
  EXPECT_TRUE(card->frame()->geometry().intersects(histogram));
  EXPECT_FALSE(card->geometry().intersects(histogram));

  QTest::keyClick(window_->isovaluePanel()->slider(), Qt::Key_PageUp);
  ASSERT_TRUE(comesTo(1));
  drag(window_->viewport(), {200, 200}, {260, 220});
  ASSERT_TRUE(comesTo(2));
  window_->lookChoice()->setFocus();
  QTest::keyClick(window_->lookChoice(), Qt::Key_Down);
  ASSERT_TRUE(comesTo(3));
  QTest::keyClick(window_.get(), Qt::Key_F4);
  ASSERT_TRUE(comesTo(4));
  QTest::keyClick(window_.get(), Qt::Key_E, Qt::ControlModifier);
  ASSERT_TRUE(comesTo(5));
  QPointer<ui::PictureDialog> dialog = window_->findChild<ui::PictureDialog*>();
  ASSERT_FALSE(dialog.isNull());
  dialog->reject();
  bool complete = false;
  QObject::connect(tour, &ui::Tour::ended, [&](bool whole) { complete = whole; });
  EXPECT_EQ(card->nextButton()->text(), "Done");
  QTest::mouseClick(card->nextButton(), Qt::LeftButton);
  EXPECT_TRUE(complete);
  ASSERT_TRUE(waitUntil([&] { return tour.isNull(); }));
  EXPECT_EQ(window_->tour(), nullptr);
  EXPECT_EQ(window_->findChild<ui::TourCard*>(), nullptr);
}

TEST_F(TourTest, StepsCanBeSkippedAndTheTourBeLeftByEscape) {
  window_->startTour();
  QPointer<ui::Tour> tour = window_->tour();
  const scene::Scene before = window_->document()->scene();
  QTest::mouseClick(tour->card()->nextButton(), Qt::LeftButton);
  EXPECT_EQ(tour->step(), 1u);
  window_->viewport()->setFocus();
  QTest::keyClick(window_->viewport(), Qt::Key_Escape);
  ASSERT_TRUE(waitUntil([&] { return tour.isNull(); }));
  EXPECT_EQ(window_->document()->scene(), before) << "the tour edits nothing";
}

}  // namespace isolux::test
