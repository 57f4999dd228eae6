#include "app/tasks/load_task.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/destroy_in_background.h"
#include "tests/support/own_waits.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"
#include "tests/support/zarr_folder.h"

namespace isolux::app {
namespace {

std::unique_ptr<LoadTask> finished(std::unique_ptr<LoadTask> task) {
  EXPECT_TRUE(test::pollUntil([&] { return task->finished(); }));
  return task;
}

scene::Source source(const std::string& path) {
  scene::Source result;
  result.path = path;
  return result;
}

TEST(LoadJob, DeliversTheVolume) {
  const auto task = finished(loadTask(source("phantom:ball:16")));
  ASSERT_FALSE(task->error());
  EXPECT_EQ(task->value().volume->grid().dims(), glm::ivec3(16));
  EXPECT_EQ(task->value().source.path, "phantom:ball:16");
}

TEST(LoadJob, DeliversTheErrorAsAValue) {
  const auto task = finished(loadTask(source((test::temporaryFolder() / "missing.nii").string())));
  ASSERT_TRUE(task->error());
  EXPECT_EQ(task->error()->kind(), base::ErrorKind::input);
}

// A file with a hole is opened rather than refused where that may be, and said to be so.
TEST(LoadJob, ReadsAroundDamageWhereItMay) {
  const std::filesystem::path folder = test::temporaryFolder() / "cut.zarr";
  test::writeZarr(folder, glm::ivec3(32), glm::ivec3(16), std::vector<std::uint8_t>(32 * 32 * 32, 7));
  test::cutChunk(folder, {1, 0, 1});
  const auto strict = finished(loadTask(source(folder.string())));
  ASSERT_TRUE(strict->error());
  EXPECT_EQ(strict->error()->kind(), base::ErrorKind::input);
  const auto around = finished(loadTask(source(folder.string()), {.aroundDamage = true}));
  ASSERT_FALSE(around->error()) << around->error()->what();
  EXPECT_TRUE(around->value().source.aroundDamage);
  EXPECT_EQ(around->value().volume->grid().missingCount(), 16u * 16u * 16u);
  // Nothing is changed that need not be.
  test::writeZarr(folder, glm::ivec3(32), glm::ivec3(16), std::vector<std::uint8_t>(32 * 32 * 32, 7));
  const auto mended = finished(loadTask(source(folder.string()), {.aroundDamage = true}));
  ASSERT_FALSE(mended->error());
  EXPECT_EQ(mended->value().source, source(folder.string()));
  const auto missing =
      finished(loadTask(source((folder / "nothing").string()), {.coarser = true, .aroundDamage = true}));
  ASSERT_TRUE(missing->error());
  EXPECT_EQ(missing->error()->kind(), base::ErrorKind::input);
}

TEST(LoadJob, StopsWhenAsked) {
  auto task = loadTask(source("phantom:head:512"));
  task->progress().requestStop();
  task = finished(std::move(task));
  ASSERT_TRUE(task->error());
  EXPECT_EQ(task->error()->kind(), base::ErrorKind::interrupted);
}

// The work, which StopsWhenAsked() shows to end then, is asked to stop.
TEST(LoadJob, ThrownAwayWhileItRunsItLeavesItsWorkUndone) {
  auto task = loadTask(source("phantom:head:512"));
  const std::stop_token stop = task->progress().token();
  ASSERT_TRUE(test::pollUntil([&] { return task->progress().fraction() > 0.0; }));
  EXPECT_FALSE(stop.stop_requested());
  task.reset();
  EXPECT_TRUE(stop.stop_requested());
  EXPECT_TRUE(base::awaitDestroyed(600.0));
}

// Who waited for its thread would give up the processor each time.
TEST(LoadJob, ThrowingItAwayWhileItRunsWaitsForNothing) {
  long fewest = std::numeric_limits<long>::max();
  for (int i = 0; i < 5; ++i) {
    auto task = loadTask(source("phantom:head:256"));
    const double until = 0.05 * i;  // at several moments of its work
    ASSERT_TRUE(test::pollUntil([&] { return task->progress().fraction() > until; }));
    const bool worked = !task->finished();
    const long waits = test::ownWaits([&] { task.reset(); });
    if (worked) fewest = std::min(fewest, waits);
  }
  EXPECT_EQ(fewest, 0);
  EXPECT_TRUE(base::awaitDestroyed(600.0)) << "they end all the same";
}

TEST(LoadJob, ItsVolumeIsFreedElsewhere) {
  auto task = finished(loadTask(source("phantom:ball:16")));
  const std::weak_ptr<const volume::PreparedVolume> volume = task->value().volume;
  const volume::PreparedVolume* const same = task->value().volume.get();
  task.reset();
  EXPECT_TRUE(base::awaitDestroyed(600.0));
  EXPECT_TRUE(volume.expired());
  EXPECT_NE(same, nullptr);
}

}  // namespace
}  // namespace isolux::app
