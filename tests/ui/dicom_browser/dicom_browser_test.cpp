// The DICOM browser through its widgets: what it lists, finds, hides and opens.
#include "tests/support/ui/window_fixture.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include "tests/support/test_data.h"
#include "tests/volume/read/dicom_disc.h"
#include "ui/dicom_browser/dicom_browser.h"
#include "ui/dicom_browser/folder_opener.h"
#include "ui/dicom_browser/series_index.h"
#include "ui/document/privacy.h"
#include "ui/panels/volume_panel.h"
#include "ui/window/load_card.h"

namespace isolux::test {

namespace {

class DicomBrowserTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    disc_ = temporaryFolder() / "disc";
    writeDicomDisc(disc_);
  }

  // Opens the disc by the window, and waits until all is listed.
  ui::DicomBrowser* browse() {
    window_->openPath(QString::fromStdString(disc_.string()));
    const bool shown =
        waitUntil([&] { return window_->panel<ui::FolderOpener>()->browser() && !index()->running(); });
    EXPECT_TRUE(shown) << "no browser";
    return window_->panel<ui::FolderOpener>()->browser();
  }
  ui::SeriesIndex* index() const { return window_->panel<ui::FolderOpener>()->index(); }
  static QString allText(const ui::DicomBrowser& browser) {
    QStringList texts{browser.details()->text(), browser.summary()->text()};
    for (const QLabel* label : browser.findChildren<QLabel*>()) texts += label->text() + label->toolTip();
    for (QTreeWidgetItemIterator item(browser.findChild<QTreeWidget*>()); *item; ++item)
      for (int column = 0; column < browser.findChild<QTreeWidget*>()->columnCount(); ++column)
        texts += (*item)->text(column) + (*item)->toolTip(column);
    return texts.join('\n');
  }
  bool waitForVolume() {
    return waitUntil([&] { return window_->document()->volume() && !window_->document()->loading(); });
  }

  std::filesystem::path disc_;
};

}  // namespace

TEST_F(DicomBrowserTest, ADiscIsShownAsPatientsStudiesAndSeries) {
  ui::DicomBrowser* const browser = browse();
  ASSERT_NE(browser, nullptr);
  const QTreeWidget* const tree = browser->findChild<QTreeWidget*>();
  ASSERT_EQ(tree->topLevelItemCount(), 2);
  EXPECT_EQ(tree->topLevelItem(0)->text(0), "DOE, JANE   ID ID4711   born 1960-01-02");
  EXPECT_EQ(tree->topLevelItem(0)->childCount(), 2) << "studies";
  const QTreeWidgetItem* const study = tree->topLevelItem(0)->child(0);
  ASSERT_NE(study, nullptr);
  EXPECT_EQ(study->text(0), "Head CT   2024-01-31");
  EXPECT_EQ(study->childCount(), 3) << "series";
  const QTreeWidgetItem* const bone = browser->itemOf("1.1");
  ASSERT_NE(bone, nullptr);
  const QStringList wanted{"axial bone", "CT", "2024-01-31", "16", "16 × 16", "2 × 2 × 2 mm", "H60s", ""};
  for (int column = 0; column < wanted.size(); ++column) EXPECT_EQ(bone->text(column), wanted[column]);
  EXPECT_EQ(browser->itemOf("1.2")->text(7), "gantry tilt");
  EXPECT_EQ(browser->itemOf("1.3")->text(7), "uneven spacing, missing slices");
  EXPECT_EQ(browser->itemOf("2.1")->text(7), "mixed slices");
  EXPECT_TRUE(browser->summary()->text().contains("6 series of 2 patients"))
      << browser->summary()->text().toStdString();
  EXPECT_TRUE(browser->summary()->text().contains("1 of "));
  EXPECT_FALSE(browser->stopButton()->isVisible());
  EXPECT_EQ(window_->document()->volume(), nullptr) << "nothing is opened unasked";
  EXPECT_FALSE(window_->panel<ui::LoadCard>()->isVisible());
  browser->findChild<QTreeWidget*>()->setCurrentItem(browser->itemOf("1.2"));
  EXPECT_TRUE(browser->details()->text().contains("26.57 degrees"));
}

TEST_F(DicomBrowserTest, EachVisibleSeriesGetsASmallPicture) {
  ui::DicomBrowser* const browser = browse();
  ASSERT_NE(browser, nullptr);
  ASSERT_TRUE(waitUntil([&] { return browser->picturesComplete(); }));
  const QImage picture = browser->itemOf("1.1")->icon(0).pixmap(72, 72).toImage();
  ASSERT_FALSE(picture.isNull());
  const int side = picture.width();
  EXPECT_GT(qGray(picture.pixel(side / 2, side / 2)), 200) << "the ball";
  EXPECT_LT(qGray(picture.pixel(side / 16, side / 16)), 60) << "the air round it";
}

TEST_F(DicomBrowserTest, ADoubleClickOpensThatSeries) {
  ui::DicomBrowser* const browser = browse();
  ASSERT_NE(browser, nullptr);
  QTreeWidget* const tree = browser->findChild<QTreeWidget*>();
  tree->scrollToItem(browser->itemOf("1.4"));
  const QPoint at = tree->visualItemRect(browser->itemOf("1.4")).center();
  QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, at);
  QTest::mouseDClick(tree->viewport(), Qt::LeftButton, {}, at);
  ASSERT_TRUE(waitForVolume());
  EXPECT_EQ(window_->document()->scene().source.series, "1.4");
  EXPECT_EQ(window_->document()->volume()->grid().dims(), glm::ivec3(16, 16, 5));
  EXPECT_EQ(window_->panel<ui::FolderOpener>()->browser(), nullptr) << "the browser goes";
}

