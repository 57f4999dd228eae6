// "Error at most" and "Time at most" in the Accuracy panel: what is found, applied, refused and dropped.
#include "ui/accuracy/target_box.h"

#include <cstdio>

#include <QElapsedTimer>
#include <QPushButton>
#include <QTest>

#include "scene/settings/settings.h"
#include "tests/support/ui/window_fixture.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {
namespace {

class TargetBoxTest : public WindowTest {
 protected:
  void show(const char* phantom) {
    ASSERT_TRUE(load(*window_, phantom));
    fullPicture(*window_);
    window_->showPanel("Accuracy");  // which may make the panels wider, and the picture narrower
    ASSERT_TRUE(comesToRest([&] { return static_cast<std::uint64_t>(window_->viewport()->width()); }));
    fullPicture(*window_);
    ASSERT_TRUE(waitUntil([&] { return box()->findButton()->isEnabled(); }));
  }
  ui::TargetBox* box() { return window_->panel<ui::AccuracyPanel>()->findChild<ui::TargetBox*>(); }
  const scene::Scene& scene() { return window_->document()->scene(); }
  void edit(const char* assignment) {
    ui::Edit edit{scene(), assignment, {}, false};
    scene::applyAssignment(edit.scene, assignment);
    window_->document()->edit(edit);
  }
  void click(QPushButton* button) { QTest::mouseClick(button, Qt::LeftButton); }
  QString found() {  // the text of a search that is started here
    click(box()->findButton());
    EXPECT_TRUE(waitUntil([&] { return !box()->searching(); }, 120000));
    return box()->text();
  }
};

TEST_F(TargetBoxTest, FindsSettingsSaysWhatTheyCostAndAppliesThemAsOneStep) {
  show("phantom:gyroid:32");
  edit("derivatives.normal_scale=0");
  box()->askError(app::Quantity::normal, 30.0);
  const QString text = found();
  ASSERT_TRUE(box()->answer()) << text.toStdString();
  EXPECT_TRUE(text.contains("Interpolant of derivatives: Trilinear")) << text.toStdString();
  EXPECT_TRUE(text.contains("Render time about ")) << text.toStdString();
  EXPECT_TRUE(text.contains("normal error ≤ ")) << text.toStdString();
  EXPECT_EQ(scene().derivatives.field, scene::Field::cubic) << "nothing is applied by itself";
  const scene::Scene before = scene();
  ASSERT_TRUE(box()->applyButton()->isEnabled());
  click(box()->applyButton());
  EXPECT_EQ(scene().derivatives.field, scene::Field::trilinear);
  EXPECT_FALSE(box()->applyButton()->isEnabled()) << "the answer is of the scene before";
  EXPECT_EQ(window_->document()->history().undoName(), "Keep 30 degrees (normals)");
  window_->document()->undo();
  EXPECT_TRUE(scene() == before);
}

TEST_F(TargetBoxTest, KeepsATime) {
  show("phantom:torus:24");
  box()->askTime(100000.0);
  const QString text = found();
  ASSERT_TRUE(box()->answer()) << text.toStdString();
  EXPECT_LE(box()->answer()->expectedMilliseconds, 100000.0);
}

TEST_F(TargetBoxTest, WhatIsRefusedSaysWhyInOneSentence) {
  show("phantom:torus:24");
  box()->askError(app::Quantity::depthMm, 1e-9);
  EXPECT_TRUE(found().startsWith("No settings keep depth at most 1e-09 mm")) << box()->text().toStdString();
  EXPECT_TRUE(box()->text().contains("the smallest guaranteed error is depth "));
  EXPECT_FALSE(box()->applyButton()->isEnabled());
  box()->askError(app::Quantity::light, 2.0);
  EXPECT_EQ(found(), "This image uses no baked light; no settings to choose");
  box()->askTime(1e-6);
  EXPECT_TRUE(found().startsWith("No settings keep 1e-06 ms; the fastest take about "))
      << box()->text().toStdString();
  edit("clip.box=-1,-1,-1; 1,1,1");
  box()->askError(app::Quantity::depthMm, 1.0);
  click(box()->findButton());
  EXPECT_FALSE(box()->searching());
  EXPECT_TRUE(box()->text().contains("remove the cuts")) << box()->text().toStdString();
}

TEST_F(TargetBoxTest, AnyEditDropsASearch) {
  show("phantom:head:64");
  const auto begin = [&] {
    box()->askError(app::Quantity::depthMm, 1e-9);  // all combinations are tried
    click(box()->findButton());
    ASSERT_TRUE(waitUntil([&] { return app::runningSearches() > 0; }));
  };
  begin();
  QElapsedTimer since;
  since.start();
  edit("camera.fov=40");
  EXPECT_FALSE(box()->searching());
  EXPECT_TRUE(waitUntil([] { return app::runningSearches() == 0; }));
  std::printf("the thread of a dropped search ended after %lld ms\n",
              static_cast<long long>(since.elapsed()));
  begin();
  click(box()->findButton());  // Stop
  EXPECT_FALSE(box()->searching());
  EXPECT_TRUE(waitUntil([] { return app::runningSearches() == 0; }));
  begin();
  window_->showPanel("Passes");
  EXPECT_TRUE(waitUntil([] { return app::runningSearches() == 0; }));
  EXPECT_FALSE(box()->searching());
}

}  // namespace
}  // namespace isolux::test
