// A second volume on the surface of the first: values at the hits of pictures, against a lookup of its own.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <glm/geometric.hpp>

#include "tests/render/gl_fixture.h"
#include "tests/support/analytic_fields.h"

namespace isolux::test {
namespace {

using render::Aov;

class SecondVolumeGlTest : public ExecutorsGlTest {};

// The second is a phantom on a grid of its own, which its closed form judges.
TEST_P(SecondVolumeGlTest, ValuesAreThoseOfItsOwnGeometry) {
  constexpr glm::ivec2 size{48, 40};
  for (const auto& geometry : {isotropicGeometry(24), obliqueLeftHandedGeometry(24)}) {
    const auto volume = phantom("ball", geometry);
    scene::Scene scene;
    scene.color.volume = "phantom:plane:40";
    base::Progress progress;
    const auto second = volume->secondVolumes->make(scene.color, progress);
    ASSERT_TRUE(second);
    const Images seen = images(volume, scene, size);
    const render::AovImage value = renderer_->readAov(Aov::color_value);
    const volume::Grid& grid = second->grid();
    const glm::dmat4 voxelFromWorld = grid.geometry().voxelFromWorld();
    int count = 0, outside = 0;
    for (std::size_t i = 0; i < seen.hit.values.size(); ++i) {
      if (seen.hit.values[i] != 1.0f) {
        EXPECT_TRUE(std::isnan(value.values[i]));
        continue;
      }
      const glm::dvec3 voxel(voxelFromWorld * glm::dvec4(at(seen.position, i), 1.0));
      const glm::dvec3 last(grid.dims() - 1);
      const double within =
          std::min({voxel.x, voxel.y, voxel.z, last.x - voxel.x, last.y - voxel.y, last.z - voxel.z});
      if (std::abs(within) < 1e-3) continue;
      if (within < 0.0) {
        ++outside;
        EXPECT_TRUE(std::isnan(value.values[i]));
        continue;
      }
      ++count;
      const glm::ivec3 low = glm::min(glm::ivec3(voxel), grid.dims() - 2);
      double sum = 0.0;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        double weight = 1.0;
        for (int axis = 0; axis < 3; ++axis)
          weight *= step[axis] ? voxel[axis] - low[axis] : 1.0 - (voxel[axis] - low[axis]);
        sum += weight * grid.value(low.x + step.x, low.y + step.y, low.z + step.z);
      }
      // Positions in images are floats.
      EXPECT_NEAR(value.values[i], sum, 2e-6 * (grid.maximum() - grid.minimum()) + 1e-4);
    }
    EXPECT_GT(count + outside, 200);
    EXPECT_GT(count, 20);
  }
}

TEST_P(SecondVolumeGlTest, WhereThereIsNoneTheSurfaceKeepsItsColour) {
  const auto volume = phantom("ball", 24);
  scene::Scene scene;
  scene = scene::resolve(scene, volume->facts);
  renderer_->setVolume(volume);
  render::FrameRequest request;
  request.size = {40, 40};
  renderer_->render(scene, request);
  const auto plain = renderer_->readColor().rgba;
  scene.color.volume = "phantom:plane:24";
  scene.look.legend = false;
  renderer_->render(scene, request);  // nobody has read it
  EXPECT_EQ(renderer_->readColor().rgba, plain);
  base::Progress progress;
  volume->secondVolumes->make(scene.color, progress);
  renderer_->render(scene, request);
  const auto colored = renderer_->readColor().rgba;
  EXPECT_NE(colored, plain);
  scene.color.isolines = 3.0;
  renderer_->render(scene, request);
  EXPECT_NE(renderer_->readColor().rgba, colored);
  scene.color.volume.clear();
  renderer_->render(scene, request);
  EXPECT_EQ(renderer_->readColor().rgba, plain);
}

ISOLUX_ON_BOTH_EXECUTORS(SecondVolumeGlTest);

}  // namespace
}  // namespace isolux::test
