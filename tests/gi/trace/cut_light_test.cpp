// Stored light of a ball whose lid is cut off: the closed forms of tests/support/cut_ball.h, texel by texel.
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "gi/trace/lattice_estimator.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/cut_ball.h"

namespace isolux::gi {
namespace {

struct LitTexels {
  std::vector<glm::dvec3> places;
  std::vector<double> irradiance;
};

// A hollow in a solid: the sphere's inside, cut open by a plane where CutBall ends.
LitTexels litCutBall(const test::CutBall& ball, int bounces, bool cut, std::uint32_t samples) {
  const auto volume = test::prepared(test::gridOfWorld(test::unitGeometry(glm::ivec3(37)), [&](glm::dvec3 p) {
    return glm::length(p - ball.middle) - ball.radius;
  }));
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  if (cut) scene.clip.planes = {{{0.0, 0.0, ball.dims.z - 1.0}, {0.0, 0.0, 1.0}}};
  base::Progress progress;
  LightScene light = test::lightSceneOf(volume, scene::Inside::above, glm::dvec3(0.6));
  light.tracer = lightTracerOf(scene, volume, progress);
  light.choice.onShown = true;
  light.bounces = bounces;
  test::setUnitSky(light);
  const LatticeGeometry lattice = LatticeGeometry::make(volume->grid().dims(), 1.0, 0.0f);
  const LatticeEstimator estimator(std::make_shared<const LightScene>(std::move(light)), lattice,
                                   LightPart::sky);
  std::vector<glm::ivec3> texels;
  for (int z = 0; z < lattice.dims.z; ++z)
    for (int y = 0; y < lattice.dims.y; y += 2)
      for (int x = 0; x < lattice.dims.x; x += 2) texels.emplace_back(x, y, z);
  std::vector<TexelPoint> all(texels.size()), points;
  estimator.points(texels, all);
  std::vector<glm::ivec3> own;
  LitTexels lit;
  for (std::size_t i = 0; i < texels.size(); ++i)
    if (all[i].normal != glm::vec3(0.0f)) {
      own.push_back(texels[i]);
      points.push_back(all[i]);
      lit.places.emplace_back(all[i].voxel);  // voxels of 1 mm at the world's origin
    }
  const auto components = static_cast<std::size_t>(estimator.content().components());
  std::vector<double> sums(own.size() * components);
  std::uint64_t rays = 0;
  EXPECT_TRUE(estimator.add(own, points, {0, samples}, sums, rays, {}));
  for (std::size_t i = 0; i < own.size(); ++i) lit.irradiance.push_back(sums[i * components] / samples);
  return lit;
}

// What lies below the cut: the mean is the closed form, and no texel is far from it. Closed, nothing is lit.
TEST(CutLight, IsThatOfTheOpenedBall) {
  const test::CutBall ball;
  const double rim = ball.dims.z - 2.0;  // texels beside the cut have rays that begin beyond it
  for (const int bounces : {0, 2}) {
    const LitTexels lit = litCutBall(ball, bounces, true, 256);
    const double expected = ball.innerIrradiance(0.6, bounces);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < lit.places.size(); ++i) {
      if (lit.places[i].z > rim) continue;
      EXPECT_NEAR(lit.irradiance[i], expected, 0.6) << lit.places[i].z;
      sum += lit.irradiance[i];
      ++count;
    }
    ASSERT_GT(count, 150);
    EXPECT_NEAR(sum / count / expected, 1.0, 0.02) << bounces;
  }
  const LitTexels dark = litCutBall(ball, 0, false, 16);
  for (const double irradiance : dark.irradiance) ASSERT_EQ(irradiance, 0.0);
}

}  // namespace
}  // namespace isolux::gi
