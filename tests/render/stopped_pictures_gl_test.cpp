// Pictures that are stopped while they are drawn: what is kept of them must be right for the next one.
#include <chrono>
#include <cstdio>
#include <stop_token>
#include <thread>
#include <utility>

#include "base/error.h"
#include "render/gl/gl.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/stop_latency.h"

namespace isolux::test {
namespace {

using Clock = std::chrono::steady_clock;
using Settings = std::vector<std::string>;

// The calls of GL by which a picture advances: draw calls, and waits for what was drawn, after each band of
// rows and each pass. One of the waits can ask for a stop, at the same place of the picture on any machine.
struct GlCalls {
  static inline decltype(render::Gl::Finish) finish = nullptr;
  static inline decltype(render::Gl::DrawArrays) drawArrays = nullptr;
  static inline int finished = 0, drawn = 0, drawnAfterStop = 0;
  static inline int stopAt = 0;  // the wait that asks for it, counted from 1; 0: none
  static inline std::stop_source stop;

  static void countedFinish() {
    finish();
    if (++finished == stopAt) stop.request_stop();
  }
  static void countedDrawArrays(GLenum mode, GLint first, GLsizei count) {
    drawArrays(mode, first, count);
    ++drawn;
    drawnAfterStop += stop.stop_requested();
  }
  static std::shared_ptr<const render::Gl> around(const render::Gl& gl) {
    const auto counted = std::make_shared<render::Gl>(gl);
    finish = std::exchange(counted->Finish, countedFinish);
    drawArrays = std::exchange(counted->DrawArrays, countedDrawArrays);
    return counted;
  }
  static void begin(int stopAtWait) {
    finished = drawn = drawnAfterStop = 0;
    stopAt = stopAtWait;
    stop = {};
  }
};

class StoppedPicturesGlTest : public RenderGlTest {
 protected:
  static constexpr glm::ivec2 kSize{256, 192};

  void SetUp() override {
    RenderGlTest::SetUp();
    renderer_ = std::make_unique<render::Renderer>(GlCalls::around(*context_->gl()));
  }

  scene::Scene sceneOf(const Settings& settings) {
    return scene::resolve(assigned(settings), volume_->facts);
  }

  std::vector<std::uint8_t> picture(const scene::Scene& scene, glm::ivec2 size = kSize) {
    render::FrameRequest request;
    request.size = size;
    report_ = renderer_->render(scene, request);
    return renderer_->readColor().rgba;
  }

  // Draws `scene`, stopped after `delay`; false when it was complete before.
  bool stopped(const scene::Scene& scene, Clock::duration delay, glm::ivec2 size = kSize) {
    GlCalls::begin(0);
    const std::jthread stopper([stop = GlCalls::stop, delay]() mutable {
      std::this_thread::sleep_for(delay);
      stop.request_stop();
    });
    return !completed(scene, size);
  }
  // The same, stopped by that wait for GL.
  bool stoppedBy(const scene::Scene& scene, int wait, glm::ivec2 size = kSize) {
    GlCalls::begin(wait);
    return !completed(scene, size);
  }
  bool completed(const scene::Scene& scene, glm::ivec2 size) {
    render::FrameRequest request;
    request.size = size;
    request.stop = GlCalls::stop.get_token();
    try {
      renderer_->render(scene, request);
      return true;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
      return false;
    }
  }

  // A full picture of a window.
  void drawLarge(const char* executor, const std::stop_token& stop) {
    renderer_->setVolume(volume_);
    renderer_->invalidate();
    render::FrameRequest request;
    request.size = {1280, 900};
    request.supersampling = 2;
    request.stop = stop;
    renderer_->render(sceneOf({executor, "look.mode=curvature_2d"}), request);
  }

