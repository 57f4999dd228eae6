// Pieces by hand: what the status line, the menu and the list say of three balls, and what they do to them.
#include "tests/support/ui/window_fixture.h"

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QStatusBar>
#include <QTest>
#include <QTreeWidget>

#include <glm/geometric.hpp>

#include "scene/camera.h"
#include "tests/support/test_data.h"
#include "ui/panels/pieces_panel.h"
#include "ui/viewport/viewport.h"
#include "volume/pieces/piece_sets.h"

namespace isolux::test {
namespace {

struct Ball {
  glm::dvec3 middle;  // mm
  double radius;
  double volume() const { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }
};
// The largest first; none before another as seen from the front.
constexpr std::array<Ball, 3> kBalls{
    {{{13.0, 20.0, 14.0}, 9.0}, {{36.0, 20.0, 16.0}, 7.0}, {{22.0, 20.0, 38.0}, 5.0}}};

// 100 times the distance to the nearest surface, inside positive, cut at 2 voxels.
QString writeBalls() {
  constexpr int size = 48;
  const std::filesystem::path folder = temporaryFolder();
  std::vector<std::int16_t> voxels;
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        double depth = -2.0;
        for (const Ball& ball : kBalls)
          depth = std::max(depth, ball.radius - glm::length(glm::dvec3(x, y, z) - ball.middle));
        voxels.push_back(static_cast<std::int16_t>(std::lround(100.0 * std::min(depth, 2.0))));
      }
  std::ofstream data(folder / "balls.raw", std::ios::binary);
  data.write(reinterpret_cast<const char*>(voxels.data()), static_cast<std::streamsize>(voxels.size() * 2));
  std::ofstream(folder / "balls.mhd")
      << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
      << "ElementSpacing = 1 1 1\nDimSize = 48 48 48\nElementType = MET_SHORT\nElementDataFile = balls.raw\n";
  return QString::fromStdString((folder / "balls.mhd").string());
}

class PiecesTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, writeBalls()));
    setIsovalue(0.0);
    fullPicture(*window_);
  }
  void setIsovalue(double value) {
    ui::Edit edit{scene(), "Set isovalue", {}, false};
    edit.scene.surfaces.front().value = value;
    window_->document()->edit(edit);
  }
  const scene::Scene& scene() { return window_->document()->scene(); }
  std::string lastStep() { return window_->document()->history().undoName(); }
  const volume::PieceSets& pieces() { return *window_->document()->volume()->pieces; }
  ui::PiecesPanel* panel() { return window_->panel<ui::PiecesPanel>(); }
  QString pointedText() { return window_->statusBar()->findChild<QLabel*>()->text(); }

  QPoint onScreen(const Ball& ball) {
    const scene::CameraFrame f = scene::frameOf(window_->document()->resolvedScene().camera);
    const glm::dvec3 v = ball.middle - f.eye;
    const QWidget* picture = window_->viewport();
    const double scale = 0.5 * picture->height() / (f.halfHeight * -glm::dot(v, f.back));
    return QPointF(0.5 * picture->width() + scale * glm::dot(v, f.right),
                   0.5 * picture->height() - scale * glm::dot(v, f.up))
        .toPoint();
  }
  bool sees(const Ball& ball) {
    std::optional<app::Pick> seen;
    bool reported = false;
    const auto connection = QObject::connect(window_->viewport(), &ui::Viewport::menuAsked,
                                             [&](const QPoint&, const std::optional<app::Pick>& pick) {
                                               seen = pick;
                                               reported = true;
                                             });
    rightClick(ball);
    EXPECT_TRUE(reported);
    QObject::disconnect(connection);
    closeMenu();
    return seen && std::abs(glm::length(seen->worldMm - ball.middle) - ball.radius) < 0.1;
  }
  void rightClick(const Ball& ball) {
    QTest::mouseClick(window_->viewport(), Qt::RightButton, Qt::NoModifier, onScreen(ball));
  }
  QMenu* menu() {
    for (QMenu* one : window_->findChildren<QMenu*>("surface"))
      if (one->isVisible()) return one;
    return nullptr;
  }
  void closeMenu() {
    if (QMenu* open = menu()) open->close();
    EXPECT_TRUE(waitUntil([&] { return window_->findChildren<QMenu*>("surface").isEmpty(); }));
  }
  void choose(const Ball& ball, const QString& entry) {
    rightClick(ball);
    ASSERT_TRUE(waitUntil([&] { return menu() != nullptr; }));
    QAction* wanted = nullptr;
    for (QAction* action : menu()->actions())
      if (action->text().remove('&') == entry) wanted = action;
    ASSERT_TRUE(wanted) << entry.toStdString();
    ASSERT_TRUE(wanted->isEnabled());
    // As a hand does: Qt 6.8 takes a click without a movement for the end of the one that opened the menu.
    const QPoint at = menu()->actionGeometry(wanted).center();
    QTest::mouseMove(menu(), at);
    QTest::mouseClick(menu(), Qt::LeftButton, Qt::NoModifier, at);
    EXPECT_TRUE(waitUntil([&] { return window_->findChildren<QMenu*>("surface").isEmpty(); }));
  }
  // Of the picture that shows the choice.
  void expectSeen(std::array<bool, 3> seen) {
    fullPicture(*window_);
    for (std::size_t i = 0; i < kBalls.size(); ++i) EXPECT_EQ(sees(kBalls[i]), seen[i]) << i;
  }

  // The list, with errors and boxes.
  QTreeWidget* measuredList() {
    window_->showPanel("Pieces");
    EXPECT_TRUE(waitUntil([&] { return panel()->measured() && !panel()->working(); }));
    return panel()->list();
  }
  void press(const QString& button) {
    for (QPushButton* one : panel()->findChildren<QPushButton*>())
      if (one->text() == button) {
        EXPECT_TRUE(one->isEnabled()) << button.toStdString();
        QTest::mouseClick(one, Qt::LeftButton);
        return;
      }
    ADD_FAILURE() << "no button " << button.toStdString();
  }
  void clickRow(int row, int column = 1, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTreeWidget* list = panel()->list();
    const QRect place = list->visualRect(list->model()->index(row, column));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, modifiers, place.center());
  }
};

