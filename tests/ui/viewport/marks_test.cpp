// Marks by clicks on the picture, and their panel: real widgets, one undo step for each mark.
#include <algorithm>
#include <cmath>
#include <fstream>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPainter>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>

#include <glm/geometric.hpp>

#include "tests/support/ui/dialog_answers.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/document/mark_reports.h"
#include "ui/panels/marks_panel.h"
#include "ui/panels/settings_panel.h"
#include "ui/viewport/overlay_painters.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace isolux::test {
namespace {

using scene::MarkKind;

constexpr double kRadius = 0.35 * 47.0;  // phantom:ball:48

class MarksTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:ball:48"));
    edit([](scene::Scene& scene) {
      scene.surfaces.front().value = 0.0;
      scene.camera.projection = scene::Projection::orthographic;
    });
    fullPicture(*window_);
  }
  ui::Viewport* viewport() { return window_->viewport(); }
  ui::MarksPanel* panel() { return window_->panel<ui::MarksPanel>(); }
  const std::vector<scene::Mark>& marks() { return window_->document()->scene().marks; }
  std::string lastStep() { return window_->document()->history().undoName(); }
  QPoint at(double x, double y) {  // from the centre, in parts of half the height
    const QPoint centre = viewport()->rect().center();
    return centre + QPoint(static_cast<int>(x * centre.y()), static_cast<int>(y * centre.y()));
  }
  void click(QPoint place, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::mouseClick(viewport(), Qt::LeftButton, modifiers, place);
  }
  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    viewport()->setFocus();
    QTest::keyClick(viewport(), key, modifiers);
  }
  template <class Change>
  void edit(const Change& change) {
    ui::Edit edit{window_->document()->scene(), "Test", {}, false};
    change(edit.scene);
    window_->document()->edit(edit);
  }
  bool measured() {
    return waitUntil([&] { return !window_->marks()->measuring(); });
  }
  QAction* menuAction(const QString& text) {
    for (QAction* action : window_->findChildren<QAction*>())
      if (action->text().remove('&') == text) return action;
    return nullptr;
  }
};

TEST_F(MarksTest, APinIsOneClickAndOneStep) {
  key(Qt::Key_P);
  ASSERT_EQ(viewport()->tool(), MarkKind::point);
  EXPECT_EQ(viewport()->cursor().shape(), Qt::CrossCursor);
  click(at(0.0, 0.0));
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].name, "Pin 1");
  EXPECT_EQ(lastStep(), "Add pin");
  EXPECT_NEAR(glm::length(marks()[0].points[0]), kRadius, 0.1);
  click(QPoint(3, 3));  // beside the surface
  EXPECT_EQ(marks().size(), 1u);
  key(Qt::Key_Escape);
  EXPECT_FALSE(viewport()->tool());
  click(at(0.1, 0.1));
  EXPECT_EQ(marks().size(), 1u);
  ASSERT_TRUE(measured());
  EXPECT_EQ(window_->marks()->reports()[0].problem, "");
  window_->document()->undo();
  EXPECT_TRUE(marks().empty());
  EXPECT_TRUE(viewport()->markShapes().empty());
  window_->document()->redo();
  ASSERT_TRUE(measured());
  EXPECT_EQ(viewport()->markShapes().size(), 1u);
}

TEST_F(MarksTest, ADistanceIsMeasuredBetweenTheHits) {
  key(Qt::Key_M);
  click(at(-0.3, 0.0));
  EXPECT_EQ(viewport()->placing().size(), 1u);
  click(at(0.3, 0.0));
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(lastStep(), "Add distance");
  EXPECT_EQ(viewport()->tool(), MarkKind::distance);  // and the next may follow
  ASSERT_TRUE(measured());
  const app::MarkReport& report = window_->marks()->reports()[0];
  EXPECT_EQ(report.quantities[0].value, glm::distance(marks()[0].points[0], marks()[0].points[1]));
  EXPECT_TRUE(report.notes.empty());
  EXPECT_GT(*report.quantities[0].error, 0.0);
}

