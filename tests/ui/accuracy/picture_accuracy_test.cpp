// How accurate the picture on screen is: said in the status line while the Accuracy panel is seen, for the
// picture that it was measured of and no other, and carried by saved pictures.
#include <limits>

#include <QAction>
#include <QCoreApplication>
#include <QDockWidget>
#include <QLabel>

#include <nlohmann/json.hpp>

#include "app/error_budget/target_search.h"
#include "app/files/image_io.h"
#include "scene/settings/settings.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/accuracy_text.h"
#include "ui/presets/looks_panel.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {
namespace {

using nlohmann::json;

class PictureAccuracyTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:torus:24"));
  }
  ui::AccuracyPanel* panel() { return window_->panel<ui::AccuracyPanel>(); }
  const QLabel* label() { return window_->findChild<QLabel*>("pictureAccuracy"); }
  bool awaitText() {
    return waitUntil([&] { return label()->isVisible() && !label()->text().isEmpty(); }, 120000);
  }
  void edit(const char* assignment) {
    ui::Edit edit{window_->document()->scene(), assignment, {}, false};
    scene::applyAssignment(edit.scene, assignment);
    window_->document()->edit(edit);
  }
  json savedSession() {
    const QString file = newFile("picture.png");
    EXPECT_TRUE(window_->savePicture(file));
    return json::parse(app::readSessionText(file.toStdString()));
  }
};

TEST_F(PictureAccuracyTest, WithThePanelClosedNothingOfItRuns) {
  const std::size_t before = app::pictureErrorRuns();
  fullPicture(*window_);
  window_->showPanel("Passes");
  QCoreApplication::processEvents();
  EXPECT_FALSE(panel()->waiting());
  EXPECT_FALSE(panel()->picture().subject());
  EXPECT_EQ(panel()->picture().jobsBegun(), 0);
  EXPECT_EQ(app::pictureErrorRuns(), before);
  EXPECT_EQ(app::runningSearches(), 0);
  EXPECT_FALSE(label()->isVisible());
  EXPECT_FALSE(savedSession().contains("accuracy"));
}

TEST_F(PictureAccuracyTest, TheStatusLineSaysItForThePictureOnShowAlone) {
  window_->showPanel("Accuracy");
  ASSERT_TRUE(awaitText());
  ASSERT_TRUE(panel()->picture().known());
  const app::Accuracy known = *panel()->picture().known();
  const glm::ivec2 size = window_->viewport()->pixelSize();
  EXPECT_EQ(known.pixels, static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  EXPECT_GT(known.seen, known.uncertain);
  EXPECT_EQ(label()->text(), ui::accuracyText(known, false));
  EXPECT_TRUE(label()->text().startsWith("Depth ± ")) << label()->text().toStdString();
  EXPECT_TRUE(label()->text().contains("normal ± ")) << label()->text().toStdString();
  EXPECT_TRUE(label()->text().contains("% of pixels uncertain")) << label()->text().toStdString();
  EXPECT_FALSE(label()->text().contains("curvature")) << label()->text().toStdString();
  EXPECT_TRUE(label()->toolTip().contains("99 %"));

  edit("look.mode=mean_curvature");
  EXPECT_FALSE(label()->isVisible()) << "of a picture that was on show before";
  ASSERT_TRUE(awaitText());
  EXPECT_TRUE(label()->text().contains("curvature ± ")) << label()->text().toStdString();

  edit("camera.fov=40");
  EXPECT_FALSE(label()->isVisible());
  window_->document()->undo();
  ASSERT_TRUE(awaitText()) << "it is the measured picture again";
}

TEST_F(PictureAccuracyTest, APreviewIsNotTheMeasuredPicture) {
  window_->showPanel("Accuracy");
  ASSERT_TRUE(awaitText());
  scene::Scene other = window_->document()->scene();
  other.look.mode = scene::LookMode::normal;
  Q_EMIT window_->panel<ui::LooksPanel>()->previewed(other);
  EXPECT_FALSE(label()->isVisible());
  Q_EMIT window_->panel<ui::LooksPanel>()->previewed(std::nullopt);
  EXPECT_TRUE(awaitText());
}

TEST_F(PictureAccuracyTest, SavedPicturesCarryItAndItGoesWithThePanel) {
  window_->showPanel("Accuracy");
  ASSERT_TRUE(awaitText());
  const std::size_t pixels = panel()->picture().known()->pixels;
  const json session = savedSession();
  ASSERT_TRUE(session.contains("accuracy"));
  EXPECT_EQ(session["accuracy"]["pixels"], pixels);
  EXPECT_TRUE(session["accuracy"]["depth_mm"]["most_99"].is_number());
  window_->showPanel("Passes");
  EXPECT_TRUE(waitUntil([&] { return !label()->isVisible(); }));
  EXPECT_FALSE(savedSession().contains("accuracy"));
}

TEST(AccuracyText, UnitsAreThoseOneReads) {
  app::Accuracy accuracy;
  accuracy.pixels = 1000;
  accuracy.seen = 500;
  accuracy.uncertain = 5;
  accuracy.depthMm.most99 = 0.000234;
  accuracy.normalDegrees.most99 = 0.0123;
  accuracy.relativeCurvature.most99 = 0.0456;
  accuracy.depthNoiseMm.most99 = 0.123;
  EXPECT_EQ(ui::accuracyText(accuracy, false),
            "Depth ± 0.12 mm (noise, discretisation) · rounding ± 0.23 µm · normal ± 0.012° · 0.5 % of "
            "pixels uncertain");
  accuracy.depthNoiseMm.most99 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ui::accuracyText(accuracy, true),
            "Depth ± 0.23 µm · normal ± 0.012° · curvature ± 4.6 % · 0.5 % of pixels uncertain");
  accuracy.depthMm.most99 = 0.0234;
  accuracy.normalDegrees.most99 = std::numeric_limits<double>::infinity();
  EXPECT_EQ(ui::accuracyText(accuracy, false),
            "Depth ± 0.023 mm · normal ± unbounded · 0.5 % of pixels uncertain");
  accuracy.normalDegrees.most99 = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(ui::accuracyText(accuracy, false), "Depth ± 0.023 mm · 0.5 % of pixels uncertain");
  accuracy.seen = accuracy.uncertain = 0;
  EXPECT_EQ(ui::accuracyText(accuracy, false), "Nothing visible · 0 % of pixels uncertain");
}

}  // namespace
}  // namespace isolux::test
