// The two canvases: they show the same pixels, and where textures do not work, pixels are shown instead.
// With ISOLUX_TEST_CANVAS=textures (tests/ui/CMakeLists.txt) all of it runs on textures, else the tests of
// textures skip.
#include "tests/support/ui/window_fixture.h"

// Before Qt's headers of OpenGL.
#include "render/gl/gl.h"

#include <functional>
#include <utility>
#include <vector>

#include <QOpenGLWidget>
#include <QSettings>
#include <QTest>

#include "base/destroy_in_background.h"
#include "base/error.h"
#include "render/gl/gl_messages.h"
#include "render/gl/handed_picture.h"
#include "scene/settings/settings.h"
#include "tests/support/losing_context.h"
#include "ui/viewport/canvas_choice.h"
#include "ui/viewport/viewport.h"

namespace isolux::test {

namespace {

using ui::CanvasKind;
using Assignments = std::vector<std::pair<const char*, nlohmann::json>>;

// On textures only where the process may have them.
class CanvasTest : public WindowTest {
 protected:
  void SetUp() override {
    if (!QCoreApplication::testAttribute(Qt::AA_ShareOpenGLContexts))
      GTEST_SKIP() << "textures are not asked for";
    WindowTest::SetUp();
    ASSERT_EQ(kind(), CanvasKind::textures) << window_->viewport()->canvas().why.toStdString();
  }
  ui::Viewport* viewport() { return window_->viewport(); }
  CanvasKind kind() { return viewport()->canvas().kind; }
  void set(const Assignments& assignments) {
    ui::Edit edit{window_->document()->scene(), "Change", {}, false};
    for (const auto& [path, value] : assignments) scene::setting(path).set(edit.scene, value);
    window_->document()->edit(edit);
  }
  void show(CanvasKind wanted) {
    const auto request = wanted == CanvasKind::textures ? scene::Canvas::textures : scene::Canvas::pixels;
    viewport()->setCanvas(ui::chooseCanvas(request));
    ASSERT_EQ(kind(), wanted);
  }
  // What the window has on screen of the picture and what lies over it.
  QImage onScreen() {
    fullPicture(*window_);
    return viewport()->grab().toImage();
  }
};

const std::vector<std::pair<const char*, Assignments>> pictures = {
    {"plain", {}},
    {"tone", {{"look.mode", "tone"}}},
    {"lambert", {{"look.mode", "lambert"}}},
    {"lines", {{"look.mode", "tone"}, {"look.ridges", 1.0}, {"look.contours", 1.0}}},
    {"curvature", {{"look.mode", "kappa1"}, {"look.legend", true}}},
    {"flow", {{"look.mode", "kappa1"}, {"flow.strength", 0.5}}},
    {"normals", {{"look.mode", "normal"}}},
    {"wood", {{"look.texture", "wood"}}},
    {"one ray", {{"picture.supersampling", 1}}},
    {"nine rays", {{"picture.supersampling", 3}}},
    {"white", {{"look.background_top", {1.0, 1.0, 1.0}}, {"look.background_bottom", {1.0, 1.0, 1.0}}}},
    {"half transparent", {{"isosurface.opacity", 0.5}}},
    {"orthographic", {{"camera.projection", "orthographic"}}},
    {"nothing to be seen", {{"isosurface.value", 1e6}}},
    {"cut", {{"clip.box", {{0.0, 0.0, 0.0}, {20.0, 20.0, 20.0}}}}},
    {"three lamps off", {{"light.setup", "key"}}},
};

}  // namespace

TEST_F(CanvasTest, BothShowTheSamePixels) {
  ASSERT_TRUE(load(*window_, "phantom:head:48"));
  for (const auto& [name, assignments] : pictures) {
    SCOPED_TRACE(name);
    show(CanvasKind::textures);
    set(assignments);
    const QImage textures = onScreen(), read = viewport()->shown();
    show(CanvasKind::pixels);
    EXPECT_EQ(differingPixels(read, fullPicture(*window_), 0), 0.0);
    EXPECT_EQ(differingPixels(textures, onScreen(), 0), 0.0);
    window_->document()->undo();
  }
}

// Letters, the scale bar, marks and slices lie over both.
TEST_F(CanvasTest, BothShowTheSameOverThePicture) {
  ASSERT_TRUE(load(*window_, "phantom:head:48"));
  ui::Edit edit{window_->document()->scene(), "Marks", {}, false};
  scene::Mark mark;
  mark.kind = scene::MarkKind::distance;
  mark.points = {{-20, 0, 0}, {20, 10, 5}};
  edit.scene.marks.push_back(mark);
  window_->document()->edit(edit);
  const QImage errors = [&] {
    QImage image(fullPicture(*window_).size(), QImage::Format_RGB32);
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) image.setPixel(x, y, qRgb(x & 255, y & 255, (x + y) & 255));
    return image;
  }();
  std::vector<QImage> shown;
  for (const CanvasKind wanted : {CanvasKind::textures, CanvasKind::pixels}) {
    show(wanted);
    shown.push_back(onScreen());
    viewport()->setOver(ui::Viewport::Over::errors, errors, viewport()->shown());
    EXPECT_TRUE(viewport()->showsOver(ui::Viewport::Over::errors));
    shown.push_back(viewport()->grab().toImage());
  }
  EXPECT_EQ(differingPixels(shown[0], shown[2], 0), 0.0);
  EXPECT_EQ(differingPixels(shown[1], shown[3], 0), 0.0);
  EXPECT_GT(differingPixels(shown[0], shown[1], 0), 0.9);
}

