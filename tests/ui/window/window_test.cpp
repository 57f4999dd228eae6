// Opening, dragging, orbiting, undoing, saving and reopening in the real window.
#include "tests/support/ui/window_fixture.h"

#include <fstream>

#include <QAction>
#include <QComboBox>
#include <QDropEvent>
#include <QMimeData>
#include <QTest>
#include <QUrl>

#include "app/documents/recording.h"
#include "app/documents/session.h"
#include "app/files/image_io.h"
#include "ui/document/recent_files.h"
#include "ui/editors/histogram_slider.h"
#include "ui/editors/setting_editor.h"
#include "ui/panels/isovalue_panel.h"
#include "ui/panels/source_panel.h"
#include "ui/panels/volume_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {
QPoint centreOf(const QWidget* widget) {
  return widget->rect().center();
}

void dragIsovalue(ui::MainWindow& window, double value) {
  ui::HistogramSlider* slider = window.panel<ui::HistogramSlider>();
  drag(slider, slider->linePosition().toPoint(), slider->positionOf(value).toPoint());
}
}  // namespace

TEST_F(WindowTest, OpensAFileAndShowsItsFactsAndSurface) {
  const QImage empty = fullPicture(*window_);
  const QString file = writeBall(40, {1.0, 1.0, 2.5});
  ASSERT_TRUE(load(*window_, file));
  const auto& volume = window_->document()->volume();
  EXPECT_EQ(volume->grid().dims(), glm::ivec3(40));
  EXPECT_NEAR(volume->grid().geometry().spacingMm().z, 2.5, 1e-9);
  EXPECT_TRUE(waitUntil([&] { return window_->windowTitle().startsWith("ball.mhd"); }));
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_EQ(ui::recentFiles(), QStringList{file});
  const QImage picture = fullPicture(*window_);
  EXPECT_GT(differingPixels(empty, picture), 0.05);
  EXPECT_TRUE(window_->messageBar()->isHidden() ||
              window_->messageBar()->kind() == ui::MessageBar::Kind::note);
}

TEST_F(WindowTest, DraggingTheLineMovesTheIsovalueAndTheSurface) {
  ASSERT_TRUE(load(*window_, "phantom:ball:48"));
  const QImage before = fullPicture(*window_);
  const auto& histogram = window_->document()->volume()->histogram;
  const double wanted = histogram.minimum + 0.75 * (histogram.maximum - histogram.minimum);
  dragIsovalue(*window_, wanted);
  const auto value = window_->document()->scene().surfaces.front().value;
  ASSERT_TRUE(value.has_value());
  const double pixel = window_->panel<ui::HistogramSlider>()->plot().shownRange() / 300.0;
  EXPECT_NEAR(*value, wanted, pixel);
  EXPECT_NEAR(window_->panel<ui::IsovaluePanel>()->findChild<ui::NumberSpinBox*>()->value(), *value, 1e-12);
  EXPECT_GT(differingPixels(before, fullPicture(*window_)), 0.02);
  EXPECT_TRUE(window_->isWindowModified());

  // The whole drag is one step.
  EXPECT_EQ(window_->document()->history().undoName(), "Set isovalue");
  window_->document()->undo();
  EXPECT_FALSE(window_->document()->history().canUndo());
  EXPECT_FALSE(window_->document()->scene().surfaces.front().value.has_value());
  EXPECT_EQ(differingPixels(before, fullPicture(*window_)), 0.0);
  window_->document()->redo();
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, value);
}

