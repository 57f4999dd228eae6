// Pictures that are stopped while they are drawn: what is kept of them must be right for the next one.
#include <chrono>
#include <stop_token>
#include <thread>

#include "base/error.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/stop_latency.h"

namespace isolux::test {
namespace {

using Clock = std::chrono::steady_clock;
using Settings = std::vector<std::string>;

class StoppedPicturesGlTest : public RenderGlTest {
 protected:
  static constexpr glm::ivec2 kSize{256, 192};

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
    render::FrameRequest request;
    request.size = size;
    std::stop_source source;
    request.stop = source.get_token();
    const std::jthread stopper([&source, delay] {
      std::this_thread::sleep_for(delay);
      source.request_stop();
    });
    try {
      renderer_->render(scene, request);
      return false;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
      return true;
    }
  }

  // A full picture of a window.
  void expectMakesWaySoon(const char* executor) {
    renderer_->setVolume(volume_);
    const scene::Scene scene = sceneOf({executor, "look.mode=curvature_2d"});
    const auto draw = [&](const std::stop_token& stop) {
      renderer_->invalidate();
      render::FrameRequest request;
      request.size = {1280, 900};
      request.supersampling = 2;
      request.stop = stop;
      renderer_->render(scene, request);
    };
    draw({});  // programs are compiled
    expectStopsSoon([&](base::Progress& progress) { draw(progress.token()); });
  }

  const std::shared_ptr<const volume::PreparedVolume> volume_ = phantom("gyroid", 64);
};

}  // namespace

// Scene B is stopped at moments spread over its time; scene A, in whose images it has begun to draw, must be
// what it was.
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
      picture(b);
      const double whole = report_.milliseconds;
      int stops = 0;
      constexpr int moments = 4;
      for (int i = 0; i < moments; ++i) {
        picture(a);
        const auto delay = std::chrono::duration<double, std::milli>(whole * i / moments);
        const bool smaller = i % 2 == 1;  // images of another size take the place of those that are there
        stops += stopped(b, std::chrono::duration_cast<Clock::duration>(delay), smaller ? kSize / 2 : kSize);
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

TEST_F(StoppedPicturesGlTest, ShadersMakeWaySoon) {
  expectMakesWaySoon("picture.executor=gpu");
}

TEST_F(StoppedPicturesGlTest, TheProcessorMakesWaySoon) {
  expectMakesWaySoon("picture.executor=cpu");
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
