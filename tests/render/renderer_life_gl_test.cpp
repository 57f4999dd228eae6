// The renderer through its life: volumes exchanged for equal ones, errors survived.
#include <algorithm>
#include <limits>
#include <map>

#include <glm/common.hpp>

#include "base/error.h"
#include "render/gl/gl.h"
#include "scene/settings/settings.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

class RendererLifeGlTest : public RenderGlTest {
 protected:
  using Settings = std::vector<std::string>;

  render::ColorImage picture(const std::shared_ptr<const volume::PreparedVolume>& volume,
                             const Settings& settings = {}) {
    render::FrameRequest request;
    request.size = {96, 80};
    const scene::Scene scene = assigned(settings);
    renderer_->setVolume(volume);
    report_ = renderer_->render(scene::resolve(scene, volume->facts), request);
    return renderer_->readColor();
  }
};

TEST_F(RendererLifeGlTest, AnEqualVolumeShowsTheSamePictureAgain) {
  for (const Settings& settings :
       {Settings{}, Settings{"memory.layout=bricks"}, Settings{"hit.field=cubic"},
        Settings{"look.mode=mean_curvature"}, Settings{"isosurface.opacity=0.5", "look.shadow=1"}}) {
    const auto first = phantom("ball", 48), second = phantom("ball", 48);
    ASSERT_NE(first, second);
    const render::ColorImage before = picture(first, settings);
    ASSERT_GT(report_.blocksActive, 0u);
    const std::size_t blocks = report_.blocksActive;
    for (const auto& volume : {second, first, first}) {
      const render::ColorImage after = picture(volume, settings);
      EXPECT_EQ(report_.blocksActive, blocks);
      EXPECT_EQ(after.rgba, before.rgba) << (settings.empty() ? "" : settings[0]);
      // Another view is drawn from the new copy, whatever of the picture was kept.
      EXPECT_NE(picture(volume, {"camera.fov=20"}).rgba, before.rgba);
      EXPECT_EQ(picture(volume, settings).rgba, before.rgba);
    }
  }
}

// Derivatives are read from bricks at the hits: a new cache has none of them.
TEST_F(RendererLifeGlTest, AnEqualVolumeInBricksHasItsDerivativesToo) {
  const auto first = phantom("ball", 48), second = phantom("ball", 48);
  const Settings lambert = {"memory.layout=bricks", "look.mode=lambert"};
  const Settings curvature = {"memory.layout=bricks", "look.mode=curvature_2d"};
  const render::ColorImage expected = picture(first, curvature);
  renderer_ = std::make_unique<render::Renderer>(context_->gl());
  picture(first, lambert);
  EXPECT_EQ(picture(second, curvature).rgba, expected.rgba);
}

// More points than are told, in front and behind: none of the picture is left out for it.
TEST_F(RendererLifeGlTest, PointsToldOfALargePictureAreSpreadEvenly) {
  const auto volume = phantom("ball", 24);
  scene::Scene scene;
  scene.look.mode = scene::LookMode::gi;
  scene.surfaces.front().opacity = 0.5;
  scene.camera.projection = scene::Projection::orthographic;
  const glm::dvec3 centre = 0.5 * (volume->facts.boundsMinMm + volume->facts.boundsMaxMm);
  scene.camera.target = centre;
  scene.camera.eye = centre - glm::dvec3(0.0, 400.0, 0.0);
  scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
  scene.camera.fov = 1.0;  // the ball fills the picture
  scene = scene::resolve(scene, volume->facts);
  renderer_->setVolume(volume);
  render::FrameRequest request;
  request.size = {1088, 1040};
  renderer_->render(scene, request);
  const gi::VisiblePointSet seen = renderer_->hitVoxels();
  std::vector<glm::vec3> hits = seen.outer;
  hits.insert(hits.end(), seen.inner.begin(), seen.inner.end());
  EXPECT_GT(hits.size(), 300000u);
  EXPECT_LE(hits.size(), 2u << 20);
  // Each of 4 x 4 parts of the picture (the view is along y) has its share in front and behind.
  glm::vec3 low(1e9f), high(-1e9f);
  for (const glm::vec3& hit : hits) {
    low = glm::min(low, hit);
    high = glm::max(high, hit);
  }
  std::map<int, int> front, behind;
  for (const glm::vec3& hit : hits) {
    const glm::ivec3 part = glm::min(glm::ivec3(4.0f * (hit - low) / (high - low)), glm::ivec3(3));
    ++(hit.y < 0.5f * (low.y + high.y) ? front : behind)[4 * part.z + part.x];
  }
  for (const auto* side : {&front, &behind}) {
    ASSERT_EQ(side->size(), 16u);
    int least = std::numeric_limits<int>::max(), most = 0;
    for (const auto& [part, count] : *side) {
      least = std::min(least, count);
      most = std::max(most, count);
    }
    EXPECT_GT(least, 0.9 * most);
  }
}

TEST_F(RendererLifeGlTest, AFrameThatFailsLeavesTheNextAsItWas) {
  const auto volume = phantom("ball", 96);
  const Settings transparent = {"isosurface.opacity=0.5", "look.mode=curvature_2d"};
  const render::ColorImage before = picture(volume, transparent);
  Settings tooMuch = transparent;
  tooMuch.insert(tooMuch.end(), {"picture.executor=gpu", "memory.layout=whole", "memory.gpu_budget_mb=16",
                                 "hit.field=cubic_interpolating"});
  EXPECT_NO_THROW(picture(volume, transparent));
  EXPECT_THROW(picture(phantom("ball", 180), tooMuch), base::Error);
  EXPECT_EQ(picture(volume, transparent).rgba, before.rgba);
}

// In every test of this fixture: what the driver calls an error is told, with the frame and to the test.
TEST_F(RendererLifeGlTest, ErrorsOfTheDriverAreSeen) {
  const render::Gl& gl = *context_->gl();
  EXPECT_TRUE(render::glErrors().empty());
  gl.Enable(GL_TEXTURE_3D);  // no such switch in a core profile
  ASSERT_EQ(render::glErrorCount(), 1u);
  EXPECT_NE(render::glErrors()[0].find("GL_INVALID_ENUM"), std::string::npos) << render::glErrors()[0];
  picture(phantom("ball", 16));
  EXPECT_TRUE(report_.glErrors.empty());  // it was not of this frame
  render::forgetGlErrors();
}

}  // namespace
}  // namespace isolux::test