TEST_F(WindowTest, ManyMovesOfTheLineInOneTurnAreOneEdit) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  fullPicture(*window_);
  int edits = 0;
  QObject::connect(window_->document(), &ui::Document::sceneChanged, [&] { ++edits; });
  ui::HistogramSlider* slider = window_->panel<ui::HistogramSlider>();
  const QPoint from = slider->linePosition().toPoint();
  QTest::mousePress(slider, Qt::LeftButton, Qt::NoModifier, from);
  for (int i = 1; i <= 200; ++i) {
    const QPointF position = from + QPointF(0.4 * i, 0.0);
    QMouseEvent move(QEvent::MouseMove, position, slider->mapToGlobal(position), Qt::NoButton, Qt::LeftButton,
                     Qt::NoModifier);
    QCoreApplication::sendEvent(slider, &move);
  }
  QTest::mouseRelease(slider, Qt::LeftButton, Qt::NoModifier, from + QPoint(80, 0));
  EXPECT_EQ(edits, 1);
  EXPECT_NEAR(slider->linePosition().x(), from.x() + 80.0, 1.5);
}

TEST_F(WindowTest, WheelKeysAndDoubleClickOnTheHistogram) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  ui::HistogramSlider* slider = window_->panel<ui::HistogramSlider>();
  const double start = slider->isovalue(), step = slider->plot().fineStep();
  wheel(slider, centreOf(slider), 1);
  EXPECT_NEAR(slider->isovalue(), start, 1.5 * step);
  EXPECT_GT(slider->isovalue(), start);
  QTest::keyClick(slider, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(slider->isovalue(), start - 9.0 * step, 1.01 * step);
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, slider->isovalue());
  QTest::mouseDClick(slider, Qt::LeftButton, Qt::NoModifier, centreOf(slider));
  EXPECT_FALSE(window_->document()->scene().surfaces.front().value.has_value());
  EXPECT_DOUBLE_EQ(slider->isovalue(), start);

  wheel(slider, centreOf(slider), 4, Qt::ControlModifier);
  EXPECT_TRUE(slider->plot().zoomed());
  const double left = slider->plot().shownMinimum();
  drag(slider, centreOf(slider), centreOf(slider) + QPoint(30, 0), Qt::MiddleButton);
  EXPECT_LT(slider->plot().shownMinimum(), left);
  EXPECT_DOUBLE_EQ(slider->isovalue(), start);  // zooming and panning the axis changes no value
}

TEST_F(WindowTest, TheSpinBoxSetsTheExactIsovalue) {
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  ui::NumberSpinBox* box = window_->panel<ui::IsovaluePanel>()->findChild<ui::NumberSpinBox*>();
  EXPECT_TRUE(box->suffix().contains("HU"));
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, "-123,25");
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, -123.25);
  EXPECT_EQ(window_->panel<ui::HistogramSlider>()->isovalue(), -123.25);
}