TEST_F(PiecesTest, PointingSaysHowLargeThePieceIs) {
  EXPECT_FALSE(pieces().any());
  for (std::size_t i = 0; i < kBalls.size(); ++i) {
    QTest::mouseMove(window_->viewport(), onScreen(kBalls[i]) + QPoint(2, 0));
    QTest::mouseMove(window_->viewport(), onScreen(kBalls[i]));
    const QString which = QString("piece %1 (").arg(i);
    ASSERT_TRUE(waitUntil([&] { return pointedText().contains(which); })) << pointedText().toStdString();
    QString number = pointedText().section(": ", -1).remove(" mm³").remove(QChar(0x202F));
    EXPECT_NEAR(number.toDouble(), kBalls[i].volume(), 0.03 * kBalls[i].volume());  // trilinear
  }
  EXPECT_TRUE(pointedText().contains("(of 3)"));
}

TEST_F(PiecesTest, TheMenuHidesAndIsolatesWhatWasClicked) {
  expectSeen({true, true, true});
  choose(kBalls[1], "Hide this piece");
  EXPECT_EQ(lastStep(), "Hide piece");
  EXPECT_EQ(scene().pieces.hidden.size(), 1u);
  expectSeen({true, false, true});
  choose(kBalls[0], "Hide this piece");
  expectSeen({false, false, true});
  window_->document()->undo();  // a step each
  expectSeen({true, false, true});
  choose(kBalls[2], "Show only this piece");
  EXPECT_EQ(lastStep(), "Show only one piece");
  EXPECT_TRUE(scene().pieces.hidden.empty());
  expectSeen({false, false, true});
  choose(kBalls[2], "Keep the largest piece");
  EXPECT_EQ(lastStep(), "Keep the largest piece");
  expectSeen({true, false, false});
  choose(kBalls[0], "Show all pieces");
  EXPECT_EQ(scene().pieces, scene::Pieces{});
  expectSeen({true, true, true});
}

// No piece is missing in silence: the picture says so, and a click brings them back.
TEST_F(PiecesTest, ThePictureSaysHowManyAreHidden) {
  auto* caveats = window_->viewport()->findChild<QPushButton*>("caveats");
  EXPECT_FALSE(caveats->isVisible());
  ui::Edit edit{scene(), "Keep the largest piece", {}, false};
  edit.scene.pieces.keep = 1;
  window_->document()->edit(edit);
  fullPicture(*window_);
  EXPECT_TRUE(caveats->isVisible());
  EXPECT_EQ(caveats->text(), "2 of 3 pieces hidden – Show");
  EXPECT_TRUE(window_->viewport()->rect().contains(caveats->geometry()));
  QTest::mouseClick(caveats, Qt::LeftButton);
  EXPECT_EQ(lastStep(), "Show all pieces");
  EXPECT_EQ(scene().pieces, scene::Pieces{});
  fullPicture(*window_);
  EXPECT_FALSE(caveats->isVisible());
}

// What was hidden by hand stays hidden when the isovalue moves.
TEST_F(PiecesTest, APieceStaysHiddenWhenTheIsovalueMoves) {
  choose(kBalls[1], "Hide this piece");
  setIsovalue(180.0);
  fullPicture(*window_);
  EXPECT_FALSE(sees(kBalls[1]));
}