TEST_F(MarksTest, BackspaceTakesThePointBackAndShiftGoesOn) {
  key(Qt::Key_M);
  click(at(-0.3, 0.0));
  key(Qt::Key_Backspace);
  EXPECT_TRUE(viewport()->placing().empty());
  EXPECT_EQ(viewport()->tool(), MarkKind::distance);
  click(at(-0.3, 0.0));
  click(at(0.0, 0.2), Qt::ShiftModifier);
  EXPECT_TRUE(marks().empty());
  click(at(0.3, 0.0));
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].points.size(), 3u);
  click(at(-0.3, 0.0));
  key(Qt::Key_Escape);  // what was begun is gone
  EXPECT_EQ(marks().size(), 1u);
  EXPECT_TRUE(viewport()->placing().empty());
}

TEST_F(MarksTest, AToolDoesNotKeepTheViewFromTurning) {
  key(Qt::Key_M);
  const auto eye = scene::frameOf(window_->document()->resolvedScene().camera).eye;
  drag(viewport(), at(0.0, 0.0), at(0.3, 0.0));
  EXPECT_GT(glm::distance(scene::frameOf(window_->document()->resolvedScene().camera).eye, eye), 1.0);
  EXPECT_TRUE(viewport()->placing().empty());
}

TEST_F(MarksTest, QuickClicksAreTwoPoints) {
  const auto target = window_->document()->scene().camera.target;
  key(Qt::Key_M);
  click(at(-0.2, 0.0));
  QTest::mouseDClick(viewport(), Qt::LeftButton, Qt::NoModifier, at(0.2, 0.0));
  QTest::mouseRelease(viewport(), Qt::LeftButton, Qt::NoModifier, at(0.2, 0.0));
  EXPECT_EQ(marks().size(), 1u);
  EXPECT_EQ(window_->document()->scene().camera.target, target);
}

TEST_F(MarksTest, EveryToolOfTheMenuMakesItsKind) {
  struct Case {
    const char* text;
    MarkKind kind;
    int clicks;
  };
  const std::vector<QPoint> places{at(-0.3, 0.1), at(0.0, -0.2), at(0.3, 0.15)};
  std::size_t count = 0;
  for (const Case& tool : {Case{"Pin", MarkKind::point, 1}, Case{"Distance", MarkKind::distance, 2},
                           Case{"Geodesic distance", MarkKind::path, 2}, Case{"Angle", MarkKind::angle, 3},
                           Case{"Circle", MarkKind::circle, 3}, Case{"Thickness", MarkKind::thickness, 1},
                           Case{"Piece", MarkKind::piece, 1}}) {
    QAction* action = menuAction(tool.text);
    ASSERT_TRUE(action) << tool.text;
    action->trigger();
    EXPECT_TRUE(action->isChecked());
    for (int i = 0; i < tool.clicks; ++i) click(places[static_cast<std::size_t>(i)]);
    ASSERT_EQ(marks().size(), ++count) << tool.text;
    EXPECT_EQ(marks().back().kind, tool.kind);
    action->trigger();
    EXPECT_FALSE(viewport()->tool());
  }
  ASSERT_TRUE(measured());
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(window_->marks()->reports()[i].problem, "") << i;
    EXPECT_FALSE(window_->marks()->reports()[i].quantities.empty()) << i;
  }
  EXPECT_GT(window_->marks()->reports()[2].line.size(), 5u);
  EXPECT_EQ(panel()->findChild<QTreeWidget*>()->topLevelItemCount(), 7);
}

