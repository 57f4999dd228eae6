// The clock of an animated flow, which the window and replay share.
#include "scene/rules/flow_clock.h"

#include <gtest/gtest.h>

namespace isolux::test {

namespace {
scene::Scene animated() {
  scene::Scene scene;
  scene.look.mode = scene::LookMode::flow;
  scene.flow.animate = true;
  scene.flow.time = 2.0;
  return scene;
}
}  // namespace

TEST(FlowClock, RunsOnlyWhereAnAnimatedFlowIsDrawn) {
  scene::Scene scene = animated();
  EXPECT_TRUE(scene::FlowClock(scene).runs());
  scene.look.mode = scene::LookMode::kappa1;
  EXPECT_FALSE(scene::FlowClock(scene).runs());
  scene.flow.strength = 0.5;
  EXPECT_TRUE(scene::FlowClock(scene).runs());
  scene.flow.animate = false;
  scene::FlowClock still(scene);
  EXPECT_FALSE(still.runs());
  still.advance(5.0);
  EXPECT_EQ(still.seconds(), 2.0);
}

TEST(FlowClock, GoesOnThroughOtherChangesAndStandsAtATimeThatIsSet) {
  scene::Scene scene = animated();
  scene::FlowClock clock(scene);
  clock.advance(0.5);
  scene.look.ambient = 0.7;
  clock.setScene(scene);
  clock.advance(0.25);
  EXPECT_EQ(clock.seconds(), 2.75);
  scene.flow.time = 10.0;  // the user moved it
  clock.setScene(scene);
  EXPECT_EQ(clock.seconds(), 10.0);
  clock.advance(1.0);
  scene.flow.animate = false;  // paused where it stands
  scene.flow.time = clock.seconds();
  clock.setScene(scene);
  clock.advance(1.0);
  EXPECT_EQ(clock.seconds(), 11.0);
}

TEST(FlowClock, StaysWithinTheRangeOfTheSetting) {
  scene::Scene scene = animated();
  scene.flow.time = 1e6;
  scene::FlowClock clock(scene);
  EXPECT_EQ(clock.seconds(), 1e6);
  clock.advance(3.0);
  EXPECT_EQ(clock.seconds(), 3.0);
}

}  // namespace isolux::test
