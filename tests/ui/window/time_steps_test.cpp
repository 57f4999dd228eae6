// A file of several time steps: the slider, what stays the same from step to step.
#include <fstream>
#include <set>

#include <QApplication>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QSlider>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QUrl>

#include "tests/support/test_data.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/document/recent_files.h"
#include "ui/panels/volume_panel.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/number_spin_box.h"

namespace isolux::test {
namespace {

constexpr int kVoxels = 16, kSteps = 3;

// Balls that grow: 40 - distance + 4 * step.
void putBall(std::ofstream& file, int step, int voxels) {
  for (int i = 0; i < voxels * voxels * voxels; ++i) {
    const glm::dvec3 at(i % voxels, i / voxels % voxels, i / (voxels * voxels));
    const double distance = glm::length(at - 0.5 * (voxels - 1)) * kVoxels / voxels;
    file.put(static_cast<char>(40.0 - distance * 2.0 + 4.0 * step));
  }
}

QString writeGrowingBall(const QString& name, int voxels = kVoxels) {
  std::ofstream file(name.toStdString(), std::ios::binary);
  file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 4\nsizes: " << voxels << ' ' << voxels << ' '
       << voxels << " 3\nkinds: domain domain domain list\n\n";
  for (int step = 0; step < kSteps; ++step) putBall(file, step, voxels);
  return name;
}

TEST_F(WindowTest, ASliderGoesThroughTimeStepsAndThePictureStaysComparable) {
  ASSERT_TRUE(load(*window_, writeGrowingBall(newFile("growing.nrrd"))));
  ui::VolumePanel* const panel = window_->panel<ui::VolumePanel>();
  QSlider* const slider = panel->timeSlider();
  EXPECT_EQ(slider->maximum(), kSteps - 1);
  ui::Document* const document = window_->document();
  ASSERT_FALSE(document->scene().surfaces.front().value) << "automatic at first";
  const scene::Scene before = document->resolvedScene();
  const auto shows = [&](int step) {
    return waitUntil([&] { return !document->loading() && document->scene().source.timeStep == step; });
  };
  for (const int step : {1, 2}) {
    slider->setValue(step);
    ASSERT_TRUE(shows(step));
    EXPECT_EQ(document->volume()->grid().value(7, 7, 7), document->volume()->grid().maximum());
    EXPECT_EQ(panel->timeStepChoice()->value(), step);
    EXPECT_EQ(slider->value(), step);
    EXPECT_EQ(document->resolvedScene().surfaces.front().value, before.surfaces.front().value);
    EXPECT_EQ(document->resolvedScene().camera, before.camera);
  }
  document->undo();
  ASSERT_TRUE(shows(1));
  document->undo();
  ASSERT_TRUE(shows(0));
  EXPECT_EQ(slider->value(), 0);
}

TEST_F(WindowTest, PlayingShowsStepsAndBlendsAndIsOneUndoStep) {
  ASSERT_TRUE(load(*window_, writeGrowingBall(newFile("growing.nrrd"))));
  ui::Document* const document = window_->document();
  ui::VolumePanel* const panel = window_->panel<ui::VolumePanel>();
  const scene::Scene before = document->resolvedScene();
  std::set<double> shown;
  QObject context;
  QObject::connect(document, &ui::Document::sceneChanged, &context,
                   [&](const scene::Scene& scene) { shown.insert(scene.source.timeStep); });
  panel->speedChoice()->setValue(4.0);  // two pictures for each step
  panel->playButton()->click();
  EXPECT_TRUE(document->playing());
  ASSERT_TRUE(waitUntil([&] { return shown == std::set<double>{0.0, 0.5, 1.0, 1.5, 2.0}; }));
  EXPECT_FALSE(document->loading()) << "nothing that stands before the picture";
  ASSERT_TRUE(waitUntil([&] { return document->scene().source.timeStep == 1.5; }));
  EXPECT_EQ(panel->timeStepChoice()->value(), 1.5);
  EXPECT_EQ(document->resolvedScene().surfaces.front().value, before.surfaces.front().value);
  EXPECT_EQ(document->resolvedScene().camera, before.camera);
  QTest::keyClick(window_->viewport(), Qt::Key_T);
  EXPECT_FALSE(document->playing());
  ASSERT_NE(document->scene().source.timeStep, 0.0);
  document->undo();
  ASSERT_TRUE(waitUntil([&] { return !document->loading(); }));
  EXPECT_EQ(document->scene().source.timeStep, 0.0);
  EXPECT_FALSE(document->history().canUndo());
}

// Preparing this takes a processor many turns of the window's loop.
TEST_F(WindowTest, PlayingNeverBlocksTheWindow) {
  ASSERT_TRUE(load(*window_, writeGrowingBall(newFile("growing.nrrd"), 160)));
  ui::Document* const document = window_->document();
  int turns = 0, steps = 0;
  QTimer loop;
  QObject::connect(&loop, &QTimer::timeout, &loop, [&] { ++turns; });
  QObject::connect(document, &ui::Document::volumeChanged, &loop, [&] { ++steps; });
  loop.start(0);
  document->play(20.0);
  ASSERT_TRUE(waitUntil([&] { return steps >= 3; }));
  EXPECT_GT(turns, 20) << "loaded beside the window";  // of all: late steps may come at once
  document->open("phantom:ball:16");
  EXPECT_FALSE(document->playing());
  ASSERT_TRUE(waitUntil([&] { return !document->loading(); }));
  document->play(1.0);
  EXPECT_FALSE(document->playing()) << "one step only";
}

TEST_F(WindowTest, SeveralFilesOpenAsTimeSteps) {
  const std::filesystem::path folder = temporaryFolder();
  QStringList files;
  for (int step = 0; step < kSteps; ++step) {
    files += QString::fromStdString((folder / ("step_" + std::to_string(step) + ".nrrd")).string());
    std::ofstream file(files.back().toStdString(), std::ios::binary);
    file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 3\nsizes: 16 16 16\n\n";
    putBall(file, step, kVoxels);
  }
  QMimeData dropped;
  QList<QUrl> urls;
  for (const QString& file : files) urls += QUrl::fromLocalFile(file);
  dropped.setUrls(urls);
  QDragEnterEvent enter(QPoint(10, 10), Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &enter);
  QDropEvent drop({10.0, 10.0}, Qt::CopyAction, &dropped, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(window_.get(), &drop);
  ui::Document* const document = window_->document();
  ASSERT_TRUE(
      waitUntil([&] { return document->volume() && document->volume()->volume.timeSteps == kSteps; }));
  EXPECT_TRUE(QString::fromStdString(document->scene().source.path).endsWith("/step_*.nrrd"));
  EXPECT_EQ(ui::recentFiles().front(), QString::fromStdString(document->scene().source.path));
  const QString session = newFile("steps.isolux");
  ASSERT_TRUE(document->saveSession(session));
  ASSERT_TRUE(load(*window_, session));
  EXPECT_EQ(document->volume()->volume.timeSteps, kSteps);
}

}  // namespace
}  // namespace isolux::test
