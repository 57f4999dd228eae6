// Gloss in pictures: the furnace, the path-traced reference, and the work it asks for.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "app/light/light_picture.h"
#include "base/color.h"
#include "gi/light_scene.h"
#include "gi/reference/reference.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

class GlossGlTest : public RenderGlTest {
 protected:
  void use(const std::string& source, const std::vector<std::string>& settings) {
    base::Progress progress;
    scene::Scene scene;
    scene.source.path = source;
    volume_ = volume::loadVolume(scene.source, progress);
    scene.look.mode = scene::LookMode::gi;
    scene.picture.exposure = 0.0;
    scene.gi.samples = 256;
    scene_ = scene::resolve(assigned(settings, scene), volume_->facts);
    renderer_->setVolume(volume_);
  }
  render::LinearImage drawn(int supersampling = 1) {
    render::FrameRequest request;
    request.size = {96, 96};
    request.supersampling = supersampling;
    request.linear = true;
    app::LightController controller{{}};
    base::Progress progress;
    app::lightPicture(controller, *renderer_, scene_, request, volume_, progress);
    report_ = renderer_->render(scene_, request);
    return renderer_->readLinearPicture();
  }
  gi::ReferenceImage traced(std::uint32_t samples) const {
    base::Progress progress;
    const auto tracer = gi::lightTracerOf(scene_, volume_, progress);
    gi::Reference reference(volume_, tracer, gi::loadEnvironment(scene_.light.environment), scene_,
                            {.size = {96, 96}, .threads = 2}, progress);
    EXPECT_TRUE(reference.refineTo(samples, progress));
    return reference.image();
  }
  bool ran(const std::string& pass) const {
    return std::any_of(report_.passes.begin(), report_.passes.end(), [&](const render::PassReport& entry) {
      return entry.name == pass && entry.state == render::PassState::ran;
    });
  }
  // The mean over the surface of the picture less the reference, in standard errors of the reference, of
  // which `ownError` (a fraction of the mean) is the picture's.
  double apart(const render::LinearImage& picture, const gi::ReferenceImage& reference,
               double ownError) const {
    double difference = 0.0, variance = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < reference.hit.size(); ++i) {
      if (reference.hit[i] == 0) continue;
      const glm::dvec3 traced(reference.color[i]);
      const glm::dvec3 seen(picture.rgba[4 * i], picture.rgba[4 * i + 1], picture.rgba[4 * i + 2]);
      difference += base::luminance(seen - traced);
      if (std::isfinite(reference.glossVariance[i]))
        variance += static_cast<double>(reference.glossVariance[i]);
      variance += static_cast<double>(reference.variance[i]) / 9.87;  // of E / pi
      sum += base::luminance(traced);
    }
    return difference / std::hypot(std::sqrt(variance), ownError * sum);
  }

  std::shared_ptr<const volume::PreparedVolume> volume_;
  scene::Scene scene_;
  render::FrameReport report_;
};

// White under a white sky: neither the lobe nor the diffuse part loses light.
TEST_F(GlossGlTest, TheFurnaceIsWhite) {
  for (const char* roughness : {"0.05", "0.3", "1"}) {
    SCOPED_TRACE(roughness);
    use("phantom:ball:32",
        {"isosurface.albedo=1,1,1", "isosurface.specular=0.4",
         std::string("isosurface.roughness=") + roughness, "light.environment.constant=1,1,1"});
    const render::LinearImage picture = drawn();
    const gi::ReferenceImage reference = traced(8);
    int surface = 0;
    for (std::size_t i = 0; i < reference.hit.size(); ++i) {
      if (reference.hit[i] == 0) continue;
      ++surface;
      EXPECT_NEAR(reference.color[i].x, 1.0f, 1e-5f);
      EXPECT_NEAR(picture.rgba[4 * i], 1.0f, 4e-3f);
    }
    EXPECT_GT(surface, 1000);
  }
}

TEST_F(GlossGlTest, TheMeanIsThatOfTheReference) {
  for (const char* source : {"phantom:torus:48", "phantom:gyroid:48"})
    for (const char* roughness : {"0.15", "0.4"}) {
      SCOPED_TRACE(std::string(source) + " " + roughness);
      use(source, {"isosurface.specular=0.4", std::string("isosurface.roughness=") + roughness});
      EXPECT_LT(std::abs(apart(drawn(2), traced(64), 0.01)), 4.5);
    }
}

TEST_F(GlossGlTest, LampsShineByTheirExtent) {
  for (const char* lamp : {"lamp1.kind=point", "lamp1.kind=sphere", "lamp1.kind=directional"}) {
    SCOPED_TRACE(lamp);
    use("phantom:torus:48", {"isosurface.specular=0.5", "isosurface.roughness=0.3", "lamp1.shown=true", lamp,
                             "lamp1.angle=10", "light.environment.constant=0.02,0.02,0.02"});
    EXPECT_LT(std::abs(apart(drawn(), traced(64), 0.015)), 4.5);
  }
}

TEST_F(GlossGlTest, MattSurfacesAskForNothing) {
  use("phantom:torus:32", {});
  drawn();
  EXPECT_FALSE(ran("reflections"));
  use("phantom:torus:32", {"isosurface.specular=0.05"});
  drawn();
  EXPECT_TRUE(ran("reflections"));
}

TEST_F(GlossGlTest, FramesReportWhatTheyReflect) {
  const auto reported = [&](const char* specular) {
    use("phantom:gyroid:48", {std::string("isosurface.specular=") + specular});
    drawn();
    return renderer_->hitVoxels().outer.size();
  };
  const std::size_t matt = reported("0");
  EXPECT_GT(reported("0.3"), matt + 50);
  EXPECT_EQ(reported("0"), matt);
}

// A picture that is drawn again asks for no light that is not there: reopened, it is the same.
TEST_F(GlossGlTest, ReflectedPointsAreLit) {
  use("phantom:gyroid:48", {"isosurface.specular=0.4", "isosurface.roughness=0.2", "gi.samples=16"});
  render::FrameRequest request;
  request.size = {96, 96};
  request.supersampling = 2;
  app::LightController controller{{}};
  base::Progress progress;
  app::lightPicture(controller, *renderer_, scene_, request, volume_, progress);
  const std::uint64_t lit = controller.state().counters.texelsLit;
  renderer_->render(scene_, request);
  controller.setVisible(renderer_->hitVoxels());
  ASSERT_TRUE(controller.finish(progress));
  EXPECT_EQ(controller.state().counters.texelsLit, lit);
  scene_.surfaces.front().specular = 0.0;
  app::LightController matt{{}};
  app::lightPicture(matt, *renderer_, scene_, request, volume_, progress);
  EXPECT_LT(matt.state().counters.texelsLit, lit);
}

}  // namespace
}  // namespace isolux::test
