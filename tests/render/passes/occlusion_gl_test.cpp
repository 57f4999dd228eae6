// Light that what stands near keeps away, against formulas; that of tiles against that of the whole picture.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "scene/settings/settings.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

// Two planes that meet at this angle in x = 47.5, z = 4, open toward +z; outside is above.
std::shared_ptr<const volume::PreparedVolume> groove(double degrees) {
  const double slope = 1.0 / std::tan(glm::radians(degrees / 2.0));
  return prepared(gridOfVoxels(unitGeometry({96, 96, 96}), [&](glm::dvec3 v) {
    return (slope * std::abs(v.x - 47.5) - (v.z - 4.0)) / std::sqrt(1.0 + slope * slope);
  }));
}

class OcclusionGlTest : public RenderGlTest {
 protected:
  // Seen along -z with +y up, orthographic, 96 mm; light comes from all around alone, on white.
  scene::Scene sceneOf(const std::shared_ptr<const volume::PreparedVolume>& volume,
                       const std::vector<std::string>& settings = {}) {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    scene.camera.projection = scene::Projection::orthographic;
    const glm::dvec3 centre = 0.5 * (volume->facts.boundsMinMm + volume->facts.boundsMaxMm);
    scene.camera.target = centre;
    scene.camera.eye = centre + glm::dvec3(0.0, 0.0, 400.0);
    scene.camera.up = glm::dvec3(0.0, 1.0, 0.0);
    scene.camera.fov = glm::degrees(2.0 * std::atan(48.0 / 400.0));
    for (const char* setting :
         {"look.mode=lambert", "look.ambient=1", "look.ambient_variation=0", "isosurface.albedo=1,1,1"})
      scene::applyAssignment(scene, setting);
    for (const std::string& setting : settings) scene::applyAssignment(scene, setting);
    return scene::resolve(scene, volume->facts);
  }
  // How much light comes to each pixel, row 0 at the top; NaN beside the surface.
  std::vector<float> openness(const std::shared_ptr<const volume::PreparedVolume>& volume, int size,
                              const std::vector<std::string>& settings = {}) {
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = {size, size};
    request.aovs = {render::Aov::hit};
    renderer_->render(sceneOf(volume, settings), request);
    const render::LinearImage linear = renderer_->readLinear();
    const render::AovImage hit = renderer_->readAov(render::Aov::hit);
    std::vector<float> open(hit.values.size(), std::nanf(""));
    for (std::size_t i = 0; i < open.size(); ++i)
      if (hit.values[i] == 1.0f) open[i] = linear.rgba[4 * i];
    return open;
  }
};

// A point in a groove between two planes that meet at the angle a, as long and as high as one likes, is
// reached by the part (1 - cos a) / 2 of what comes from all around, weighted by the cosine, wherever it
// lies. A picture looks for what is near in a quarter of its height, 24 mm here, so that a point must lie
// near the middle of the groove.
TEST_F(OcclusionGlTest, AGrooveLetsInWhatItsAngleDoes) {
  constexpr int kSize = 768, kPerMm = kSize / 96;
  for (const double angle : {90.0, 120.0, 150.0}) {
    const std::vector<float> open =
        openness(groove(angle), kSize, {"look.occlusion_radius=1000", "derivatives.field=trilinear"});
    const double expected = (1.0 - std::cos(glm::radians(angle))) / 2.0;
    for (const int side : {-1, 1})
      for (int y = kSize / 2 - 8; y < kSize / 2 + 8; ++y)
        for (int away = kPerMm; away < kPerMm + 3; ++away) {
          const int x = kSize / 2 + side * away;
          ASSERT_NEAR(open[static_cast<std::size_t>(y * kSize + x)], expected, 0.06)
              << angle << " degrees at " << x << ", " << y;
        }
  }
}

// Nothing stands near a ball.
TEST_F(OcclusionGlTest, WhatIsConvexIsLeftAlone) {
  int compared = 0;
  for (const float found : openness(phantom("ball", 64), 96)) {
    if (std::isnan(found)) continue;
    EXPECT_GT(found, 0.97f);
    ++compared;
  }
  EXPECT_GT(compared, 1000);
}

TEST_F(OcclusionGlTest, TheKeyLightAloneHasNone) {
  const auto volume = groove(60.0);
  EXPECT_LT(openness(volume, 96)[48 * 96 + 45], 0.7f);
  for (const char* off : {"light.setup=key", "look.occlusion=0"})
    for (const float found : openness(volume, 96, {off}))
      EXPECT_TRUE(std::isnan(found) || found == 1.0f) << found;
}

// A tile does not see what keeps light away beyond it: a small picture of the whole is drawn before.
TEST_F(OcclusionGlTest, TilesHaveThatOfTheWholePicture) {
  constexpr int kSize = 96;
  const auto volume = groove(60.0);
  for (const char* opacity : {"isosurface.opacity=1", "isosurface.opacity=0.5"}) {
    const scene::Scene scene = sceneOf(volume, {opacity});
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = {kSize, kSize};
    renderer_->render(scene, request);
    const render::ColorImage whole = renderer_->readColor();
    request.beforeTiles = true;
    request.size = {kSize / 2, kSize / 2};
    renderer_->render(scene, request);
    request.beforeTiles = false;
    request.size = {kSize, kSize};
    double sum = 0.0, darker = 0.0;
    for (int quarter = 0; quarter < 4; ++quarter) {
      const glm::ivec2 corner = kSize / 2 * glm::ivec2(quarter % 2, quarter / 2);
      request.tile = render::Tile{corner, glm::ivec2(kSize / 2)};
      renderer_->render(scene, request);
      const render::ColorImage tile = renderer_->readColor();
      for (int y = 0; y < kSize / 2; ++y)
        for (int x = 0; x < kSize / 2; ++x) {
          const int row = kSize / 2 - corner.y + y;  // tiles count rows from below
          const auto of = static_cast<std::size_t>(4 * (row * kSize + corner.x + x));
          sum += std::abs(whole.rgba[of] - tile.rgba[static_cast<std::size_t>(4 * (y * kSize / 2 + x))]);
          darker = std::max(darker, 255.0 - whole.rgba[of]);
        }
    }
    EXPECT_GT(darker, 60.0);
    EXPECT_LT(sum / (kSize * kSize), 4.0) << opacity;
  }
}

}  // namespace
}  // namespace isolux::test
