// Stored light in the window: it comes, is shown, can be paused and stopped, and goes with its volume.
#include "tests/support/ui/window_fixture.h"

#include <QPushButton>
#include <QTest>
#include <QToolButton>

#include "scene/settings/settings.h"
#include "tests/support/ui/dialog_answers.h"
#include "ui/document/baked_light.h"
#include "ui/editors/environment_preview.h"
#include "ui/panels/light_status.h"
#include "ui/viewport/viewport.h"
#include "ui/widgets/picture_dot.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

using Phase = app::LightState::Phase;

class LightWindowTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    ASSERT_TRUE(load(*window_, "phantom:ball:24"));
  }
  ui::Viewport* viewport() { return window_->viewport(); }
  ui::BakedLight* light() { return window_->light(); }
  ui::LightStatus* status() { return window_->panel<ui::LightStatus>(); }
  void set(const char* path, const nlohmann::json& value) {
    ui::Edit edit{window_->document()->scene(), "Set", {}, false};
    scene::setting(path).set(edit.scene, value);
    window_->document()->edit(edit);
  }
  void lightUp(int samples) {
    set("gi.samples", samples);
    set("look.mode", "gi");
  }
  bool waitForPhase(Phase phase) {
    return waitUntil([&] { return light()->state().phase == phase; });
  }
  std::uint64_t samplesDone() { return light()->state().counters.samplesDone; }
  static constexpr int endless = 1000000;
};

}  // namespace

TEST_F(LightWindowTest, NoLightIsStoredUnderALookThatReadsNone) {
  fullPicture(*window_);
  EXPECT_TRUE(waitUntil([&] { return !light()->changing(); }));
  EXPECT_EQ(light()->state().phase, Phase::off);
  EXPECT_TRUE(status()->isHidden());
}

// The ring at the lower right.
TEST_F(LightWindowTest, TheDotSaysThatLightIsComputedAndHowFarItIs) {
  const auto* const dot = window_->findChild<ui::PictureDot*>();
  fullPicture(*window_);
  EXPECT_TRUE(waitUntil([&] { return dot->toolTip().startsWith("The image is final\n"); }))
      << dot->toolTip().toStdString();
  lightUp(endless);
  ASSERT_TRUE(waitForPhase(Phase::baking));
  ASSERT_TRUE(waitUntil([&] { return dot->toolTip().contains(" %"); })) << dot->toolTip().toStdString();
  EXPECT_TRUE(dot->toolTip().startsWith("Computing light: 0 %")) << dot->toolTip().toStdString();
  EXPECT_TRUE(dot->accessibleName().startsWith("Computing light"));
  EXPECT_FALSE(dot->isFinal()) << "between two pictures, too";
  status()->pauseButton()->click();
  EXPECT_TRUE(waitUntil([&] { return dot->toolTip().startsWith("Light computation paused at 0 %"); }));
  fullPicture(*window_);
  EXPECT_TRUE(waitUntil([&] { return dot->isFinal(); }));
  EXPECT_TRUE(dot->accessibleName().endsWith("The image is final except for its light"));
  set("look.mode", "blinn_phong");
  EXPECT_TRUE(waitUntil([&] { return dot->toolTip().startsWith("The image is final\n"); }))
      << dot->toolTip().toStdString();
}

TEST_F(LightWindowTest, LightComesAndThePictureIsLitByIt) {
  ASSERT_TRUE(load(*window_, "phantom:torus:24"));  // parts of it see one another
  set("gi.mode", "off");
  set("picture.metering", "lights");  // with stored light, too
  set("look.mode", "gi");
  const QImage local = fullPicture(*window_);
  set("gi.mode", "auto");
  set("gi.samples", 16);
  ASSERT_TRUE(waitForPhase(Phase::finished));
  EXPECT_NE(light()->light(), nullptr);
  const QImage lit = fullPicture(*window_);
  EXPECT_EQ(lit.size(), local.size());
  EXPECT_GT(differingPixels(local, lit, 4), 0.003);  // 0.0075: where it sees itself
  EXPECT_FALSE(status()->isHidden());
  EXPECT_EQ(status()->text(), "Light complete");
  EXPECT_GT(light()->state().counters.texelsLit, 100U);
  set("gi.mode", "off");
  ASSERT_TRUE(waitForPhase(Phase::off));
  EXPECT_EQ(differingPixels(local, fullPicture(*window_)), 0.0);  // nothing else has changed
  set("look.mode", "lambert");
  EXPECT_TRUE(waitUntil([&] { return status()->isHidden(); }));
}

