#include "app/jobs/field_job.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>
#include <vector>

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
  scene.hit.field = scene.derivatives.field = scene::Field::cubic_interpolating;
  return scene;
}

TEST(FieldJob, MakesWhatASceneNeedsAndUntilThenOtherFieldsAreDrawn) {
  const auto volume = ball(24);
  const scene::Scene scene = interpolating(), before = withReadyFields(scene, *volume->cubicFields);
  EXPECT_EQ(before.hit.field, scene::Field::trilinear);
  EXPECT_EQ(before.derivatives.field, scene::Field::cubic);
  const FieldJob job(volume, scene);
  ASSERT_TRUE(test::pollUntil([&] { return job.finished(); }));
  EXPECT_FALSE(job.error());
  EXPECT_TRUE(job.isFor(scene));
  EXPECT_FALSE(job.isFor(before));
  EXPECT_TRUE(volume->cubicFields->readyFor(scene));
  EXPECT_TRUE(withReadyFields(scene, *volume->cubicFields) == scene);
}

TEST(FieldJob, EndsSoonWhenNobodyWantsItAnyMore) {
  const auto volume = ball(160);
  std::vector<double> seconds;
  for (int i = 0; i < 5; ++i) {
    auto job = std::make_unique<FieldJob>(volume, interpolating());
    std::this_thread::sleep_for(std::chrono::milliseconds(10 * i));  // ends at several moments of its work
    const auto start = std::chrono::steady_clock::now();
    job.reset();
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  EXPECT_LT(seconds[2], 0.1);
}

}  // namespace
}  // namespace isolux::app
