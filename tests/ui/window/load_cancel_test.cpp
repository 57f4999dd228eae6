// A load that is cancelled in the window. How much of it goes on then:
// tests/volume/read/stopped_load_test.cpp.
#include <QPushButton>
#include <QTest>

#include "tests/support/ui/window_fixture.h"
#include "ui/window/load_card.h"

namespace isolux::test {

TEST_F(WindowTest, TheButtonThatCancelsALoadIsAnsweredInThatMoment) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  const auto before = window_->document()->volume();
  window_->openPath("phantom:head:512");  // half a minute of the processor
  ASSERT_TRUE(waitUntil([&] {
    return window_->panel<ui::LoadCard>()->findChild<QPushButton*>()->isVisible() ||
           !window_->document()->loading();
  }));
  ASSERT_TRUE(window_->document()->loading()) << "it was loaded before it could be cancelled";
  QTest::mouseClick(window_->panel<ui::LoadCard>()->findChild<QPushButton*>(), Qt::LeftButton);
  EXPECT_FALSE(window_->document()->loading());
  EXPECT_FALSE(window_->panel<ui::LoadCard>()->isVisible());
  EXPECT_EQ(window_->document()->volume(), before);
}

}  // namespace isolux::test
