// What tests of the renderer share: a software context, phantoms ready to draw, and deferred images.
#pragma once

#include <cstdlib>
#include <memory>

#include <gtest/gtest.h>

#include "render/gl/gl_context.h"
#include "render/gl/gl_messages.h"
#include "render/renderer.h"
#include "scene/camera.h"
#include "scene/rules/automatic.h"
#include "scene/settings/settings.h"
#include "tests/support/volumes.h"

namespace isolux::test {

// Tests with this fixture need software GL and nothing else; their names end in "GlTest". With ISOLUX_GPU=1
// in the environment they draw on a graphics card. An error that the driver reports fails the test, wherever
// it comes from.
class RenderGlTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    context_ = render::OffscreenContext::create(std::getenv("ISOLUX_GPU") ? render::ContextChoice::egl
                                                                          : render::ContextChoice::software);
  }
  static void TearDownTestSuite() { context_.reset(); }
  void SetUp() override {
    context_->makeCurrent();
    render::forgetGlErrors();
    renderer_ = std::make_unique<render::Renderer>(context_->gl());
  }
  void TearDown() override {
    renderer_.reset();
    for (const std::string& error : render::glErrors()) ADD_FAILURE() << "OpenGL: " << error;
  }

  static bool onCard() { return !context_->description().software; }

  // The automatic camera and isovalue, and the light, that the numbers of these tests were found with.
  static scene::Scene pinned(scene::Scene scene) {
    const scene::Light light;
    if (scene.light.direction == light.direction) scene.light.direction = {-0.5, 0.7, 0.9};
    if (scene.look.ambientVariation == scene::Look{}.ambientVariation) scene.look.ambientVariation = 0.0;
    scene.light.setup = scene::LightSetup::key;
    scene.camera.frames = scene::Frames::volume;
    scene.isosurface.suggestion = scene::Suggestion::contrast;
    return scene;
  }

  // `scene` changed by assignments; those of the machine go to the renderer, which has the defaults else.
  scene::Scene assigned(const std::vector<std::string>& assignments, scene::Scene scene = {}) {
    scene::HostSettings host = host_;
    scene = pinned(std::move(scene));
    for (const std::string& assignment : assignments)
      if (scene::isHostSetting(assignment))
        scene::applyAssignment(host, assignment);
      else
        scene::applyAssignment(scene, assignment);
    renderer_->setHostSettings(host);
    return scene;
  }

  struct Images {
    render::AovImage hit, position, voxel, depth, normal, error;
  };
  // All deferred images of `scene`, automatic settings resolved.
  Images images(const std::shared_ptr<const volume::PreparedVolume>& volume, scene::Scene scene,
                glm::ivec2 size) {
    scene_ = scene::resolve(pinned(std::move(scene)), volume->facts);
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = size;
    for (const render::AovInfo& info : render::aovs()) request.aovs.push_back(info.aov);
    report_ = renderer_->render(scene_, request);
    using render::Aov;
    return {renderer_->readAov(Aov::hit),    renderer_->readAov(Aov::position),
            renderer_->readAov(Aov::voxel),  renderer_->readAov(Aov::depth),
            renderer_->readAov(Aov::normal), renderer_->readAov(Aov::value_error)};
  }
  // The camera ray of a pixel (row 0 at the top) of the last images().
  scene::Ray ray(glm::ivec2 pixel, glm::ivec2 size) const {
    const glm::dvec2 ndc(2.0 * (pixel.x + 0.5) / size.x - 1.0, 1.0 - 2.0 * (pixel.y + 0.5) / size.y);
    return scene::rayThrough(scene::frameOf(scene_.camera), ndc, static_cast<double>(size.x) / size.y);
  }
  static glm::dvec3 at(const render::AovImage& image, std::size_t pixel) {
    const float* v = &image.values[3 * pixel];
    return {v[0], v[1], v[2]};
  }

  static inline std::unique_ptr<render::OffscreenContext> context_;
  std::unique_ptr<render::Renderer> renderer_;
  scene::HostSettings host_;  // what assigned() begins with
  scene::Scene scene_;
  render::FrameReport report_;
};

// Tests that run once with shaders and once with the processor.
class ExecutorsGlTest : public RenderGlTest, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    RenderGlTest::SetUp();
    scene::applyAssignment(host_, std::string("picture.executor=") + GetParam());
    renderer_->setHostSettings(host_);
  }
};
// In each file, of its fixture.
#define ISOLUX_ON_BOTH_EXECUTORS(fixture)                                       \
  INSTANTIATE_TEST_SUITE_P(Executors, fixture, ::testing::Values("gpu", "cpu"), \
                           [](const auto& executor) { return std::string(executor.param); })

}  // namespace isolux::test
