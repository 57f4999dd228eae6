// Marks measured on a thread: all of them, the quick ones first, and stopped soon.
#include "app/marks/mark_evaluator.h"

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"
#include "tests/support/poll.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

using scene::Mark;
using scene::MarkKind;

std::shared_ptr<app::MarkEvaluator> evaluatorOf(const std::shared_ptr<const volume::PreparedVolume>& volume) {
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  return std::make_shared<app::MarkEvaluator>(volume, scene::resolve(scene, volume->facts));
}

TEST(MarkJob, MeasuresAllAndTheQuickOnesFirst) {
  const auto evaluator = evaluatorOf(phantom("ball", 32));
  const double r = 0.35 * 31.0;
  const std::vector<Mark> marks{{MarkKind::path, "way", {{r, 0, 0}, {0, r, 0}}},
                                {MarkKind::distance, "straight", {{r, 0, 0}, {0, r, 0}}},
                                {MarkKind::angle, "wrong", {{0, 0, 0}}}};
  const auto task = app::markTask(evaluator, marks);
  std::vector<std::pair<std::size_t, app::MarkReport>> results;
  ASSERT_TRUE(pollUntil([&] {
    const bool finished = task->finished();
    for (auto& result : task->take()) results.push_back(std::move(result));
    return finished;
  }));
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[0].first, 1u);
  EXPECT_EQ(results[1].first, 2u);
  EXPECT_EQ(results[2].first, 0u);
  EXPECT_FALSE(results[1].second.problem.empty());
  EXPECT_FALSE(results[2].second.line.empty());
  EXPECT_TRUE(task->take().empty());
}

// Thrown away in the middle: the evaluator stays with the work until that has ended.
TEST(MarkJob, ThrownAwayEndsByItself) {
  std::weak_ptr<app::MarkEvaluator> watched;
  {
    auto evaluator = evaluatorOf(phantom("ball", 64));
    watched = evaluator;
    app::markTask(std::move(evaluator),
                  std::vector<Mark>(200, {MarkKind::path, "way", {{22, 0, 0}, {-20, 9, 0}}}));
  }
  EXPECT_TRUE(pollUntil([&] { return watched.expired(); }));
}

}  // namespace
}  // namespace isolux::test