TEST_F(MarksTest, ThePanelRenamesHidesAndDeletes) {
  key(Qt::Key_P);
  click(at(-0.2, 0.0));
  click(at(0.2, 0.0));
  key(Qt::Key_Escape);
  ASSERT_TRUE(measured());
  window_->showPanel("Marks");
  QTreeWidget* list = panel()->findChild<QTreeWidget*>();
  ASSERT_TRUE(waitUntil([&] { return list->isVisible(); }));
  list->setCurrentItem(list->topLevelItem(0));
  list->editItem(list->topLevelItem(0), 0);
  auto* line = list->findChild<QLineEdit*>();
  ASSERT_TRUE(line);
  line->selectAll();
  QTest::keyClicks(line, "Top m");  // no key starts a tool
  QTest::keyClick(line, Qt::Key_Backspace);
  QTest::keyClicks(line, "p");
  EXPECT_FALSE(viewport()->tool());
  QTest::keyClick(line, Qt::Key_Return);
  EXPECT_TRUE(waitUntil([&] { return marks()[0].name == "Top p"; }));
  EXPECT_EQ(lastStep(), "Rename measurement");
  list->topLevelItem(1)->setCheckState(0, Qt::Unchecked);
  EXPECT_FALSE(marks()[1].shown);
  EXPECT_EQ(lastStep(), "Hide Pin 2");
  EXPECT_EQ(viewport()->markShapes().size(), 1u);
  EXPECT_TRUE(panel()->details().contains("Top p (point)")) << panel()->details().toStdString();
  EXPECT_TRUE(panel()->details().contains("kappa1: 0.0"));
  list->setFocus();
  list->clearSelection();
  list->setCurrentItem(list->topLevelItem(0));
  QTest::keyClick(list, Qt::Key_Delete);
  ASSERT_EQ(marks().size(), 1u);
  EXPECT_EQ(marks()[0].name, "Pin 2");
  window_->document()->undo();
  EXPECT_EQ(marks().size(), 2u);
}

TEST_F(MarksTest, CopiesWhatTheMarksSay) {
  key(Qt::Key_M);
  click(at(-0.3, 0.0));
  click(at(0.3, 0.0));
  ASSERT_TRUE(measured());
  for (QToolButton* button : panel()->findChildren<QToolButton*>())
    if (button->text() == "Copy") button->click();
  const QString text = QApplication::clipboard()->text();
  EXPECT_TRUE(text.contains("Distance 1 (distance)")) << text.toStdString();
  EXPECT_TRUE(text.contains(" ± ")) << text.toStdString();
}

TEST_F(MarksTest, AMarkSaysThatTheIsovalueHasLeftIt) {
  key(Qt::Key_M);
  click(at(-0.3, 0.0));
  click(at(0.3, 0.0));
  ASSERT_TRUE(measured());
  const double before = window_->marks()->reports()[0].quantities[0].value;
  const std::vector<scene::Mark> marked = marks();
  edit([](scene::Scene& scene) { scene.surfaces.front().value = 4.0; });
  ASSERT_TRUE(measured());
  EXPECT_EQ(marks(), marked);
  EXPECT_EQ(window_->marks()->reports()[0].quantities[0].value, before);
  EXPECT_EQ(window_->marks()->reports()[0].notes.size(), 2u);
  EXPECT_TRUE(panel()->findChild<QTreeWidget*>()->topLevelItem(0)->text(1).startsWith("⚠"));
}

TEST_F(MarksTest, PointsBehindTheSurfaceAreKnown) {
  edit([](scene::Scene& scene) {
    scene.marks = {{MarkKind::distance, "through", {{0, -kRadius, 0}, {0, kRadius, 0}}}};
  });
  ASSERT_TRUE(measured());
  const auto hidden = [&] { return viewport()->markShapes()[0].points.hidden; };
  ASSERT_TRUE(waitUntil([&] { return hidden().size() == 2; }));
  EXPECT_NE(hidden()[0], hidden()[1]);
  const std::vector<bool> before = hidden();
  QTest::keyClick(viewport(), Qt::Key_2);  // from the other side
  EXPECT_TRUE(waitUntil([&] { return hidden()[0] != before[0] && hidden()[1] != before[1]; }));
}

