// The first start: hints once, and a tour that goes on when the user has done what it says.
#include "tests/support/ui/window_fixture.h"

#include <stdexcept>

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

template <class Object>
Object& existing(Object* object) {
  if (object == nullptr) throw std::logic_error("it is not there");
  return *object;
}

bool isThere(const QWidget* widget) {
  return widget != nullptr && widget->isVisible();
}

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
    return waitUntil([&] { return window_->tour() != nullptr && existing(window_->tour()).step() == step; });
  }
};

}  // namespace

TEST_F(TourTest, HintsAreShownOnceAndLeadToTheTour) {
  window_->greet();
  ASSERT_TRUE(waitUntil([&] { return isThere(window_->greeting()); }));
  QPointer<ui::TourCard> card = window_->greeting();
  const auto isInPicture = [&] {
    const ui::Viewport* const picture = window_->viewport();
    return picture->rect()
        .translated(picture->mapTo(window_.get(), QPoint()))
        .contains(existing(window_->greeting()).geometry());
  };
  EXPECT_TRUE(isInPicture());
  window_->resize(window_->width(), window_->height() - 120);
  EXPECT_TRUE(waitUntil(isInPicture)) << "it goes with the picture";
  QTest::mouseClick(existing(window_->greeting()).leaveButton(), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return card.isNull(); }));
  window_->greet();
  EXPECT_EQ(window_->greeting(), nullptr) << "once";
  QSettings().remove("hints");
  window_->greet();
  ASSERT_TRUE(waitUntil([&] { return isThere(window_->greeting()); }));
  QTest::mouseClick(existing(window_->greeting()).nextButton(), Qt::LeftButton);
  EXPECT_NE(window_->tour(), nullptr);
  window_->greet();
  EXPECT_EQ(window_->greeting(), nullptr);
}

// Two cards in one place would hide one another.
TEST_F(TourTest, HintsMakeRoomForTheCardOfALoad) {
  window_->greet();
  ASSERT_TRUE(waitUntil([&] { return isThere(window_->greeting()); }));
  window_->document()->open("phantom:head:256");
  EXPECT_FALSE(isThere(window_->greeting()));
  window_->document()->cancelLoading();
  EXPECT_TRUE(waitUntil([&] { return isThere(window_->greeting()); }));
  window_->document()->open("phantom:ball:24");
  EXPECT_FALSE(isThere(window_->greeting()));
  ASSERT_TRUE(waitUntil([&] { return !window_->document()->loading(); }));
  EXPECT_TRUE(waitUntil([&] { return isThere(window_->greeting()); }));
}

TEST_F(TourTest, EachStepWaitsForTheRealControl) {
  window_->startTour();
  ASSERT_NE(window_->tour(), nullptr);
  QPointer<ui::Tour> tour = window_->tour();
  ui::TourCard* card = existing(window_->tour()).card();
  EXPECT_TRUE(isThere(card));
  const QWidget& frame = existing(window_->findChild<QWidget*>("tourFrame"));
  EXPECT_TRUE(isThere(&frame));
  // The frame stands about the widget, and the card beside it.
  const QRect histogram(window_->panel<ui::IsovaluePanel>()->mapTo(window_.get(), QPoint()),
                        window_->panel<ui::IsovaluePanel>()->size());
  EXPECT_TRUE(frame.geometry().intersects(histogram));
  EXPECT_FALSE(card->geometry().intersects(histogram));

  QTest::keyClick(window_->panel<ui::HistogramSlider>(), Qt::Key_PageUp);
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
  existing(window_->findChild<ui::PictureDialog*>()).reject();
  bool complete = false;
  QObject::connect(window_->tour(), &ui::Tour::ended, [&](bool whole) { complete = whole; });
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
  QTest::mouseClick(existing(window_->tour()).card()->nextButton(), Qt::LeftButton);
  EXPECT_EQ(existing(window_->tour()).step(), 1u);
  window_->viewport()->setFocus();
  QTest::keyClick(window_->viewport(), Qt::Key_Escape);
  ASSERT_TRUE(waitUntil([&] { return tour.isNull(); }));
  EXPECT_EQ(window_->document()->scene(), before) << "the tour edits nothing";
}

}  // namespace isolux::test
