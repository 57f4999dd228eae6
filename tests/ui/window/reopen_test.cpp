// Opening what is on show already, in each of the ways there are: the picture stays as it is.
#include "tests/support/surfaces.h"
#include "tests/support/ui/window_fixture.h"

#include <filesystem>
#include <map>
#include <utility>

#include "scene/settings/settings.h"
#include "tests/support/test_data.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/picture_accuracy.h"
#include "ui/document/baked_light.h"
#include "ui/presets/looks_panel.h"
#include "ui/presets/thumbnail_painter.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"
#include "volume/write/writer.h"

namespace isolux::test {

namespace {

class ReopenTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    QObject::connect(window_->viewport(), &ui::Viewport::reported,
                     [this](const render::FrameReport& report, const render::FrameRequest&) {
                       blocksActive_ = report.blocksActive;
                     });
    file_ = writeBall(36);
    ASSERT_TRUE(load(*window_, file_));
  }
  // A view and a look of its own, so that a picture that starts anew is told from one that is kept.
  void change() {
    ui::Edit edit{window_->document()->scene(), "Change", {}, false};
    edit.scene.surfaces.front().value = 500.0;
    edit.scene.look.mode = scene::LookMode::tone;
    window_->document()->edit(edit);
  }
  // Without the message bar, which takes a row of the picture.
  QImage picture() {
    window_->messageBar()->hide();
    return fullPicture(*window_);
  }
  void expectTheSamePictureAfterOpening(const QString& path) {
    const QImage before = picture();
    ASSERT_GT(blocksActive_, 0u);
    blocksActive_ = 0;
    ASSERT_TRUE(load(*window_, path));
    const QImage after = picture();
    EXPECT_GT(blocksActive_, 0u);
    EXPECT_EQ(differingPixels(before, after, 0), 0.0);
  }

  QString file_;
  std::size_t blocksActive_ = 0;
};

}  // namespace

TEST_F(ReopenTest, TheFileOnShowIsShownAgain) {
  expectTheSamePictureAfterOpening(file_);
}

TEST_F(ReopenTest, TheSessionJustSavedIsShown) {
  change();
  const QString session = newFile("ball.isolux");
  ASSERT_TRUE(window_->document()->saveSession(session));
  expectTheSamePictureAfterOpening(session);
}

TEST_F(ReopenTest, ThePictureJustSavedIsShown) {
  change();
  picture();
  const QString png = newFile("ball.png");
  ASSERT_TRUE(window_->savePicture(png));
  ASSERT_TRUE(window_->document()->saveSession(newFile("ball.isolux")));  // or opening asks
  expectTheSamePictureAfterOpening(png);
}

TEST_F(ReopenTest, TheSameDataInAnotherFormatIsShown) {
  const QString other = newFile("ball.vti");
  volume::writeVolume(window_->document()->volume()->grid(), other.toStdString());
  expectTheSamePictureAfterOpening(other);
}

TEST_F(ReopenTest, TheFileOnShowIsShownAgainUnderItsStoredLight) {
  ui::Edit edit{window_->document()->scene(), "Light", {}, false};
  scene::setting("gi.samples").set(edit.scene, 4);
  scene::setting("look.mode").set(edit.scene, "gi");
  window_->document()->edit(edit);
  const ui::BakedLight* const light = window_->light();
  const auto lit = [&] {
    return light->isShown() && !light->changing() && light->state().phase == app::LightState::Phase::finished;
  };
  const auto settledPicture = [&] {  // light may come onto the picture in several frames
    QImage last = picture();
    EXPECT_TRUE(waitUntil([&] {
      const QImage previous = std::exchange(last, picture());
      return lit() && differingPixels(previous, last, 0) == 0.0;
    }));
    return last;
  };
  const QImage before = settledPicture();
  const QString session = newFile("lit.isolux");
  ASSERT_TRUE(window_->document()->saveSession(session));
  ASSERT_TRUE(load(*window_, session));
  EXPECT_EQ(differingPixels(before, settledPicture(), 0), 0.0);
  EXPECT_GT(blocksActive_, 0u);
}

// Each panel has been seen, and has measured or drawn what it does: none keeps the volume alive.
TEST_F(ReopenTest, TheVolumeBeforeIsFreed) {
  const auto accuracy = window_->panel<ui::AccuracyPanel>();
  for (const char* panel : {"Accuracy", "Looks", "Volume", "Pieces", "Marks", "Passes", "Settings"}) {
    window_->showPanel(panel);
    fullPicture(*window_);
    if (QString(panel) == "Accuracy") {
      ASSERT_TRUE(waitUntil([&] { return accuracy->picture().known().has_value(); }));
    }
    if (QString(panel) == "Looks") {
      const auto& painter = window_->panel<ui::LooksPanel>()->painter();
      ASSERT_TRUE(waitUntil([&] { return painter.complete() && painter.drawnCount() > 0; }));
    }
  }
  const std::weak_ptr<const volume::PreparedVolume> before = window_->document()->volume();
  ASSERT_TRUE(load(*window_, "phantom:torus:24"));
  fullPicture(*window_);
  EXPECT_TRUE(waitUntil([&] { return before.expired(); }, 30000));
}

// Look, cuts, hidden pieces, values and names are of the volume before; the background is the user's.
TEST_F(ReopenTest, AnotherVolumeIsShownWhole) {
  ui::Edit edit{window_->document()->scene(), "Change", {}, false};
  edit.scene.look.mode = scene::LookMode::tone;
  edit.scene.look.backgroundTop = edit.scene.look.backgroundBottom = glm::dvec3(1.0);
  edit.scene.surfaces.front().name = "Skin";
  test::surfaceAt(edit.scene, 1).shown = true;
  test::surfaceAt(edit.scene, 1).value = 1e6;
  edit.scene.clip.planes = {{glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0)}};
  edit.scene.clip.box = {glm::dvec3(-1.0), glm::dvec3(1.0)};
  edit.scene.clip.removed = {glm::dvec3(0.0), glm::dvec3(1.0)};
  edit.scene.pieces.hidden = {glm::dvec3(0.0)};
  edit.scene.slice.position = glm::dvec3(500.0);
  edit.scene.slice.width = 1.0;
  window_->document()->edit(edit);
  ASSERT_TRUE(window_->document()->saveSession(newFile("ball.isolux")));  // or opening asks
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  scene::Scene expected;
  expected.source.path = "phantom:torus:32";
  expected.look.backgroundTop = expected.look.backgroundBottom = glm::dvec3(1.0);
  expected.picture = window_->document()->scene().picture;
  EXPECT_TRUE(window_->document()->scene() == expected) << scene::toJson(window_->document()->scene()).dump();

  ui::Edit tone{window_->document()->scene(), "Change", {}, false};
  tone.scene.look.mode = scene::LookMode::tone;
  tone.scene.look.ridges = 1.0;
  window_->document()->edit(tone);
  window_->document()->resetSettings();
  EXPECT_TRUE(window_->document()->scene() == expected) << scene::toJson(window_->document()->scene()).dump();
  window_->document()->undo();
  EXPECT_EQ(window_->document()->scene().look.mode, scene::LookMode::tone) << "one step";
}

}  // namespace isolux::test