// Nothing of the picture depends on marks: none is drawn anew.
TEST_F(MarksTest, MarksCostNoPicture) {
  fullPicture(*window_);
  int pictures = 0;
  QObject::connect(viewport(), &ui::Viewport::reported, [&] { ++pictures; });
  edit([](scene::Scene& scene) { scene.marks = {{MarkKind::point, "p", {{0, -kRadius, 0}}}}; });
  ASSERT_TRUE(measured());
  EXPECT_TRUE(viewport()->complete());
  EXPECT_EQ(pictures, 0);
}

TEST_F(MarksTest, FilesAreWrittenAndOpened) {
  key(Qt::Key_M);
  click(at(-0.3, 0.0));
  click(at(0.3, 0.0));
  ASSERT_TRUE(measured());
  const QString file = newFile("a.mrk.json"), table = newFile("a.csv");
  EXPECT_TRUE(window_->exportMarks(file));
  EXPECT_TRUE(window_->exportMarks(table));
  EXPECT_FALSE(window_->exportMarks(newFile("a.png")));
  const std::vector<scene::Mark> written = marks();
  EXPECT_TRUE(window_->importMarks(file));
  ASSERT_EQ(marks().size(), 2u);
  EXPECT_EQ(marks()[1].points, written[0].points);
  EXPECT_EQ(lastStep(), "Import measurements");
  std::ofstream(newFile("bad.mrk.json").toStdString()) << "[]";
  EXPECT_FALSE(window_->importMarks(newFile("bad.mrk.json")));
  EXPECT_EQ(window_->messageBar()->kind(), ui::MessageBar::Kind::error);
  EXPECT_EQ(marks().size(), 2u);
}

TEST_F(MarksTest, AnotherVolumeHasNone) {
  key(Qt::Key_P);
  click(at(0.0, 0.0));
  ASSERT_EQ(marks().size(), 1u);
  viewport()->setTool(std::nullopt);
  ASSERT_TRUE(waitUntil([&] { return !window_->marks()->measuring(); }));
  window_->document()->open("phantom:torus:32");
  ASSERT_TRUE(waitUntil([&] { return !window_->document()->loading() && marks().empty(); }));
  EXPECT_TRUE(viewport()->markShapes().empty());
}

TEST_F(MarksTest, AreNoRowOfTheSettings) {
  EXPECT_EQ(window_->panel<ui::SettingsPanel>()->editor("marks.list"), nullptr);
}

TEST(MarkPainter, LabelsCoverNoPointAndNoOtherLabel) {
  scene::Scene scene;
  scene.camera.eye = glm::dvec3(0, -200, 0);
  scene.camera.target = glm::dvec3(0);
  scene.camera.up = glm::dvec3(0, 0, 1);
  const scene::CameraFrame frame = scene::frameOf(scene.camera);
  std::vector<app::MarkShape> shapes;
  for (const glm::dvec3& point : {glm::dvec3(0, 0, 0), glm::dvec3(3, 0, 1), glm::dvec3(1, 0, -3)}) {
    scene::Mark mark{MarkKind::point, "A name", {point}};
    shapes.push_back(app::markShape(mark, {}));
  }
  QImage image(400, 300, QImage::Format_ARGB32);
  image.fill(Qt::black);
  QPainter painter(&image);
  const std::vector<QRectF> labels = ui::paintMarks(painter, shapes, frame, image.size());
  ASSERT_EQ(labels.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(QRectF(image.rect()).contains(labels[i]));
    for (std::size_t j = 0; j < 3; ++j) {
      const auto dot = app::pixelOf(frame, shapes[j].points.corners[0], {400, 300});
      EXPECT_FALSE(labels[i].contains(QPointF(dot->x, dot->y)));
      for (std::size_t k = i + 1; k < 3 && j == i; ++k) EXPECT_FALSE(labels[i].intersects(labels[k]));
    }
  }
}

}  // namespace
}  // namespace isolux::test