  const std::shared_ptr<const volume::PreparedVolume> volume_ = phantom("gyroid", 64);
};

}  // namespace

// Scene B is stopped at moments spread over its time, half of them waits for GL, which come at any load;
// scene A, in whose images it has begun to draw, must be what it was.
TEST_F(StoppedPicturesGlTest, ThePictureBeforeIsTheSameAgain) {
  for (const char* executor : {"picture.executor=gpu", "picture.executor=cpu"})
    for (const Settings& look :
         {Settings{"look.mode=curvature_2d"}, Settings{"look.shadow=1"}, Settings{"isosurface.opacity=0.5"},
          Settings{"hit.method=sampled"}, Settings{"memory.layout=bricks"}}) {
      const auto with = [&](Settings more) {
        more.insert(more.end(), look.begin(), look.end());
        more.emplace_back(executor);
        return more;
      };
      renderer_->setVolume(volume_);
      const scene::Scene a = sceneOf(with({})), b = sceneOf(with({"camera.fov=20"}));
      const auto pictureA = picture(a), pictureB = picture(b);
      renderer_->invalidate();
      GlCalls::begin(0);
      picture(b);
      const double whole = report_.milliseconds;
      const int waits = GlCalls::finished;
      int stops = 0;
      constexpr int moments = 4;
      for (int i = 0; i < moments; ++i) {
        picture(a);
        const auto delay = std::chrono::duration<double, std::milli>(whole * i / moments);
        const bool smaller = i % 2 == 1;  // images of another size take the place of those that are there
        const glm::ivec2 size = smaller ? kSize / 2 : kSize;
        stops += i % 2 == 0 ? stoppedBy(b, 1 + waits * i / moments, size)
                            : stopped(b, std::chrono::duration_cast<Clock::duration>(delay), size);
        EXPECT_EQ(picture(i % 3 == 2 ? b : a), i % 3 == 2 ? pictureB : pictureA)
            << look[0] << ", " << executor << ", moment " << i;
      }
      EXPECT_GT(stops, 0) << look[0] << ", " << executor;
    }
}

TEST_F(StoppedPicturesGlTest, WhatWasCompleteIsKept) {
  renderer_->setVolume(volume_);
  const scene::Scene a = sceneOf({});
  const auto expected = picture(a);
  scene::Scene look = a;
  look.look.specular = 0.9;
  render::FrameRequest request;
  request.size = kSize;
  std::stop_source source;
  request.stop = source.get_token();
  source.request_stop();
  EXPECT_THROW(renderer_->render(look, request), base::Error);
  EXPECT_EQ(picture(a), expected);
  for (const render::PassReport& pass : report_.passes) {
    if (pass.name != "cast") continue;
    EXPECT_EQ(pass.state, render::PassState::cached);
  }
}

// A draw call that was begun cannot be left: pictures that may be stopped are drawn in bands, and each
// program that the pass still has to run draws one at most.
TEST_F(StoppedPicturesGlTest, ShadersMakeWayAfterTheBandThatIsDrawn) {
  const char* const executor = "picture.executor=gpu";
  GlCalls::begin(0);
  drawLarge(executor, GlCalls::stop.get_token());
  const int whole = GlCalls::drawn, waits = GlCalls::finished;
  EXPECT_GT(whole, 15);
  for (const int wait : {1, 2, waits / 8, waits / 4, waits / 2}) {
    GlCalls::begin(wait);
    EXPECT_THROW(drawLarge(executor, GlCalls::stop.get_token()), base::Error) << wait;
    std::printf("stopped by wait %d of %d: %d of %d draw calls after it\n", wait, waits,
                GlCalls::drawnAfterStop, whole);
    EXPECT_LE(GlCalls::drawnAfterStop, 2) << "of " << whole << ", stopped by wait " << wait;
  }
}

TEST_F(StoppedPicturesGlTest, TheProcessorLeavesMostOfTheRestUndone) {
  const char* const executor = "picture.executor=cpu";
  drawLarge(executor, {});  // programs are compiled
  expectStopsSoon([&](base::Progress& progress) { drawLarge(executor, progress.token()); });
}

// Whether the surface was found anew is told once, by the first picture that is completed.
TEST_F(StoppedPicturesGlTest, ANewSurfaceIsToldByThePictureThatIsCompleted) {
  renderer_->setVolume(volume_);
  picture(sceneOf({}));
  const scene::Scene b = sceneOf({"camera.fov=20"});
  const double whole = report_.milliseconds;
  bool none = true;  // was completed
  for (int i = 1; i <= 4; ++i)
    none &= stopped(b, std::chrono::duration_cast<Clock::duration>(
                           std::chrono::duration<double, std::milli>(whole * i / 5.0)));
  scene::Scene look = b;
  look.look.specular = 0.9;
  picture(look);
  EXPECT_EQ(report_.surfaceChanged, none);
  picture(look);
  EXPECT_FALSE(report_.surfaceChanged);
}

}  // namespace isolux::test
