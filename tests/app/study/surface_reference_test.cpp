#include "app/study/surface_reference.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "scene/rules/automatic.h"
#include "tests/support/volumes.h"

namespace isolux::app {
namespace {

// A noisy ball: at a scale its curvature is seen, at scale 0 only the noise's; normals follow a scale of
// their own.
TEST(SurfaceReference, CurvatureAndNormalsHaveTheScalesOfTheScene) {
  const auto volume = test::prepared(test::withNoise(test::phantomGrid("ball", 48), 0.4, glm::dvec3(0.0), 2));
  scene::Scene scene;
  scene.derivatives.noise = 0.0;  // all curvature counts
  scene.surfaces.front().value = 0.0;
  scene = scene::resolve(scene, volume->facts);
  SurfaceReference reference(volume, scene, {24, 24});
  base::Progress progress;
  const auto shapesAt = [&](std::optional<double> scale, std::optional<double> normalScale) {
    scene::Derivatives derivatives;
    derivatives.field = scene::Field::cubic;
    derivatives.scale = scale;
    derivatives.normalScale = normalScale;
    return reference.of(scene::Field::trilinear, derivatives, progress);
  };
  const TrueSurface plain = shapesAt({}, {}), zero = shapesAt(0.0, 0.0), both = shapesAt(3.0, 3.0),
                    curved = shapesAt(3.0, 0.0);
  const double kappa = 1.0 / (0.35 * 47.0);
  double plainOff = 0.0, scaledOff = 0.0;
  int hits = 0;
  for (std::size_t i = 0; i < plain.hits.size(); ++i) {
    if (!plain.hits[i].hit) continue;
    ++hits;
    plainOff += std::pow(plain.shapes[i].kappa1 - kappa, 2);
    scaledOff += std::pow(curved.shapes[i].kappa1 - kappa, 2);
    EXPECT_EQ(zero.shapes[i].kappa1, plain.shapes[i].kappa1);
    EXPECT_EQ(zero.shapes[i].normal, plain.shapes[i].normal);
    EXPECT_EQ(curved.shapes[i].normal, plain.shapes[i].normal);
    EXPECT_EQ(curved.shapes[i].kappa1, both.shapes[i].kappa1);
    const glm::dvec3 outward = glm::normalize(plain.hits[i].voxel - 23.5);
    EXPECT_LT(glm::distance(both.shapes[i].normal, outward), 0.12);
  }
  EXPECT_GT(hits, 100);
  EXPECT_LT(std::sqrt(scaledOff / hits), 0.3 * kappa);
  EXPECT_GT(plainOff, 25.0 * scaledOff);
}

}  // namespace
}  // namespace isolux::app
