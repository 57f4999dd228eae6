// app/surface_list/surface_list.h: adding, removing and showing isosurfaces.
#include "app/surface_list/surface_list.h"

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"

namespace isolux::test {

namespace {

std::vector<app::ListedSurface> listOf(const scene::Scene& scene, const volume::PreparedVolume& volume) {
  return app::listedSurfaces(scene, scene::resolve(scene, volume.facts), &volume);
}

class SurfaceList : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    scene::Source source;
    source.path = "phantom:head:32";
    base::Progress progress;
    head_ = volume::loadVolume(source, progress);
  }
  static void TearDownTestSuite() { head_.reset(); }
  static std::shared_ptr<const volume::PreparedVolume> head_;  // in HU
};
std::shared_ptr<const volume::PreparedVolume> SurfaceList::head_;

}  // namespace

// From bone: one gesture adds the skin around it, and both are seen.
TEST_F(SurfaceList, WhatIsAddedOutsideIsSeenThrough) {
  scene::Scene scene;
  scene.surfaces.front().value = 300.0;
  const auto added = app::withSurface(scene, *head_, {});
  ASSERT_TRUE(added);
  const auto list = listOf(*added, *head_);
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[1].value, -300.0);
  EXPECT_EQ(list[1].name, "Skin");
  EXPECT_EQ(list[1].facingOpacity, app::kSeeThrough);
  EXPECT_EQ(list[1].opacity, 1.0);
  EXPECT_EQ(list[0].facingOpacity, 1.0);
}

// From skin there is nothing outside: bone comes inside, and the skin in front of it is seen through.
TEST_F(SurfaceList, WhatIsAddedInsideMakesTheFirstSeenThrough) {
  scene::Scene skin;
  skin.surfaces.front().value = -300.0;
  const auto added = app::withSurface(skin, *head_, {});
  ASSERT_TRUE(added);
  const auto list = listOf(*added, *head_);
  EXPECT_EQ(list[0].value, -300.0);
  EXPECT_EQ(list[0].facingOpacity, app::kSeeThrough);
  EXPECT_EQ(list[1].value, 300.0);
  EXPECT_EQ(list[1].facingOpacity, 1.0);
  // Alone again it is opaque, whether the other is hidden or removed.
  EXPECT_EQ(app::withSurfaceShown(*added, *head_, 1, false).surfaces.front().facingOpacity, 1.0);
  EXPECT_EQ(app::withoutSurface(*added, *head_, 1), skin);
}

TEST_F(SurfaceList, HiddenOnesStayInTheListAndTheFirstIsReplacedByTheNext) {
  scene::Scene scene;
  scene.surfaces.front().value = -300.0;
  scene = app::withSurface(scene, *head_, 120.0).value();
  scene = app::withSurfaceShown(scene, *head_, 1, false);
  ASSERT_EQ(listOf(scene, *head_).size(), 2u);
  EXPECT_FALSE(listOf(scene, *head_)[1].shown);
  scene = app::withSurfaceShown(scene, *head_, 1, true);
  scene = app::withoutSurface(scene, *head_, 0);
  ASSERT_EQ(listOf(scene, *head_).size(), 1u);
  EXPECT_EQ(listOf(scene, *head_)[0].value, 120.0);
  EXPECT_EQ(listOf(scene, *head_)[0].name, "Soft tissue");
  EXPECT_EQ(app::withoutSurface(scene, *head_, 0), scene) << "the last one stays";
  scene = app::withSurfaceShown(scene, *head_, 0, false);
  EXPECT_FALSE(listOf(scene, *head_)[0].shown);
}

// What somebody chose himself is not touched.
TEST_F(SurfaceList, ChosenOpacitiesStay) {
  scene::Scene scene;
  scene.surfaces.front().value = -300.0;
  scene.surfaces.front().opacity = 0.4;
  EXPECT_EQ(app::withSurface(scene, *head_, {})->surfaces.front().facingOpacity, 1.0);
  scene.surfaces.front().opacity = 1.0;
  scene.surfaces.front().facingOpacity = 0.5;
  EXPECT_EQ(app::withSurface(scene, *head_, {})->surfaces.front().facingOpacity, 0.5);
}

TEST_F(SurfaceList, EndsWithTheMost) {
  scene::Scene scene;
  for (std::size_t i = 1; i < scene::kSurfaces; ++i)
    scene = app::withSurface(scene, *head_, 10.0 * static_cast<double>(i)).value();
  EXPECT_FALSE(app::withSurface(scene, *head_, 900.0));
  EXPECT_EQ(listOf(scene, *head_).size(), scene::kSurfaces);
}

}  // namespace isolux::test