// Light never makes the picture worse: until all that is seen is lit, it is that of plain lights.
TEST_F(LightWindowTest, ThePictureKeepsPlainLightsUntilStoredLightIsSmooth) {
  const QImage plain = fullPicture(*window_);
  light()->setPaused(true);
  lightUp(endless);
  ASSERT_TRUE(waitForPhase(Phase::paused));
  EXPECT_EQ(differingPixels(plain, fullPicture(*window_)), 0.0);
  EXPECT_FALSE(light()->isShown());
  light()->goOn();
  ASSERT_TRUE(waitUntil([&] { return light()->isShown(); }));
  EXPECT_EQ(light()->state().smooth, 1.0);
  EXPECT_GT(differingPixels(plain, fullPicture(*window_), 4), 0.1);
  light()->setPaused(true);
  set("look.mode", "blinn_phong");
  EXPECT_EQ(differingPixels(plain, fullPicture(*window_)), 0.0);
  set("look.mode", "gi");
  EXPECT_TRUE(waitUntil([&] { return light()->isShown(); })) << "it is there still";
}

TEST_F(LightWindowTest, LightOfSettingsThatComeBackIsThereAtOnce) {
  lightUp(16);
  ASSERT_TRUE(waitUntil([&] { return light()->isShown() && light()->state().phase == Phase::finished; }));
  const std::uint64_t lit = light()->state().counters.texelsLit;
  const auto pathsOf = [&] { return light()->state().counters.rays; };
  set("gi.bounces", 0);
  ASSERT_TRUE(waitUntil([&] { return light()->changing(); }));
  ASSERT_TRUE(waitForPhase(Phase::finished));
  window_->document()->undo();
  ASSERT_TRUE(waitUntil([&] { return !light()->changing() && light()->state().phase == Phase::finished; }));
  EXPECT_EQ(light()->state().counters.texelsLit, lit);
  const std::uint64_t rays = pathsOf();
  window_->document()->redo();
  ASSERT_TRUE(waitUntil([&] { return !light()->changing() && light()->state().phase == Phase::finished; }));
  window_->document()->undo();
  ASSERT_TRUE(waitUntil([&] { return !light()->changing() && light()->state().phase == Phase::finished; }));
  EXPECT_EQ(pathsOf(), rays) << "nothing was computed once more";
}

TEST_F(LightWindowTest, LightThatNobodyHasAskedForIsPausedWhereItTakesLong) {
  lightUp(endless);
  light()->askFirst();
  double seconds = 0.0;
  QObject::connect(light(), &ui::BakedLight::takesLong, [&](double s) { seconds = s; });
  ASSERT_TRUE(waitForPhase(Phase::paused));
  EXPECT_GT(seconds, 20.0);
  EXPECT_TRUE(window_->messageBar()->text().startsWith("Light for this image takes about"))
      << window_->messageBar()->text().toStdString();
  ASSERT_EQ(window_->messageBar()->buttons().size(), 1U);
  window_->messageBar()->buttons().front()->click();
  EXPECT_TRUE(waitForPhase(Phase::baking));
  QTest::qWait(300);
  EXPECT_EQ(light()->state().phase, Phase::baking) << "it was asked for";
  EXPECT_EQ(window_->messageBar()->text(), "");
}

TEST_F(LightWindowTest, TheQuestionForLightGoesWithTheLook) {
  lightUp(endless);
  light()->askFirst();
  ASSERT_TRUE(waitForPhase(Phase::paused));
  ASSERT_TRUE(waitUntil([&] { return window_->messageBar()->text().startsWith("Light"); }));
  set("look.mode", "lambert");
  EXPECT_EQ(window_->messageBar()->text(), "");
}

TEST_F(LightWindowTest, PausedLightStandsStillAndGoesOn) {
  lightUp(endless);
  ASSERT_TRUE(waitForPhase(Phase::baking));
  ASSERT_TRUE(waitUntil([&] { return samplesDone() > 0; }));
  EXPECT_TRUE(status()->text().contains('%')) << status()->text().toStdString();
  status()->pauseButton()->click();
  ASSERT_TRUE(waitForPhase(Phase::paused));
  ASSERT_TRUE(comesToRest([&] { return samplesDone(); }));
  const std::uint64_t before = samplesDone();
  fullPicture(*window_);  // a still picture of the light there is
  ASSERT_TRUE(comesToRest([&] { return samplesDone(); }));
  EXPECT_EQ(samplesDone(), before);
  EXPECT_TRUE(status()->text().contains("paused"));
  status()->pauseButton()->click();
  EXPECT_TRUE(waitUntil([&] { return samplesDone() > before; }));
  EXPECT_EQ(light()->state().phase, Phase::baking);
}

TEST_F(LightWindowTest, StoppedLightStaysStoppedUntilTheViewChanges) {
  lightUp(endless);
  ASSERT_TRUE(waitUntil([&] { return samplesDone() > 0; }));
  status()->stopButton()->click();
  ASSERT_TRUE(waitUntil([&] { return !light()->changing(); }));
  fullPicture(*window_);  // more rays of the same view want nothing new
  QTest::qWait(500);      // nothing but time: it would begin again of itself
  EXPECT_FALSE(light()->changing());
  EXPECT_EQ(status()->text(), "Light stopped");
  EXPECT_NE(light()->light(), nullptr);  // what there is stays
  status()->pauseButton()->click();
  EXPECT_TRUE(waitForPhase(Phase::baking));
  status()->stopButton()->click();
  ASSERT_TRUE(waitUntil([&] { return !light()->changing(); }));
  viewport()->applyStandardView(scene::StandardView::superior);
  EXPECT_TRUE(waitForPhase(Phase::baking));
}

