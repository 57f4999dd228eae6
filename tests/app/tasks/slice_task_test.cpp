// Slices drawn on a thread: what they show, drafts, and owners that do not wait for their end.
#include "app/tasks/slice_task.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "app/slices/slice_draft.h"
#include "scene/rules/automatic.h"
#include "tests/support/own_waits.h"
#include "tests/support/poll.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

using Prepared = std::shared_ptr<const volume::PreparedVolume>;

app::SliceOrder orderOf(const Prepared& volume, glm::ivec2 size, double slabMm = 0.0) {
  scene::Scene scene;
  scene.slice.slab = slabMm;
  const auto& geometry = volume->grid().geometry();
  const auto frame =
      volume::sliceFrame(volume::SliceDirection::axial, volume->volume.axes, scene.slice.convention);
  return app::sliceOrder(volume, volume::fittedSlice(geometry, frame, glm::dvec3(0.0), size),
                         scene::resolve(scene, volume->facts));
}

double meanDifference(const render::ColorImage& a, const render::ColorImage& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += std::abs(a.rgba[i] - b.rgba[i]);
  return sum / static_cast<double>(a.rgba.size());
}

TEST(SliceJob, DrawsWhatWasOrdered) {
  const auto task = app::sliceTask(orderOf(phantom("ball", 32), {200, 170}));
  ASSERT_TRUE(pollUntil([&] { return task->finished(); }));
  ASSERT_FALSE(task->error()) << task->error()->what();
  EXPECT_EQ(task->value().picture.size, glm::ivec2(200, 170));
  EXPECT_GE(task->value().milliseconds, 0.0);
}

// A draft is the same picture but for its fineness, in size and place.
TEST(SliceJob, ADraftLooksLikeTheFullPicture) {
  app::SliceOrder order = orderOf(phantom("ball", 32), {203, 178});
  const auto full = app::sliceTask(order);
  order.coarse = 3;
  const auto draft = app::sliceTask(order);
  order.plane.originMm += 20.0 * order.plane.rightMm;
  const auto moved = app::sliceTask(order);
  ASSERT_TRUE(pollUntil([&] { return full->finished() && draft->finished() && moved->finished(); }));
  ASSERT_EQ(draft->value().picture.size, full->value().picture.size);
  const double same = meanDifference(full->value().picture, draft->value().picture);
  EXPECT_LT(same, 4.0);
  EXPECT_GT(meanDifference(full->value().picture, moved->value().picture), 3.0 * same);
}

TEST(SliceDraft, AColourThatChangesEvenlyStaysSo) {
  const int coarse = 4;
  const glm::ivec2 size(18, 9);
  volume::SlicePlane plane;
  plane.size = size;
  const volume::SlicePlane fewer = app::coarsened(plane, coarse);
  EXPECT_EQ(fewer.size, glm::ivec2(5, 3));
  render::ColorImage ramp{fewer.size, {}};
  for (int y = 0; y < fewer.size.y; ++y)
    for (int x = 0; x < fewer.size.x; ++x) {
      const double value = 10.0 * fewer.at({x, y}).x;  // 10 a pixel
      for (int i = 0; i < 4; ++i) ramp.rgba.push_back(static_cast<std::uint8_t>(value));
    }
  const render::ColorImage large = app::enlarged(ramp, coarse, size);
  ASSERT_EQ(large.size, size);
  for (int y = 0; y < size.y; ++y)
    for (int x = 2; x < 16; ++x) EXPECT_NEAR(large.rgba[4 * (y * size.x + x)], 10.0 * x, 1.0) << x;
}

// A thick slab of a large picture takes long; who throws it away does not wait, and the volume stays until
// the thread has ended.
TEST(SliceJob, ThrownAwayEndsByItself) {
  long fewest = std::numeric_limits<long>::max();
  for (int i = 0; i < 3; ++i) {
    auto volume = phantom("ball", 64);
    const std::weak_ptr<const volume::PreparedVolume> watched = volume;
    auto task = app::sliceTask(orderOf(volume, {4000, 4000}, 60.0));
    volume.reset();
    const bool works = !task->finished();
    const long waits = ownWaits([&] { task.reset(); });
    if (works) fewest = std::min(fewest, waits);
    EXPECT_TRUE(pollUntil([&] { return watched.expired(); }));
  }
  EXPECT_EQ(fewest, 0);
}

// Ends the process: 0 where the picture is there.
[[noreturn]] void drawWithoutThreads() {
  const app::SliceOrder order = orderOf(phantom("ball", 16), {64, 64});
  const rlimit one{1, 1};
  if (::setrlimit(RLIMIT_NPROC, &one) != 0 || ::setuid(61234) != 0) std::_Exit(7);
  const auto task = app::sliceTask(order);
  std::_Exit(task->finished() && !task->error() && task->value().picture.size.x == 64 ? 0 : 8);
}

// Where the system gives no thread the picture is drawn all the same.
TEST(SliceJobDeathTest, ARefusedThreadIsNoCrash) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can become a user whose threads are counted alone";
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(drawWithoutThreads(), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace isolux::test
