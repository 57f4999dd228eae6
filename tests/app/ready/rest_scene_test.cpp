// Hits of pictures at rest: when they are the spline's.
#include "app/ready/rest_scene.h"

#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/rules/automatic.h"

namespace isolux::app {
namespace {

using scene::Field;

struct Loaded {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;  // resolved
};

Loaded loaded(const char* phantom) {
  base::Progress progress;
  Loaded result;
  result.scene.source.path = phantom;
  result.volume = volume::loadVolume(result.scene.source, progress);
  result.scene = scene::resolve(result.scene, result.volume->facts);
  return result;
}

TEST(RestScene, WiresAreHitBySplinesAndATorusIsNot) {
  base::Progress progress;
  const Loaded wires = loaded("phantom:wires:96"), torus = loaded("phantom:torus:48");
  EXPECT_FALSE(restIsReady(wires.scene, *wires.volume)) << "nothing is measured";
  EXPECT_TRUE(atRestIfReady(wires.scene, *wires.volume) == wires.scene);
  scene::Scene expected = wires.scene;
  expected.hit.field = Field::cubic_interpolating;
  EXPECT_TRUE(atRest(wires.scene, *wires.volume, progress) == expected);
  EXPECT_TRUE(restIsReady(wires.scene, *wires.volume));
  EXPECT_TRUE(atRestIfReady(wires.scene, *wires.volume) == expected);

  EXPECT_TRUE(atRest(torus.scene, *torus.volume, progress) == torus.scene);
  EXPECT_TRUE(restIsReady(torus.scene, *torus.volume));
  EXPECT_FALSE(torus.volume->cubicFields->find(Field::cubic_interpolating)) << "nothing is made";
}

TEST(RestScene, AnotherIsovalueIsAnotherSurface) {
  base::Progress progress;
  Loaded wires = loaded("phantom:wires:96");
  atRest(wires.scene, *wires.volume, progress);
  wires.scene.surfaces.front().value = 510.0;
  EXPECT_FALSE(restIsReady(wires.scene, *wires.volume));
}

TEST(RestScene, ByNameNothingIsMeasured) {
  base::Progress progress;
  Loaded torus = loaded("phantom:torus:48");
  torus.scene.picture.restHits = scene::StillField::cubic_interpolating;
  EXPECT_FALSE(restIsReady(torus.scene, *torus.volume));
  EXPECT_EQ(atRest(torus.scene, *torus.volume, progress).hit.field, Field::cubic_interpolating);
  EXPECT_TRUE(restIsReady(torus.scene, *torus.volume));
  EXPECT_FALSE(torus.volume->stillHits->find(*torus.scene.surfaces.front().value));
}

TEST(RestScene, WhereHitsMayNotChangeAllIsReady) {
  base::Progress progress;
  Loaded wires = loaded("phantom:wires:64");
  wires.scene.picture.restHits = scene::StillField::same;
  EXPECT_TRUE(restIsReady(wires.scene, *wires.volume));
  EXPECT_TRUE(atRest(wires.scene, *wires.volume, progress) == wires.scene);
  wires.scene.picture.restHits = scene::StillField::automatic;
  wires.scene.look.mode = scene::LookMode::gi;
  EXPECT_TRUE(restIsReady(wires.scene, *wires.volume));
}

TEST(RestScene, Stops) {
  base::Progress progress;
  progress.requestStop();
  const Loaded wires = loaded("phantom:wires:64");
  EXPECT_THROW(atRest(wires.scene, *wires.volume, progress), base::Error);
}

}  // namespace
}  // namespace isolux::app
