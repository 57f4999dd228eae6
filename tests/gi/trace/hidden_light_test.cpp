// Light of isosurfaces with pieces that are not shown: that of a volume without them.
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "gi/light_key.h"
#include "gi/trace/lattice_estimator.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/hidden_balls.h"

namespace isolux::gi {
namespace {

std::shared_ptr<const LightScene> lightOf(const std::shared_ptr<const volume::PreparedVolume>& volume,
                                          const scene::Scene& scene, int bounces) {
  base::Progress progress;
  LightScene light = test::lightSceneOf(volume);
  light.tracer = lightTracerOf(scene, volume, progress);
  light.choice.onShown = true;
  light.bounces = bounces;
  test::setUnitSky(light);
  return std::make_shared<const LightScene>(std::move(light));
}

struct Lit {
  std::vector<glm::vec3> places;
  std::vector<double> sums;
};

Lit lit(const std::shared_ptr<const LightScene>& light, std::optional<float> isovalue) {
  const LatticeGeometry lattice = LatticeGeometry::make(light->volume->grid().dims(), 1.0, isovalue);
  const LatticeEstimator estimator(light, lattice, LightPart::sky);
  std::vector<glm::ivec3> texels;
  for (int z = 0; z < lattice.dims.z; z += 3)
    for (int y = 0; y < lattice.dims.y; ++y)
      for (int x = 0; x < lattice.dims.x; ++x) texels.emplace_back(x, y, z);
  std::vector<TexelPoint> all(texels.size());
  estimator.points(texels, all);
  std::vector<TexelPoint> points;
  std::vector<glm::ivec3> own;
  Lit result;
  for (std::size_t i = 0; i < texels.size(); ++i)
    if (all[i].normal != glm::vec3(0.0f)) {
      own.push_back(texels[i]);
      points.push_back(all[i]);
      result.places.push_back(all[i].voxel);
    }
  result.sums.resize(own.size() * static_cast<std::size_t>(estimator.content().components()));
  std::uint64_t rays = 0;
  EXPECT_TRUE(estimator.add(own, points, {0, 8}, result.sums, rays, {}));
  return result;
}

scene::Scene sceneOf(const std::vector<test::PieceBall>& balls) {
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  for (const test::PieceBall& ball : balls)
    if (!ball.shown) scene.pieces.hidden.push_back(ball.middle);
  return scene;
}

TEST(HiddenLight, OfTexelsIsThatOfAVolumeWithoutTheHiddenBalls) {
  const std::vector<test::PieceBall> balls = test::pieceBalls();
  const auto all = test::prepared(test::gridOfBalls(balls, true)),
             shown = test::prepared(test::gridOfBalls(balls, false));
  scene::Scene whole = sceneOf(balls);
  whole.pieces = {};
  for (const int bounces : {0, 2}) {
    const Lit seen = lit(lightOf(all, sceneOf(balls), bounces), 0.0f),
              expected = lit(lightOf(shown, whole, bounces), 0.0f),
              withAll = lit(lightOf(all, whole, bounces), 0.0f);
    EXPECT_EQ(seen.places, expected.places);
    EXPECT_EQ(seen.sums, expected.sums);
    EXPECT_GT(withAll.places.size(), seen.places.size());
    EXPECT_GT(seen.places.size(), 200u);
  }
}

TEST(HiddenLight, OfTexelsOnTheirOwnIsosurfacesKnowsNoPieces) {
  const std::vector<test::PieceBall> balls = test::pieceBalls();
  const auto all = test::prepared(test::gridOfBalls(balls, true));
  scene::Scene whole = sceneOf(balls);
  whole.pieces = {};
  EXPECT_EQ(lit(lightOf(all, sceneOf(balls), 0), {}).sums, lit(lightOf(all, whole, 0), {}).sums);
}

TEST(HiddenLight, KeysOfTheShownIsosurfaceTellWhatIsHidden) {
  const std::vector<test::PieceBall> balls = test::pieceBalls();
  const auto all = test::prepared(test::gridOfBalls(balls, true));
  scene::Scene whole = sceneOf(balls);
  whole.pieces = {};
  const auto key = [&](const scene::Scene& scene, bool onShown) {
    LightScene light = *lightOf(all, scene, 0);
    light.choice.onShown = onShown;
    return lightKey(scene, light, LightPart::lamps);
  };
  EXPECT_NE(key(sceneOf(balls), true), key(whole, true));
  EXPECT_EQ(key(whole, true).find("hidden"), std::string::npos);
  EXPECT_EQ(key(sceneOf(balls), false), key(whole, false));
}

}  // namespace
}  // namespace isolux::gi