// Not when the focus leaves the field.
TEST_F(WindowTest, UndoInTheIsovaluesFieldIsSeenAtOnce) {
  ASSERT_TRUE(load(*window_, "phantom:head:32"));
  ui::NumberSpinBox* box = window_->panel<ui::IsovaluePanel>()->findChild<ui::NumberSpinBox*>();
  const double before = window_->panel<ui::HistogramSlider>()->isovalue();
  box->setFocus();
  const QString shown = box->text();
  box->selectAll();
  QTest::keyClicks(box, "999");
  QTest::keyClick(box, Qt::Key_Return);
  ASSERT_EQ(window_->document()->scene().surfaces.front().value, 999.0);
  QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(box->hasFocus());
  EXPECT_FALSE(window_->document()->scene().surfaces.front().value.has_value());
  EXPECT_EQ(window_->panel<ui::HistogramSlider>()->isovalue(), before);
  EXPECT_EQ(box->text(), shown);
  QTest::keyClick(box, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(window_->document()->scene().surfaces.front().value, 999.0);
}

TEST_F(WindowTest, SavedSessionShowsTheSamePictureInAFreshWindow) {
  ASSERT_TRUE(load(*window_, writeBall(36)));
  const QImage first = fullPicture(*window_);
  dragIsovalue(*window_, 600.0);
  drag(window_->viewport(), centreOf(window_->viewport()), centreOf(window_->viewport()) + QPoint(90, 40));
  ui::Edit look{window_->document()->scene(), "Change look", {}, false};
  look.scene.look.mode = scene::LookMode::normal;
  window_->document()->edit(look);
  const QImage saved = fullPicture(*window_);
  ASSERT_GT(differingPixels(first, saved), 0.02);

  const QString file = newFile("ball.isolux");
  ASSERT_TRUE(window_->document()->saveSession(file));
  EXPECT_FALSE(window_->isWindowModified());
  EXPECT_TRUE(window_->windowTitle().startsWith("ball.isolux"));

  const auto fresh = makeWindow();
  ASSERT_TRUE(load(*fresh, file));
  EXPECT_EQ(fresh->document()->scene(), window_->document()->scene());
  EXPECT_EQ(differingPixels(saved, fullPicture(*fresh)), 0.0);
  EXPECT_FALSE(fresh->document()->history().canUndo());
  window_->document()->undo();
  EXPECT_TRUE(window_->isWindowModified());
  window_->document()->redo();  // nothing to save: closing must not ask
}

TEST_F(WindowTest, SavedPictureIsTheOneOnScreenAndCarriesTheSession) {
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  const QImage shown = fullPicture(*window_);
  const QString file = newFile("torus.png");
  ASSERT_TRUE(window_->savePicture(file));
  EXPECT_EQ(differingPixels(shown, QImage(file)), 0.0);
  const auto fresh = makeWindow();
  ASSERT_TRUE(load(*fresh, file));
  scene::Scene saved = window_->document()->scene();
  saved.camera = window_->document()->resolvedScene().camera;  // written down as it fits this window
  EXPECT_EQ(fresh->document()->scene(), saved);
}

TEST_F(WindowTest, DroppedFileIsOpened) {
  const QString file = writeBall(24);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter(centreOf(window_.get()), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(centreOf(window_.get()), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window_.get(), &drop);
  EXPECT_TRUE(waitUntil([&] { return window_->document()->volume() != nullptr; }));
  EXPECT_TRUE(waitUntil([&] { return window_->windowTitle().startsWith("ball.mhd"); }));

  QMimeData text;
  text.setText("no file");
  QDragEnterEvent other(centreOf(window_.get()), Qt::CopyAction, &text, Qt::LeftButton, Qt::NoModifier);
  other.ignore();
  QCoreApplication::sendEvent(window_.get(), &other);
  EXPECT_FALSE(other.isAccepted());
}

TEST_F(WindowTest, RecordingHoldsEveryChangeAndEndsWithTheSameScene) {
  ASSERT_TRUE(load(*window_, "phantom:ball:32"));
  const QString file = newFile("drag.jsonl");
  ASSERT_TRUE(window_->document()->startRecording(file));
  const scene::Scene start = window_->document()->scene();
  dragIsovalue(*window_, window_->document()->volume()->histogram.maximum * 0.5);
  drag(window_->viewport(), centreOf(window_->viewport()), centreOf(window_->viewport()) + QPoint(50, 0));
  window_->document()->undo();
  const scene::Scene end = window_->document()->scene();
  window_->document()->stopRecording();
  window_->viewport()->applyStandardView(scene::StandardView::left);  // no longer recorded

  const app::Recording recording = app::loadRecording(file.toStdString());
  EXPECT_EQ(recording.start, start);
  EXPECT_GE(recording.steps.size(), 3U);
  EXPECT_EQ(app::Playback(recording).at(recording.duration() + 1.0), end);
  EXPECT_NE(end, start);
}

TEST_F(WindowTest, AComponentCanBeChosenAndTheChoiceUndone) {
  const QString file = newFile("two.mhd");
  std::ofstream(file.toStdString()) << "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 4 4 4\n"
                                       "ElementType = MET_UCHAR\nElementNumberOfChannels = 2\n"
                                       "ElementDataFile = two.raw\n";
  std::string bytes;
  for (int i = 0; i < 64; ++i) bytes += {static_cast<char>(i), static_cast<char>(100 + i)};
  std::ofstream(file.chopped(3).toStdString() + "raw", std::ios::binary) << bytes;
  ASSERT_TRUE(load(*window_, file));
  window_->showPanel("volume");
  QComboBox* choice = window_->panel<ui::VolumePanel>()->componentChoice();
  ASSERT_EQ(choice->count(), 3);  // two and their magnitude
  EXPECT_EQ(window_->document()->volume()->grid().value(1, 0, 0), 1.0);
  choice->setFocus();
  QTest::keyClick(choice, Qt::Key_Down);
  ASSERT_TRUE(waitUntil([&] { return window_->document()->volume()->grid().value(1, 0, 0) == 101.0; }));
  EXPECT_EQ(window_->document()->scene().source.component, 1);
  EXPECT_EQ(window_->document()->history().undoName(), "Choose channel");
  window_->document()->undo();
  EXPECT_TRUE(waitUntil([&] { return window_->document()->volume()->grid().value(1, 0, 0) == 1.0; }));
  EXPECT_EQ(choice->currentIndex(), 0);
}

TEST_F(WindowTest, AMeshOpensAndIsCombinedWithASecondVolume) {
  const QString file = newFile("tetrahedron.obj");
  std::ofstream(file.toStdString()) << "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\n"
                                       "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  ASSERT_TRUE(load(*window_, file));
  window_->showPanel("volume");
  ui::SourcePanel* panel = window_->panel<ui::SourcePanel>();
  ui::Document* document = window_->document();
  const auto send = [&](const char* path, const nlohmann::json& value) {
    ui::Edit edit{document->scene(), "Boolean operation", {}, false};
    scene::setting(path).set(edit.scene, value);
    Q_EMIT panel->editor(path)->edited(edit);
  };
  EXPECT_TRUE(panel->editor("source.mesh_voxels")->isVisibleTo(panel));
  EXPECT_FALSE(panel->editor("source.csg_path")->isVisibleTo(panel));
  EXPECT_EQ(document->resolvedScene().surfaces.front().value, 0.0);
  send("source.mesh_voxels", 32);
  // The second edit comes while the first still loads; both must take effect.
  send("source.csg", "difference");
  send("source.csg_path", "phantom:ball");
  ASSERT_TRUE(waitUntil([&] { return document->scene().source.csgPath == "phantom:ball"; }));
  EXPECT_EQ(document->scene().source.meshVoxels, 32);
  EXPECT_EQ(document->scene().source.csg, scene::Csg::difference);
  EXPECT_EQ(document->volume()->grid().dims().x, 32);
  EXPECT_TRUE(panel->editor("source.csg_path")->isVisibleTo(panel));
  EXPECT_EQ(document->resolvedScene().source.csgValue, 0.0);
  document->undo();
  EXPECT_TRUE(waitUntil([&] { return document->volume()->grid().dims().x == 128; }));
}

TEST_F(WindowTest, TheCommandLinesSceneIsShownAndRecorded) {
  app::WindowRequest request;
  request.scene.source.path = "phantom:ball:24";
  request.scene.look.mode = scene::LookMode::depth;
  request.scene.camera.projection = scene::Projection::orthographic;
  request.recordFile = newFile("all.jsonl").toStdString();
  window_->open(request);
  ASSERT_TRUE(waitUntil([&] { return window_->document()->volume() != nullptr; }));
  EXPECT_EQ(window_->document()->scene().look.mode, scene::LookMode::depth);
  EXPECT_EQ(window_->document()->scene().camera.projection, scene::Projection::orthographic);
  EXPECT_TRUE(window_->document()->recording());
  EXPECT_EQ(app::Playback(app::loadRecording(request.recordFile)).at(1e9), window_->document()->scene());
}

}  // namespace isolux::test
