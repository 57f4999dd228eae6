// A visit of random actions - open, look, turn, undo, resize, save, reopen, close - ends with the picture
// that the command line draws from the saved session, pixel for pixel.
//
// ISOLUX_VISIT_ACTIONS and ISOLUX_VISIT_SEED make it longer and another; a failure names seed and action.
#include "tests/support/ui/window_fixture.h"

#include <cstdlib>
#include <iterator>
#include <random>

#include <QProcess>
#include <QTest>

#include "render/gl/gl_messages.h"
#include "render/gl/handed_picture.h"
#include "scene/settings/settings.h"
#include "tests/support/test_data.h"
#include "tests/support/ui/dialog_answers.h"
#include "tests/support/ui/time_bound.h"
#include "ui/viewport/viewport.h"
#include "ui/window/message_bar.h"

namespace isolux::test {

namespace {

unsigned numberFrom(const char* variable, unsigned otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? static_cast<unsigned>(std::strtoul(text, nullptr, 10)) : otherwise;
}

class Visitor {
 public:
  Visitor(unsigned seed, QString folder, QString volume, std::unique_ptr<ui::MainWindow> window)
      : random_(seed), folder_(std::move(folder)), volume_(std::move(volume)), window_(std::move(window)) {}

  ui::MainWindow& window() { return *window_; }

  // One random action; its name.
  std::string act() {
    struct Action {
      const char* name;
      void (Visitor::*run)();
    };
    static constexpr Action actions[] = {
        {"open", &Visitor::open},          {"change the look", &Visitor::changeLook},
        {"set", &Visitor::changeSetting},  {"set", &Visitor::changeSetting},
        {"turn", &Visitor::turn},          {"standard view", &Visitor::standardView},
        {"undo", &Visitor::undo},          {"undo", &Visitor::undo},
        {"redo", &Visitor::redo},          {"resize", &Visitor::resize},
        {"save session", &Visitor::save},  {"save picture", &Visitor::savePicture},
        {"reopen", &Visitor::reopen},      {"close", &Visitor::close},
        {"wait", &Visitor::waitForPicture}};
    const Action& action = actions[below(std::size(actions))];
    (this->*action.run)();
    QCoreApplication::processEvents();
    return action.name;
  }

  void settle() {
    EXPECT_TRUE(
        waitUntil([&] { return !window_->document()->loading() && window_->viewport()->complete(); }));
  }

 private:
  std::size_t below(std::size_t count) { return random_() % count; }
  double between(double low, double high) { return low + (high - low) * (random_() % 1000) / 1000.0; }
  ui::Document* document() { return window_->document(); }

  void finishLoading() {
    EXPECT_TRUE(waitUntil([&] { return !document()->loading(); }));
  }
  void openPath(const QString& path) {
    window_->openPath(path);
    if (below(6) == 0 && document()->volume()) {
      document()->cancelLoading();
    } else {
      finishLoading();
    }
  }
  void open() {
    const QString paths[] = {volume_, "phantom:ball:24", "phantom:torus:32", "phantom:head:32", volume_};
    openPath(paths[below(std::size(paths))]);
  }
  void reopen() {
    if (!saved_.isEmpty()) openPath(saved_);
  }
  void edit(const std::string& assignment) {
    ui::Edit edit{document()->scene(), QString::fromStdString(assignment), {}, false};
    scene::applyAssignment(edit.scene, assignment);
    document()->edit(edit);
  }
  void changeLook() {  // not gi: its light comes bit by bit
    const char* const looks[] = {"blinn_phong",  "lambert", "tone",  "kappa1",
                                 "curvature_2d", "normal",  "depth", "flow"};
    edit(std::string("look.mode=") + looks[below(std::size(looks))]);
  }
  void changeSetting() {
    const auto& volume = document()->volume();
    if (!volume) return;
    const auto& grid = volume->grid();
    switch (below(5)) {
      case 0:
        return edit("isosurface.value=" + std::to_string(between(grid.minimum(), grid.maximum())));
      case 1:
        return edit("look.ridges=" + std::to_string(between(0, 1)));
      case 2:
        return edit("isosurface.albedo=" + std::to_string(between(0.1, 1)) + ",0.5,0.25");
      case 3:
        return edit("camera.projection=" + std::string(below(2) != 0 ? "orthographic" : "perspective"));
      default:
        return edit("hit.field=" + std::string(below(2) != 0 ? "cubic" : "trilinear"));
    }
  }
  void turn() {
    const QPoint centre = window_->viewport()->rect().center();
    drag(window_->viewport(), centre,
         centre + QPoint(static_cast<int>(below(200)) - 100, static_cast<int>(below(90)) - 45));
  }
  void standardView() { window_->viewport()->applyStandardView(static_cast<scene::StandardView>(below(6))); }
  void undo() {
    document()->undo();
    finishLoading();
  }
  void redo() {
    document()->redo();
    finishLoading();
  }
  void resize() { window_->resize(700 + static_cast<int>(below(200)), 500 + static_cast<int>(below(140))); }
  void save() {
    saved_ = folder_ + QString("/visit%1.isolux").arg(below(3));
    EXPECT_TRUE(document()->saveSession(saved_));
  }
  void savePicture() {
    saved_ = folder_ + QString("/visit%1.png").arg(below(3));
    EXPECT_TRUE(window_->savePicture(saved_)) << window_->messageBar()->text().toStdString();
  }
  void waitForPicture() { settle(); }
  void close() {
    EXPECT_TRUE(window_->close());
    window_ = std::make_unique<ui::MainWindow>();
    window_->resize(800, 560);
    window_->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window_.get(), 120000));
    openPath(volume_);
    finishLoading();
  }