TEST_F(LightWindowTest, StillPicturesHaveOneRayPerPixelUntilTheLightIsThere) {
  set("picture.supersampling", 3);
  int most = 0, pictures = 0;
  bool counts = false;
  QObject::connect(viewport(), &ui::Viewport::reported,
                   [&](const render::FrameReport&, const render::FrameRequest& request) {
                     if (!counts) return;
                     ++pictures;
                     most = std::max(most, request.supersampling);
                   });
  lightUp(endless);
  ASSERT_TRUE(waitUntil([&] { return samplesDone() > 0; }));
  counts = true;
  QTest::qWait(1000);  // nothing but time: several times what a view rests before its fine picture
  EXPECT_TRUE(waitUntil([&] { return pictures >= 3; }));
  EXPECT_EQ(light()->state().phase, Phase::baking);
  EXPECT_EQ(most, 1);
  EXPECT_FALSE(viewport()->complete());
  status()->pauseButton()->click();
  fullPicture(*window_);
  EXPECT_EQ(most, 3);
}

// Texels are filtered on their way to the graphics card: all at once would hold up the window.
TEST_F(LightWindowTest, EachPictureTakesALittleOfTheLight) {
  std::size_t pictures = 0, most = 0;
  QObject::connect(viewport(), &ui::Viewport::reported,
                   [&](const render::FrameReport&, const render::FrameRequest& request) {
                     ++pictures;
                     EXPECT_GT(request.lightUploadBytes, 0U) << "0 is all of it";
                     most = std::max(most, request.lightUploadBytes);
                   });
  lightUp(4);
  ASSERT_TRUE(waitForPhase(Phase::finished));
  fullPicture(*window_);
  EXPECT_GT(pictures, 1U);
  EXPECT_LE(most, std::size_t{4} << 20);
}

TEST_F(LightWindowTest, AnotherVolumeHasNoneOfTheLightOfTheOneBefore) {
  lightUp(8);
  ASSERT_TRUE(waitForPhase(Phase::finished));
  const ui::LightPointer before = light()->light();
  ASSERT_NE(before, nullptr);
  bool dropped = false;
  QObject::connect(window_->document(), &ui::Document::volumeChanged,
                   [&] { dropped = light()->light() == nullptr; });
  DialogAnswers discard(QMessageBox::Discard);
  ASSERT_TRUE(load(*window_, "phantom:torus:20"));
  EXPECT_TRUE(dropped);
  EXPECT_EQ(light()->light(), nullptr) << "it takes the default look";
  lightUp(8);
  EXPECT_TRUE(waitUntil([&] { return light()->light() != nullptr; }));
  EXPECT_NE(light()->light(), before);
  EXPECT_TRUE(waitForPhase(Phase::finished));
}

TEST_F(LightWindowTest, AMissingProbeIsSaidOnceAndLightComesBackWithoutIt) {
  lightUp(4);
  ASSERT_TRUE(waitForPhase(Phase::finished));
  bool saidByPanel = false;
  QObject::connect(window_->findChild<ui::EnvironmentPreview*>(), &ui::EnvironmentPreview::failed,
                   [&] { saidByPanel = true; });
  set("light.environment.file", "/nowhere/sky.exr");
  ASSERT_TRUE(waitForPhase(Phase::failed));
  EXPECT_EQ(status()->text(), "No light");
  EXPECT_EQ(window_->messageBar()->kind(), ui::MessageBar::Kind::error);
  EXPECT_TRUE(window_->messageBar()->text().contains("sky.exr"))
      << window_->messageBar()->text().toStdString();
  ASSERT_TRUE(waitUntil([&] { return saidByPanel; }));  // of its picture, the same
  window_->messageBar()->clear();
  QTest::qWait(600);  // nothing but time: two polls of light that does not change
  EXPECT_TRUE(window_->messageBar()->isHidden());  // closed is closed
  set("light.environment.file", "");
  EXPECT_TRUE(waitForPhase(Phase::finished));
}

TEST_F(LightWindowTest, ProgressReadsWell) {
  EXPECT_EQ(ui::durationText(0.0), "0.1 s");
  EXPECT_EQ(ui::durationText(4.26), "4.3 s");
  EXPECT_EQ(ui::durationText(45.4), "45 s");
  EXPECT_EQ(ui::durationText(720.0), "12 min");
  EXPECT_EQ(ui::rateText(1.26e6), "1.3 million rays/s");
  EXPECT_EQ(ui::rateText(45e3), "45 thousand rays/s");
  app::LightState state;
  state.phase = Phase::baking;
  state.counters.samplesWanted = 1000;
  state.counters.samplesDone = 999;
  state.counters.raysPerSecond = 2e6;
  state.counters.secondsLeft = 3.0;
  ui::LightStatus widget;
  widget.setState(state, false);
  EXPECT_EQ(widget.text(), "Light: 99 % · 2 million rays/s · 3 s left");
}

}  // namespace isolux::test
