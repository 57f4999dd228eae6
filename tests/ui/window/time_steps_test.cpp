// A file of several time steps: the slider, what stays the same from step to step.
#include <fstream>

#include <QSlider>
#include <QSpinBox>
#include <QTest>

#include "tests/support/ui/window_fixture.h"
#include "ui/panels/volume_panel.h"

namespace isolux::test {
namespace {

constexpr int kVoxels = 16, kSteps = 3;

// Balls that grow: 40 - distance + 4 * step.
QString writeGrowingBall(const QString& name) {
  std::ofstream file(name.toStdString(), std::ios::binary);
  file << "NRRD0004\ntype: uint8\nencoding: raw\ndimension: 4\nsizes: 16 16 16 3\n"
          "kinds: domain domain domain list\n\n";
  for (int step = 0; step < kSteps; ++step)
    for (int i = 0; i < kVoxels * kVoxels * kVoxels; ++i) {
      const glm::dvec3 at(i % kVoxels, i / kVoxels % kVoxels, i / (kVoxels * kVoxels));
      const double value = 40.0 - glm::length(at - 7.5) * 2.0 + 4.0 * step;
      file.put(static_cast<char>(value));
    }
  return name;
}

TEST_F(WindowTest, ASliderGoesThroughTimeStepsAndThePictureStaysComparable) {
  ASSERT_TRUE(load(*window_, writeGrowingBall(newFile("growing.nrrd"))));
  ui::VolumePanel* const panel = window_->panel<ui::VolumePanel>();
  QSlider* const slider = panel->timeSlider();
  EXPECT_EQ(slider->maximum(), kSteps - 1);
  ui::Document* const document = window_->document();
  ASSERT_FALSE(document->scene().isosurface.value) << "automatic at first";
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
    EXPECT_EQ(document->resolvedScene().isosurface.value, before.isosurface.value);
    EXPECT_EQ(document->resolvedScene().camera, before.camera);
  }
  document->undo();
  ASSERT_TRUE(shows(1));
  document->undo();
  ASSERT_TRUE(shows(0));
  EXPECT_EQ(slider->value(), 0);
}

}  // namespace
}  // namespace isolux::test
