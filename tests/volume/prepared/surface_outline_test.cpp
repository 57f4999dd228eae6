#include "volume/prepared/surface_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "scene/rules/automatic.h"
#include "tests/support/volumes.h"
#include "volume/prepared/surface_reach.h"

namespace isolux::volume {
namespace {

// Value = radius less distance from a ball, voxels; beside it a voxel that is as far inside as the middle.
std::shared_ptr<const PreparedVolume> ballAndSpeck(bool withSpeck) {
  Volume made;
  made.grid =
      std::make_shared<Grid>(test::gridOfVoxels(test::unitGeometry(glm::ivec3(80)), [&](glm::dvec3 p) {
        if (withSpeck && glm::length(p - glm::dvec3(74)) < 1.0) return 20.0;
        return 20.0 - glm::length(p - glm::dvec3(30, 34, 28));
      }));
  base::Progress progress;
  return prepareVolume(std::move(made), progress);
}

scene::Scene at(double isovalue, const PreparedVolume& volume) {
  scene::Scene scene;
  scene.surfaces.front().value = isovalue;
  return scene::resolve(scene, volume.facts);
}

glm::dvec3 someDirection(std::uint64_t i) {
  glm::dvec3 d(0.0);
  for (int axis = 0; axis < 3; ++axis)
    d[axis] = base::normalNoise(3, 3 * i + static_cast<std::uint64_t>(axis));
  return glm::normalize(d);
}

TEST(SurfaceOutline, ReachesAsFarAsTheSurface) {
  const auto volume = ballAndSpeck(false);
  const scene::Scene scene = at(0.0, *volume);
  base::Progress progress;
  const SurfaceOutline outline = surfaceOutline(*volume, scene, true, progress);
  std::vector<glm::dvec3> directions;
  for (std::uint64_t i = 0; i < 200; ++i) directions.push_back(someDirection(i));
  const auto reach = surfaceReach(*volume, scene, directions, progress);
  ASSERT_TRUE(reach);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    double farthest = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3& point : outline.pointsMm)
      farthest = std::max(farthest, glm::dot(point, directions[i]));
    EXPECT_LE(farthest, (*reach)[i] + 1e-9);
    EXPECT_GE(farthest, (*reach)[i] - 0.02 * 40.0);
  }
  EXPECT_GT(outline.samples.size(), 1000u);
  for (const OutlineSample& sample : outline.samples) {
    const glm::dvec3 out = glm::normalize(sample.positionMm - glm::dvec3(30, 34, 28));
    EXPECT_GT(glm::dot(out, sample.normal), 0.99);
  }
}

TEST(SurfaceOutline, LeavesSpecksOutAndIsTheSameAlways) {
  const auto clean = ballAndSpeck(false), specked = ballAndSpeck(true);
  base::Progress progress;
  const auto outline = surfaceOutline(*specked, at(0.0, *specked), false, progress).pointsMm;
  EXPECT_EQ(outline, surfaceOutline(*clean, at(0.0, *clean), false, progress).pointsMm);
  for (int again = 0; again < 3; ++again)
    EXPECT_EQ(outline, surfaceOutline(*specked, at(0.0, *specked), false, progress).pointsMm);
  EXPECT_TRUE(surfaceOutline(*clean, at(100.0, *clean), true, progress).pointsMm.empty()) << "no surface";
}

TEST(SurfaceOutline, IsOfWhatCutsLeave) {
  const auto volume = ballAndSpeck(false);
  scene::Scene scene = at(0.0, *volume);
  scene.clip.planes = {{glm::dvec3(30, 34, 28), glm::dvec3(1, 0, 0)}};
  base::Progress progress;
  double farthest = -1e9;
  for (const glm::dvec3& point : surfaceOutline(*volume, scene, false, progress).pointsMm)
    farthest = std::max(farthest, point.x);
  EXPECT_NEAR(farthest, 30.0, 1.0);
  EXPECT_LE(farthest, 30.0 + 1e-9);
}

}  // namespace
}  // namespace isolux::volume