TEST_F(PiecesTest, ARightDragZoomsAndOpensNothing) {
  const QPoint at = onScreen(kBalls[0]);
  drag(window_->viewport(), at, at - QPoint(0, 40), Qt::RightButton);
  EXPECT_EQ(lastStep(), "Zoom");
  EXPECT_EQ(menu(), nullptr);
}

TEST_F(PiecesTest, TheMenuKeyAsksToo) {
  QTest::mouseMove(window_->viewport(), onScreen(kBalls[0]));
  const QPoint at = onScreen(kBalls[0]);
  QContextMenuEvent key(QContextMenuEvent::Keyboard, at, window_->viewport()->mapToGlobal(at));
  QCoreApplication::sendEvent(window_->viewport(), &key);
  EXPECT_TRUE(waitUntil([&] { return menu() != nullptr; }));
  closeMenu();
}

TEST(PiecesPanel, SaysWhatToDoWithoutAVolume) {
  ui::PiecesPanel panel;
  panel.resize(350, 500);
  panel.show();
  EXPECT_TRUE(panel.state().contains("Open a volume")) << panel.state().toStdString();
  EXPECT_FALSE(panel.list()->isVisible());
}

TEST_F(PiecesTest, ThePanelWorksOnlyWhileItIsSeen) {
  EXPECT_FALSE(panel()->working());
  EXPECT_FALSE(pieces().any());
  measuredList();
  EXPECT_TRUE(pieces().any());
  window_->showPanel("Settings");
  setIsovalue(50.0);
  fullPicture(*window_);
  EXPECT_FALSE(panel()->working());
  EXPECT_FALSE(pieces().find(50.0, scene::Inside::above));
}

TEST_F(PiecesTest, TheListHasVolumesWithErrorsAndBoxes) {
  const QTreeWidget* list = measuredList();
  ASSERT_EQ(list->topLevelItemCount(), 3);
  EXPECT_TRUE(panel()->state().startsWith("3 pieces at 0")) << panel()->state().toStdString();
  for (int i = 0; i < 3; ++i) {
    const Ball& ball = kBalls[static_cast<std::size_t>(i)];
    const QTreeWidgetItem* row = list->topLevelItem(i);
    EXPECT_EQ(row->text(0), QString::number(i));
    const QStringList volume = row->text(1).split(" ± ");
    ASSERT_EQ(volume.size(), 2) << row->text(1).toStdString();
    EXPECT_NEAR(volume[0].toDouble(), ball.volume(), volume[1].toDouble() + 0.01 * ball.volume());
    EXPECT_NEAR(row->text(2).section(" × ", 0, 0).toDouble(), 2.0 * ball.radius, 0.3);
    EXPECT_EQ(row->checkState(0), Qt::Checked);
  }
  setIsovalue(190.0);  // 1.9 voxels inward
  EXPECT_TRUE(waitUntil([&] { return panel()->state().contains("190") && panel()->measured(); }));
  EXPECT_LT(list->topLevelItem(0)->text(2).section(" × ", 0, 0).toDouble(), 15.0);
  setIsovalue(1000.0);
  EXPECT_TRUE(waitUntil([&] { return panel()->state().contains("change the isovalue"); }));
  EXPECT_FALSE(list->isVisible());
}

TEST_F(PiecesTest, ButtonsAndCheckMarksOfTheListHideAndShow) {
  const QTreeWidget* list = measuredList();
  clickRow(1);
  press("Hide");
  EXPECT_EQ(lastStep(), "Hide piece 1");
  EXPECT_EQ(list->topLevelItem(1)->checkState(0), Qt::Unchecked);
  EXPECT_TRUE(panel()->state().contains("1 hidden"));
  expectSeen({true, false, true});
  list->topLevelItem(1)->setCheckState(0, Qt::Checked);
  EXPECT_EQ(lastStep(), "Show piece 1");
  EXPECT_EQ(scene().pieces, scene::Pieces{});
  clickRow(1);
  clickRow(2, 1, Qt::ControlModifier);
  press("Show only");
  EXPECT_EQ(lastStep(), "Show only 2 pieces");
  expectSeen({false, true, true});
  list->topLevelItem(0)->setCheckState(0, Qt::Checked);
  expectSeen({true, true, true});
  press("Show all");
  EXPECT_EQ(scene().pieces, scene::Pieces{});
}

TEST_F(PiecesTest, CentreMovesThePieceToTheMiddle) {
  measuredList();
  clickRow(2);
  press("Centre");
  EXPECT_EQ(lastStep(), "Centre on piece");
  const QPoint away = onScreen(kBalls[2]) - window_->viewport()->rect().center();
  EXPECT_LT(away.manhattanLength(), 4);
}

}  // namespace
}  // namespace isolux::test