TEST_F(DicomBrowserTest, SearchAndEnterOpenWithoutAMouse) {
  ui::DicomBrowser* const browser = browse();
  ASSERT_NE(browser, nullptr);
  browser->findChild<QLineEdit*>()->setFocus();
  QTest::keyClicks(browser->findChild<QLineEdit*>(), "muster scout");
  for (const char* uid : {"1.1", "1.2", "1.3", "1.4", "2.1"})
    EXPECT_TRUE(browser->itemOf(uid)->isHidden()) << uid;
  EXPECT_FALSE(browser->itemOf("2.2")->isHidden());
  EXPECT_TRUE(browser->findChild<QTreeWidget*>()->topLevelItem(0)->isHidden())
      << "a patient without a series that is found";
  browser->findChild<QLineEdit*>()->clear();
  EXPECT_FALSE(browser->itemOf("1.1")->isHidden());
  browser->findChild<QTreeWidget*>()->setFocus();
  browser->findChild<QTreeWidget*>()->setCurrentItem(browser->itemOf("1.1"));
  QTest::keyClick(browser->findChild<QTreeWidget*>(), Qt::Key_Return);
  ASSERT_TRUE(waitForVolume());
  EXPECT_EQ(window_->document()->scene().source.series, "1.1");
}

TEST_F(DicomBrowserTest, AClickOnAHeaderSortsByNumbers) {
  ui::DicomBrowser* const browser = browse();
  ASSERT_NE(browser, nullptr);
  browser->findChild<QTreeWidget*>()->sortByColumn(3, Qt::DescendingOrder);
  const QTreeWidgetItem* const bone = browser->itemOf("1.1");
  ASSERT_NE(bone, nullptr);
  const QTreeWidgetItem* const study = bone->parent();
  ASSERT_NE(study, nullptr);
  EXPECT_EQ(study->child(0), bone) << "16 slices before 6";
  browser->findChild<QTreeWidget*>()->sortByColumn(3, Qt::AscendingOrder);
  EXPECT_EQ(study->child(2), bone);
}

TEST_F(DicomBrowserTest, HiddenPatientsAreNamedNowhere) {
  ui::DicomBrowser* const browser = browse();
  ASSERT_NE(browser, nullptr);
  EXPECT_TRUE(allText(*browser).contains("JANE"));
  browser->findChild<QCheckBox*>()->click();
  EXPECT_TRUE(ui::savedPrivacy().hideOnScreen);
  for (QTreeWidgetItemIterator item(browser->findChild<QTreeWidget*>()); *item; ++item)
    browser->findChild<QTreeWidget*>()->setCurrentItem(*item);
  for (const char* name : {"DOE", "JANE", "MUSTER", "4711", "0815", "1960", "disc"})
    EXPECT_FALSE(allText(*browser).contains(name)) << name;
  EXPECT_EQ(browser->findChild<QTreeWidget*>()->topLevelItem(0)->text(0).section(' ', 0, 0), "anonymous");
  EXPECT_EQ(browser->itemOf("1.4")->text(0), "T1 of anonymous");
  browser->findChild<QCheckBox*>()->click();
  EXPECT_TRUE(allText(*browser).contains("JANE"));
}

TEST_F(DicomBrowserTest, ASingleSeriesOpensAtOnceAndTheMenuShowsIt) {
  const auto folder = disc_ / "DICOM" / "PA0" / "ST1";
  ASSERT_TRUE(load(*window_, QString::fromStdString(folder.string())));
  EXPECT_EQ(window_->document()->volume()->grid().dims().z, 5);
  EXPECT_EQ(window_->panel<ui::FolderOpener>()->browser(), nullptr);
  QTest::keyClick(window_.get(), Qt::Key_D, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_NE(window_->panel<ui::FolderOpener>()->browser(), nullptr);
  EXPECT_TRUE(
      waitUntil([&] { return window_->panel<ui::FolderOpener>()->browser()->itemOf("1.4") != nullptr; }));
}

TEST_F(DicomBrowserTest, LookingThroughAFolderCanBeCancelled) {
  window_->openPath(QString::fromStdString(disc_.string()));
  ASSERT_TRUE(index()->running());
  window_->panel<ui::LoadCard>()->findChild<QPushButton*>()->click();
  EXPECT_FALSE(index()->running());
  QCoreApplication::processEvents();
  EXPECT_EQ(window_->panel<ui::FolderOpener>()->browser(), nullptr);
  EXPECT_EQ(window_->document()->volume(), nullptr);
  // And then opened after all.
  EXPECT_NE(browse(), nullptr);
}

TEST_F(DicomBrowserTest, AFolderWithoutDicomSaysWhatItIsNot) {
  writeBytes(disc_ / "plain" / "notes.txt", "nothing");
  EXPECT_FALSE(load(*window_, QString::fromStdString((disc_ / "plain").string())));
  EXPECT_EQ(window_->panel<ui::FolderOpener>()->browser(), nullptr);
}

}  // namespace isolux::test