TEST_F(CanvasTest, PicturesAreReadBackOnlyWhereSomebodyAsks) {
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  ASSERT_TRUE(waitUntil([&] { return viewport()->complete(); }));
  const QImage& first = viewport()->shown();
  EXPECT_FALSE(first.isNull());
  EXPECT_EQ(first.cacheKey(), viewport()->shown().cacheKey()) << "once";
  const QImage before = first;
  drag(viewport(), {300, 200}, {340, 220}, Qt::LeftButton);
  EXPECT_GT(differingPixels(before, fullPicture(*window_), 0), 0.01);
}

TEST_F(CanvasTest, TexturesDoNotGather) {
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  constexpr std::size_t most = 6;  // on screen, fading, delivered, being drawn, and one of two sizes
  for (int round = 0; round < 12; ++round) {
    drag(viewport(), {300, 200}, {300 + 10 * round, 240}, round % 2 ? Qt::LeftButton : Qt::MiddleButton);
    window_->resize(900 + 20 * (round % 3), 640);
    QTest::qWait(20);
    EXPECT_LE(render::PictureRing::textures(), most);
  }
  fullPicture(*window_);
  EXPECT_EQ(render::glErrorCount(), 0u);
  window_.reset();
  EXPECT_TRUE(base::awaitDestroyed(60.0));
  EXPECT_EQ(render::PictureRing::textures(), 0u);
}

TEST_F(CanvasTest, TheWindowMayGoWhileAPictureIsDrawn) {
  ASSERT_TRUE(load(*window_, "phantom:gyroid:64"));
  set({{"picture.supersampling", 4}});
  drag(viewport(), {300, 200}, {400, 240}, Qt::LeftButton);
  window_.reset();
  EXPECT_TRUE(base::awaitDestroyed(60.0));
  EXPECT_EQ(render::PictureRing::textures(), 0u);
}

TEST_F(CanvasTest, SeveralWindowsShareTheCard) {
  const auto second = makeWindow();
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  ASSERT_TRUE(load(*second, "phantom:torus:32"));
  EXPECT_EQ(second->viewport()->canvas().kind, CanvasKind::textures);
  EXPECT_EQ(differingPixels(fullPicture(*window_), fullPicture(*second), 0), 0.0);
}

TEST_F(CanvasTest, ItComesBackFromFullScreenAndFromBeingMinimised) {
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  const QImage before = onScreen();
  window_->showFullScreen();
  QTest::qWait(100);
  window_->showMinimized();
  QTest::qWait(100);
  window_->showNormal();
  window_->resize(900, 640);
  ASSERT_TRUE(waitUntil([&] { return viewport()->grab().toImage().size() == before.size(); }));
  EXPECT_EQ(differingPixels(before, onScreen(), 0), 0.0);
}

