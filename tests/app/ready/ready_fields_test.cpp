#include "app/ready/ready_fields.h"

#include <memory>

#include <gtest/gtest.h>

#include "tests/support/poll.h"
#include "volume/phantom/phantom.h"

namespace isolux::app {
namespace {

std::shared_ptr<const volume::PreparedVolume> ball(int size) {
  base::Progress progress;
  scene::Source source;
  source.path = "phantom:ball:" + std::to_string(size);
  return volume::loadVolume(source, progress);
}

scene::Scene interpolating() {
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.hit.field = scene.derivatives.field = scene::Field::cubic_interpolating;
  return scene;
}

TEST(FieldJob, MakesWhatASceneNeedsAndUntilThenOtherFieldsAreDrawn) {
  const auto volume = ball(24);
  const scene::Scene scene = interpolating(), before = withReadyFields(scene, *volume);
  EXPECT_EQ(before.hit.field, scene::Field::trilinear);
  EXPECT_EQ(before.derivatives.field, scene::Field::cubic);
  EXPECT_FALSE(fieldsAreReady(scene, *volume));
  const auto task = fieldTask(volume, scene);
  ASSERT_TRUE(test::pollUntil([&] { return task->finished(); }));
  EXPECT_FALSE(task->error());
  EXPECT_TRUE(needSameFields(scene, scene));
  EXPECT_FALSE(needSameFields(scene, before));
  EXPECT_TRUE(fieldsAreReady(scene, *volume));
  const scene::Scene after = withReadyFields(scene, *volume);
  EXPECT_EQ(after.hit.field, scene.hit.field);
  EXPECT_EQ(after.derivatives.field, scene.derivatives.field);
}

// Scales whose fields are not there yet are those of the picture before, or none.
TEST(FieldJob, ScalesAreThoseThatAreThere) {
  const auto volume = ball(24);
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.look.mode = scene::LookMode::kappa1;
  scene.derivatives = {.noise = 1.0, .scale = 3.0, .normalScale = 2.0};
  const auto scales = [&](const scene::Derivatives& last) {
    const scene::Derivatives ready = withReadyFields(scene, *volume, last).derivatives;
    return std::pair(*ready.scale, *ready.normalScale);
  };
  EXPECT_EQ(scales({}), std::pair(0.0, 0.0));
  {
    const auto task = fieldTask(volume, scene);
    ASSERT_TRUE(test::pollUntil([&] { return task->finished(); }));
  }
  EXPECT_TRUE(fieldsAreReady(scene, *volume));
  EXPECT_EQ(scales({}), std::pair(3.0, 2.0));
  const scene::Derivatives before = scene.derivatives;
  scene.derivatives.scale = 4.0;
  EXPECT_FALSE(fieldsAreReady(scene, *volume));
  EXPECT_EQ(scales({}), std::pair(0.0, 2.0));
  EXPECT_EQ(scales(before), std::pair(3.0, 2.0));
  scene.derivatives.scale = 0.0;  // is there always
  EXPECT_EQ(scales(before), std::pair(0.0, 2.0));
  scene.derivatives.scale = 4.0;
  scene.derivatives.field = scene::Field::cubic_interpolating;  // of which there is nothing
  EXPECT_EQ(withReadyFields(scene, *volume, before).derivatives.field, scene::Field::cubic);
  EXPECT_EQ(scales(before), std::pair(3.0, 2.0));
  EXPECT_EQ(scales({}), std::pair(0.0, 2.0));  // of the field that is drawn instead
  scene.look.mode = scene::LookMode::depth;    // reads none
  scene.derivatives.field = scene::Field::cubic;
  EXPECT_TRUE(fieldsAreReady(scene, *volume));
}

// What is automatic is chosen once for an isovalue, and shown when it is known.
TEST(FieldJob, ChoosesWhatIsAutomatic) {
  const auto volume = ball(24);
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  EXPECT_FALSE(fieldsAreReady(scene, *volume));
  const auto task = fieldTask(volume, scene);
  ASSERT_TRUE(test::pollUntil([&] { return task->finished(); }));
  EXPECT_TRUE(fieldsAreReady(scene, *volume));
  const auto choice =
      volume->derivativeChoices->find({.isovalue = 0.0, .field = scene.derivatives.field, .noise = {}});
  ASSERT_TRUE(choice);
  const scene::Derivatives drawn = withReadyFields(scene, *volume).derivatives;
  EXPECT_EQ(drawn.normalScale, choice->normalScaleMm);
  EXPECT_EQ(drawn.noise, choice->noise);
  scene::Scene other = scene;
  other.surfaces.front().value = 1.0;
  EXPECT_FALSE(fieldsAreReady(other, *volume));
  EXPECT_FALSE(needSameFields(scene, other));
}

// Its end is waited for: what it was to make is not made then.
TEST(FieldJob, LeavesItsWorkUndoneWhenNobodyWantsItAnyMore) {
  const scene::Scene scene = interpolating();
  int undone = 0;
  for (int i = 0; i < 5; ++i) {
    const auto volume = ball(160);
    auto task = fieldTask(volume, scene);
    const double until = 0.05 * (i + 1);  // ends at several moments of its work
    ASSERT_TRUE(test::pollUntil([&] { return task->finished() || task->progress().fraction() >= until; }));
    task.reset();
    undone += !fieldsAreReady(scene, *volume);
  }
  EXPECT_GT(undone, 0);  // on a busy machine some may have ended before
}

}  // namespace
}  // namespace isolux::app
