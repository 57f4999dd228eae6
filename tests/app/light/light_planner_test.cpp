// Plans of light: where texels are lit that a file holds.
#include "app/light/light_planner.h"

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"

namespace isolux::test {
namespace {

TEST(LightPlanner, TexelsAreThoseOfTheFileOfItsVolume) {
  scene::Source source;
  source.path = "phantom:ball:24";
  base::Progress progress;
  const app::VolumePointer volume = volume::loadVolume(source, progress),
                           another = volume::loadVolume(source, progress);
  scene::Scene scene;
  scene.look.mode = scene::LookMode::gi;
  // The key of what is planned; `file`: of whose file the planner is told before it hears of a volume.
  const auto keyOf = [&](scene::GiTexels texels, const app::VolumePointer& file) {
    app::LightPlanner planner(false);
    planner.setOnlyPlans();
    if (file) planner.setTexelsOfFile(scene::GiTexels::own, file);
    scene.gi.texels = texels;
    return planner.plan(scene::resolve(scene, volume->facts), volume, progress).sky->lattice()->key();
  };
  const std::string own = keyOf(scene::GiTexels::own, nullptr),
                    shown = keyOf(scene::GiTexels::shown, nullptr);
  ASSERT_NE(own, shown);
  EXPECT_EQ(keyOf(scene::GiTexels::automatic, nullptr), shown);
  EXPECT_EQ(keyOf(scene::GiTexels::automatic, volume), own);
  EXPECT_EQ(keyOf(scene::GiTexels::automatic, another), shown);
  EXPECT_EQ(keyOf(scene::GiTexels::shown, volume), shown);
}

}  // namespace
}  // namespace isolux::test