  std::mt19937 random_;
  QString folder_, volume_, saved_;
  std::unique_ptr<ui::MainWindow> window_;
};

}  // namespace

TEST_F(WindowTest, AVisitOfRandomActionsEndsWithThePictureOfItsSession) {
  const unsigned seed = numberFrom("ISOLUX_VISIT_SEED", 1), actions = numberFrom("ISOLUX_VISIT_ACTIONS", 40);
  const QString folder = QString::fromStdString(temporaryFolder().string());
  const QString volume = writeBall(28, {1.0, 1.0, 1.5});
  DialogAnswers discard(QMessageBox::Discard);
  Visitor visitor(seed, folder, volume, std::move(window_));
  ASSERT_TRUE(load(visitor.window(), volume));
  for (unsigned i = 0; i < actions; ++i) {
    restartTimeBound();
    const std::string name = visitor.act();
    ASSERT_TRUE(visitor.window().document()->volume()) << "seed " << seed << ", action " << i << ": " << name;
    ASSERT_FALSE(visitor.window().viewport()->problem())
        << "seed " << seed << ", action " << i << ": " << name << ": "
        << visitor.window().viewport()->problem()->toStdString();
    ASSERT_LE(render::PictureRing::textures(), 7u) << "seed " << seed << ", action " << i << ": " << name;
  }
  EXPECT_EQ(render::glErrorCount(), 0u) << render::glErrors().front();
  // An automatic view leaves what lies over the picture free: in the window other letters than in a picture.
  ui::Edit edit{visitor.window().document()->scene(), "View", {}, false};
  edit.scene.camera = visitor.window().document()->resolvedScene().camera;
  visitor.window().document()->edit(edit);
  visitor.settle();

  const QString session = folder + "/end.isolux", shown = folder + "/window.png",
                drawn = folder + "/command.png";
  ASSERT_TRUE(visitor.window().document()->saveSession(session));
  ASSERT_TRUE(visitor.window().savePicture(shown));
  const QImage picture(shown);
  QProcess render;
  render.start(ISOLUX_PROGRAM, {"render", session, "--out", drawn, "--size",
                                QString("%1x%2").arg(picture.width()).arg(picture.height())});
  ASSERT_TRUE(render.waitForFinished(120000));
  ASSERT_EQ(render.exitCode(), 0) << render.readAllStandardError().toStdString();
  EXPECT_EQ(differingPixels(picture, QImage(drawn), 0), 0.0)
      << "seed " << seed << ", " << actions << " actions, pictures in " << folder.toStdString();
  EXPECT_EQ(differingPixels(picture, fullPicture(visitor.window()), 0), 0.0) << "saved is what is on screen";
}

}  // namespace isolux::test
