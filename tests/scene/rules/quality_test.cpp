#include "scene/rules/quality.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace isolux::scene {
namespace {

TEST(Quality, EachIsFinerThanTheOneBefore) {
  int rays = 0, paths = 0;
  for (const Quality& quality : qualities()) {
    const Scene scene = withQuality(Scene{}, quality);
    EXPECT_GT(scene.picture.supersampling, rays) << quality.name;
    EXPECT_GT(scene.gi.samples, paths) << quality.name;
    rays = scene.picture.supersampling;
    paths = scene.gi.samples;
  }
  EXPECT_EQ(withQuality(Scene{}, quality("screen")), Scene{});  // the defaults
}

TEST(Quality, PrintHasExactHits) {
  Scene scene;
  scene.hit.method = HitMethod::sampled;
  EXPECT_EQ(withQuality(scene, quality("print")).hit.method, HitMethod::exact);
}

TEST(Quality, AnUnknownNameIsRefused) {
  EXPECT_THROW(quality("poster"), base::Error);
}

}  // namespace
}  // namespace isolux::scene
