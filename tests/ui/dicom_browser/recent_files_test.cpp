// What was opened last: its list, its pictures, and what it tells of patients.
#include "tests/support/ui/window_fixture.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QToolButton>

#include "tests/support/test_data.h"
#include "tests/volume/read/dicom_disc.h"
#include "ui/dicom_browser/recent_menu.h"
#include "ui/document/privacy.h"
#include "ui/document/recent_files.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

class RecentFilesTest : public WindowTest {
 protected:
  void SetUp() override {
    qputenv("XDG_CACHE_HOME", QByteArray::fromStdString((temporaryFolder() / "cache").string()));
    WindowTest::SetUp();
  }
  void TearDown() override {
    WindowTest::TearDown();
    qunsetenv("XDG_CACHE_HOME");
  }
  static ui::RecentMenu* menuOf(ui::MainWindow& window) { return window.findChild<ui::RecentMenu*>(); }
};

}  // namespace

TEST_F(RecentFilesTest, LeavingADocumentKeepsItsPicture) {
  const QString ball = writeBall(24);
  ASSERT_TRUE(load(*window_, ball));
  const QImage shown = fullPicture(*window_);
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  const auto files = ui::recentEntries();
  ASSERT_EQ(files.size(), 2);
  EXPECT_EQ(files[0].path, "phantom:ball:16");
  EXPECT_EQ(files[1].path, ball);
  const QString picture = ui::recentPicture(files[1]);
  ASSERT_TRUE(waitUntil([&] { return QFileInfo(picture).size() > 0; }));
  const QImage small(picture);
  ASSERT_FALSE(small.isNull());
  EXPECT_LE(small.width(), 256);
  EXPECT_LE(small.height(), 160);
  EXPECT_LT(
      differingPixels(small, shown.scaled(small.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation), 24),
      0.02)
      << "it is what was on screen";
  // The menu has them, and clearing the list removes the pictures.
  menuOf(*window_)->fill();
  const QList<QAction*> entries = menuOf(*window_)->actions();
  ASSERT_GE(entries.size(), 3);
  EXPECT_EQ(entries[1]->text(), "ball.mhd");
  EXPECT_FALSE(entries[1]->icon().isNull());
  entries.last()->trigger();
  EXPECT_TRUE(ui::recentEntries().isEmpty());
  EXPECT_FALSE(QFileInfo::exists(picture));
}

TEST_F(RecentFilesTest, AtMostTwentyAndTheirPicturesGoWithThem) {
  QImage picture(32, 20, QImage::Format_RGB32);
  picture.fill(Qt::red);
  const ui::RecentFile first{"/scans/0", {}, "0", "0"};
  ui::addRecentFile({first});
  ui::keepRecentPicture(first, picture);
  ASSERT_TRUE(waitUntil([&] { return QFileInfo::exists(ui::recentPicture(first)); }));
  for (int i = 1; i < 20; ++i) ui::addRecentFile({QString("/scans/%1").arg(i)});
  EXPECT_EQ(ui::recentEntries().size(), 20);
  EXPECT_TRUE(QFileInfo::exists(ui::recentPicture(first)));
  ui::addRecentFile({"/scans/20"});
  EXPECT_EQ(ui::recentEntries().size(), 20);
  EXPECT_FALSE(ui::recentFiles().contains("/scans/0"));
  EXPECT_FALSE(QFileInfo::exists(ui::recentPicture(first)));
  // What is not in the list gets no picture.
  ui::keepRecentPicture(first, picture);
  QCoreApplication::processEvents();
  EXPECT_FALSE(QFileInfo::exists(ui::recentPicture(first)));
}

TEST_F(RecentFilesTest, ListsOfEarlierVersionsAreRead) {
  QSettings().setValue("recentFiles", QStringList{"/scans/a.nii.gz", "phantom:head"});
  EXPECT_EQ(ui::recentFiles(), (QStringList{"/scans/a.nii.gz", "phantom:head"}));
  EXPECT_EQ(ui::shownName(ui::recentEntries()[0]), "a.nii.gz");
}

TEST_F(RecentFilesTest, ASeriesOpensAgainAndHidesItsPatient) {
  const auto disc = temporaryFolder() / "DOE_JANE";
  writeDicomDisc(disc);
  bool loaded = false;
  const auto connection =
      QObject::connect(window_->document(), &ui::Document::loadEnded, [&](bool good) { loaded = good; });
  window_->openSeries(QString::fromStdString(disc.string()), "1.4");
  ASSERT_TRUE(waitUntil([&] { return loaded; }));
  QObject::disconnect(connection);
  const auto files = ui::recentEntries();
  ASSERT_EQ(files.size(), 1);
  EXPECT_EQ(files[0].series, "1.4");
  EXPECT_EQ(ui::shownName(files[0]), "T1 of DOE – DOE_JANE");
  ui::keepPrivacy({.hideOnScreen = true, .hideInSaved = true});
  window_->applyPrivacy();
  EXPECT_EQ(ui::shownName(files[0]), "T1 of anonymous – anonymous");
  menuOf(*window_)->fill();
  EXPECT_FALSE(menuOf(*window_)->actions().first()->toolTip().contains("DOE"));
  // Another volume, and back.
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  menuOf(*window_)->fill();
  loaded = false;
  const auto again =
      QObject::connect(window_->document(), &ui::Document::loadEnded, [&](bool good) { loaded = good; });
  menuOf(*window_)->actions()[1]->trigger();
  ASSERT_TRUE(waitUntil([&] { return loaded; }));
  QObject::disconnect(again);
  EXPECT_EQ(window_->document()->scene().source.series, "1.4");
}

TEST_F(RecentFilesTest, AWindowWithoutAVolumeOffersThem) {
  ASSERT_TRUE(load(*window_, "phantom:ball:16"));
  EXPECT_FALSE(window_->panel<ui::RecentPictures>()->isVisible());
  auto other = makeWindow();
  ASSERT_TRUE(waitUntil([&] { return other->panel<ui::RecentPictures>()->isVisible(); }));
  auto* const button = other->panel<ui::RecentPictures>()->findChild<QToolButton*>();
  ASSERT_NE(button, nullptr);
  button->click();
  ASSERT_TRUE(waitUntil([&] { return other->document()->volume() != nullptr; }));
  EXPECT_TRUE(waitUntil([&] { return !other->panel<ui::RecentPictures>()->isVisible(); }));
}

}  // namespace isolux::test