TEST_F(CanvasTest, AnotherWindowShowsThePictureToo) {
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  const QImage before = onScreen();
  auto* const canvas = viewport()->findChild<QOpenGLWidget*>();
  ASSERT_NE(canvas, nullptr);
  QWidget other;
  other.resize(viewport()->size());
  canvas->setParent(&other);
  other.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&other));
  EXPECT_EQ(differingPixels(canvas->grabFramebuffer(), viewport()->shown(), 0), 0.0);
  canvas->setParent(viewport());
  canvas->lower();
  canvas->show();
  EXPECT_EQ(differingPixels(before, onScreen(), 0), 0.0);
}

TEST_F(CanvasTest, ADriverThatCannotShareIsAnsweredWithPixels) {
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  const QImage before = fullPicture(*window_);
  std::vector<QString> notes;
  QObject::connect(viewport(), &ui::Viewport::noted, [&](const QString& note) { notes.push_back(note); });
  viewport()->setCanvas({CanvasKind::textures, "", []() -> std::unique_ptr<render::OffscreenContext> {
                           throw base::Error(base::ErrorKind::graphics, "", "OpenGL", "no sharing");
                         }});
  ASSERT_TRUE(waitUntil([&] { return kind() == CanvasKind::pixels; }));
  EXPECT_EQ(differingPixels(before, fullPicture(*window_), 0), 0.0);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_TRUE(notes[0].contains("no sharing")) << notes[0].toStdString();
  EXPECT_TRUE(ui::describe(viewport()->canvas()).contains("no sharing"));
}

TEST_F(CanvasTest, AfterAResetOfTheDriverThePictureIsDrawnAgain) {
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  const QImage before = fullPicture(*window_);
  for (const CanvasKind lost : {CanvasKind::textures, CanvasKind::pixels}) {
    const auto real = lost == CanvasKind::textures ? ui::chooseCanvas(scene::Canvas::textures).context : [] {
      return render::OffscreenContext::create(render::ContextChoice::software);
    };
    viewport()->setCanvas({lost, "", [real] { return std::make_unique<LosingContext>(real()); }});
    EXPECT_EQ(differingPixels(before, fullPicture(*window_), 0), 0.0);
    bool told = false;
    const auto connection = QObject::connect(viewport(), &ui::Viewport::noted, [&] {
      LosingContext::lost = false;
      told = true;
    });
    LosingContext::lost = true;
    set({{"look.ambient", lost == CanvasKind::textures ? 0.3 : 0.4}});
    ASSERT_TRUE(waitUntil([&] { return told; }));
    QObject::disconnect(connection);
    EXPECT_EQ(kind(), CanvasKind::pixels);
    window_->document()->undo();
    EXPECT_EQ(differingPixels(before, fullPicture(*window_), 0), 0.0);
    EXPECT_FALSE(viewport()->problem().has_value());
  }
}

TEST_F(CanvasTest, OfSoftwareDriversTheQuickerCanvasIsMeasuredAndStored) {
  const auto stored = [] { return QSettings().value("window/canvas_measured").toString(); };
  EXPECT_TRUE(stored().isEmpty());
  const ui::CanvasChoice choice = ui::chooseCanvas(scene::Canvas::automatic);
  EXPECT_TRUE(choice.why.contains("textures take")) << choice.why.toStdString();
  EXPECT_EQ(stored(), choice.kind == CanvasKind::pixels ? choice.why : QString());
  EXPECT_EQ(static_cast<bool>(choice.context), choice.kind == CanvasKind::textures);
}

// In a process of its own, without OpenGL of the window system (tests/ui/CMakeLists.txt).
class NoWindowGl : public WindowTest {};

TEST_F(NoWindowGl, PixelsAreShownAndTheReasonIsSaid) {
  ASSERT_TRUE(load(*window_, "phantom:torus:32"));
  EXPECT_FALSE(fullPicture(*window_).isNull());
  EXPECT_EQ(window_->viewport()->canvas().kind, CanvasKind::pixels);
  EXPECT_TRUE(window_->viewport()->canvas().why.contains("no OpenGL"))
      << window_->viewport()->canvas().why.toStdString();
}

}  // namespace isolux::test
