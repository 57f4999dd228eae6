#include "app/jobs/load_job.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <memory>
#include <stop_token>
#include <vector>

#include <gtest/gtest.h>

#include "base/retire.h"
#include "tests/support/own_waits.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"
#include "tests/support/zarr_folder.h"

namespace isolux::app {
namespace {

void waitFor(const LoadJob& job) {
  ASSERT_TRUE(test::pollUntil([&] { return job.finished(); }));
}

scene::Source source(const std::string& path) {
  scene::Source result;
  result.path = path;
  return result;
}

TEST(LoadJob, DeliversTheVolume) {
  LoadJob job(source("phantom:ball:16"));
  waitFor(job);
  ASSERT_FALSE(job.error());
  ASSERT_TRUE(job.volume());
  EXPECT_EQ(job.volume()->grid().dims(), glm::ivec3(16));
  EXPECT_EQ(job.source().path, "phantom:ball:16");
}

TEST(LoadJob, DeliversTheErrorAsAValue) {
  LoadJob job(source((test::temporaryFolder() / "missing.nii").string()));
  waitFor(job);
  ASSERT_TRUE(job.error());
  EXPECT_EQ(job.error()->kind(), base::ErrorKind::input);
  EXPECT_FALSE(job.volume());
}

// A file with a hole is opened rather than refused where that may be, and said to be so.
TEST(LoadJob, ReadsAroundDamageWhereItMay) {
  const std::filesystem::path folder = test::temporaryFolder() / "cut.zarr";
  test::writeZarr(folder, glm::ivec3(32), glm::ivec3(16), std::vector<std::uint8_t>(32 * 32 * 32, 7));
  test::cutChunk(folder, {1, 0, 1});
  LoadJob strict(source(folder.string()));
  waitFor(strict);
  ASSERT_TRUE(strict.error());
  EXPECT_EQ(strict.error()->kind(), base::ErrorKind::input);
  LoadJob around(source(folder.string()), {.aroundDamage = true});
  waitFor(around);
  ASSERT_FALSE(around.error()) << around.error()->what();
  EXPECT_FALSE(around.source().aroundDamage);
  EXPECT_TRUE(around.loaded().aroundDamage);
  EXPECT_EQ(around.volume()->grid().missingCount(), 16u * 16u * 16u);
  // Nothing is changed that need not be.
  test::writeZarr(folder, glm::ivec3(32), glm::ivec3(16), std::vector<std::uint8_t>(32 * 32 * 32, 7));
  LoadJob mended(source(folder.string()), {.aroundDamage = true});
  waitFor(mended);
  ASSERT_TRUE(mended.volume());
  EXPECT_EQ(mended.loaded(), mended.source());
  LoadJob missing(source((folder / "nothing").string()), {.coarser = true, .aroundDamage = true});
  waitFor(missing);
  ASSERT_TRUE(missing.error());
  EXPECT_EQ(missing.loaded(), missing.source());
}

TEST(LoadJob, StopsWhenAsked) {
  LoadJob job(source("phantom:head:512"));
  job.progress().requestStop();
  waitFor(job);
  ASSERT_TRUE(job.error());
  EXPECT_EQ(job.error()->kind(), base::ErrorKind::interrupted);
}

// The work, which StopsWhenAsked() shows to end then, is asked to stop.
TEST(LoadJob, ThrownAwayWhileItRunsItLeavesItsWorkUndone) {
  auto job = std::make_unique<LoadJob>(source("phantom:head:512"));
  const std::stop_token stop = job->progress().token();
  ASSERT_TRUE(test::pollUntil([&] { return job->progress().fraction() > 0.0; }));
  EXPECT_FALSE(stop.stop_requested());
  job.reset();
  EXPECT_TRUE(stop.stop_requested());
  EXPECT_TRUE(base::awaitRetired(600.0));
}

// Who waited for its thread would give up the processor each time.
TEST(LoadJob, ThrowingItAwayWhileItRunsWaitsForNothing) {
  long fewest = std::numeric_limits<long>::max();
  for (int i = 0; i < 5; ++i) {
    auto job = std::make_unique<LoadJob>(source("phantom:head:256"));
    const double until = 0.05 * i;  // at several moments of its work
    ASSERT_TRUE(test::pollUntil([&] { return job->progress().fraction() > until; }));
    const bool worked = !job->finished();
    const long waits = test::ownWaits([&] { job.reset(); });
    if (worked) fewest = std::min(fewest, waits);
  }
  EXPECT_EQ(fewest, 0);
  EXPECT_TRUE(base::awaitRetired(600.0)) << "they end all the same";
}

TEST(LoadJob, ItsVolumeIsFreedElsewhere) {
  auto job = std::make_unique<LoadJob>(source("phantom:ball:16"));
  waitFor(*job);
  const std::weak_ptr<const volume::PreparedVolume> volume = job->volume();
  const volume::PreparedVolume* const same = job->volume().get();
  job.reset();
  EXPECT_TRUE(base::awaitRetired(600.0));
  EXPECT_TRUE(volume.expired());
  EXPECT_NE(same, nullptr);
}

}  // namespace
}  // namespace isolux::app
