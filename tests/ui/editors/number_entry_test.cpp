// Numbers typed into the window: what is shown, what is kept, what is said when one is refused.
#include "tests/support/ui/window_fixture.h"

#include <QAction>
#include <QDialog>
#include <QHelpEvent>
#include <QLineEdit>
#include <QTest>
#include <QToolTip>

#include "ui/editors/setting_editor.h"
#include "ui/panels/settings_panel.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::test {
namespace {

class NumberEntryTest : public testing::Test {
 protected:
  NumberEntryTest() {
    box_.setRange(-1e6, 1e6);
    box_.setToolTip("What it means");
    window_.resize(300, 60);
    other_.move(0, 30);
    window_.show();
    window_.activateWindow();
    EXPECT_TRUE(QTest::qWaitForWindowActive(&window_, 120000));
    other_.setFocus();
  }
  QWidget window_;
  ui::NumberSpinBox box_{&window_};
  QLineEdit other_{&window_};
};

TEST_F(NumberEntryTest, FourDigitsAreShownAndAllAreKept) {
  box_.showValue(-243.4837123);
  EXPECT_EQ(box_.text(), "-243.5");
  QHelpEvent hover(QEvent::ToolTip, QPoint(3, 3), box_.mapToGlobal(QPoint(3, 3)));
  QCoreApplication::sendEvent(&box_, &hover);
  EXPECT_EQ(QToolTip::text(), "-243.4837123\n\nWhat it means");
  QToolTip::hideText();
  box_.setFocus();
  EXPECT_EQ(box_.text(), "-243.4837123") << "all digits can be edited";
  QTest::keyClick(&box_, Qt::Key_Return);
  other_.setFocus();
  EXPECT_EQ(box_.text(), "-243.5");
  EXPECT_EQ(box_.value(), -243.4837123) << "not edited, not rounded";
  box_.setFocus();
  box_.selectAll();
  QTest::keyClicks(&box_, "-243.5");
  other_.setFocus();
  EXPECT_EQ(box_.value(), -243.5) << "typed is typed";
}

TEST_F(NumberEntryTest, UndoPutsBackWhatIsTypedAndElseIsTheWindows) {
  QAction undo(&window_);
  undo.setShortcut(QKeySequence::Undo);
  window_.addAction(&undo);
  int undone = 0;
  QObject::connect(&undo, &QAction::triggered, [&] { ++undone; });
  ui::IntegerSpinBox whole(&window_);
  whole.setRange(0, 1000);
  whole.setSuffix(" %");
  whole.move(120, 0);
  whole.show();
  for (QAbstractSpinBox* box :
       {static_cast<QAbstractSpinBox*>(&box_), static_cast<QAbstractSpinBox*>(&whole)}) {
    undone = 0;
    const auto type = [&](const QString& text) {
      box->selectAll();
      QTest::keyClicks(box, text);
    };
    box->setFocus();
    type("12");
    QTest::keyClick(box, Qt::Key_Return);
    const QString twelve = box->text();
    type("999");
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(box->text(), twelve) << "999 was not entered";
    EXPECT_EQ(undone, 0);
    type("999");
    QTest::keyClick(box, Qt::Key_Return);
    const QString entered = box->text();
    QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_EQ(undone, 1) << "at once, with the focus still in the field";
    EXPECT_EQ(box->text(), entered) << "the window says what it is now";
  }
}

TEST_F(NumberEntryTest, InADialogUndoBringsTheNumberBackThatWasEnteredBefore) {
  QDialog dialog;
  ui::NumberSpinBox box(&dialog);
  dialog.show();
  dialog.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog, 120000));
  box.setValue(12.0);
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, "999");
  QTest::keyClick(&box, Qt::Key_Enter);
  box.selectAll();
  QTest::keyClicks(&box, "7.5");
  QTest::keyClick(&box, Qt::Key_Enter);
  EXPECT_EQ(box.value(), 7.5);
  QTest::keyClick(&box, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(box.value(), 999.0);
  EXPECT_EQ(box.text(), "999");
}

TEST_F(NumberEntryTest, ANumberOutOfRangeIsRefusedInWordsAndTheOldOneStays) {
  ui::SettingsPanel panel;
  panel.resize(360, 700);
  panel.show();
  panel.setScene({}, {});
  QStringList said;
  int edits = 0;
  QObject::connect(&panel, &ui::SettingsPanel::failed, [&](const QString& text) { said += text; });
  QObject::connect(&panel, &ui::SettingsPanel::edited, [&] { ++edits; });
  const auto enter = [&](const char* path, const QString& text) {
    said.clear();
    auto* box = panel.editor(path)->findChild<QAbstractSpinBox*>();
    box->selectAll();
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
    return box->text();
  };
  EXPECT_EQ(enter("look.ambient", "5"), ui::NumberSpinBox().textFromValue(scene::Scene{}.look.ambient));
  ASSERT_FALSE(said.isEmpty());
  EXPECT_EQ(said.front(), "Ambient: 5 is out of range (0 … 1)");
  EXPECT_EQ(enter("picture.supersampling", "99"), QString::number(scene::Scene{}.picture.supersampling));
  ASSERT_FALSE(said.isEmpty());
  EXPECT_TRUE(said.front().contains("99 is out of range (1 … 4)")) << said.front().toStdString();
  EXPECT_EQ(edits, 0);
  enter("look.ambient", "0.5");
  EXPECT_TRUE(said.isEmpty());
  EXPECT_EQ(edits, 1);
}

}  // namespace
}  // namespace isolux::test
