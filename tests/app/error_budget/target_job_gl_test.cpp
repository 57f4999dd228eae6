// Searches on a thread of their own: what TargetSearch finds, refusals as errors, and an end when they are
// dropped.
#include "app/error_budget/target_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/render/gl_fixture.h"
#include "tests/support/poll.h"

namespace isolux::test {
namespace {

using namespace app;

class TargetJobGlTest : public RenderGlTest {
 protected:
  TargetSubject subject(const std::string& target) {
    TargetSubject subject;
    subject.volume = phantom("gyroid", 48);
    subject.given = assigned({"derivatives.normal_scale=0"});
    subject.picture.size = {160, 120};
    subject.host.executor = scene::Executor::cpu;
    if (!target.empty()) subject.limits = parseErrorTarget(target);
    return subject;
  }
};

TEST_F(TargetJobGlTest, FindsWhatTheSearchFinds) {
  const TargetSubject asked = subject("normal=30deg");
  const auto task = targetTask(asked);
  renderer_->setHostSettings(asked.host);
  renderer_->setVolume(asked.volume);
  base::Progress progress;
  TargetSearch search(*renderer_, {asked.volume, asked.given, asked.picture, asked.host, true, {}});
  const TargetAnswer here = search.keepErrors(asked.limits, progress).value();
  ASSERT_TRUE(pollUntil([&] { return task->finished(); }));
  ASSERT_FALSE(task->error()) << task->error()->what();
  const TargetAnswer& found = task->value().value();
  EXPECT_EQ(found.measured[found.chosen].candidate.assignments,
            here.measured[here.chosen].candidate.assignments);
  EXPECT_THAT(found.measured[found.chosen].candidate.assignments,
              testing::Contains("derivatives.field=trilinear"));
}

TEST_F(TargetJobGlTest, ATimeIsKeptByTheClock) {
  TargetSubject asked = subject("");
  asked.milliseconds = 600000.0;
  const auto task = targetTask(std::move(asked));
  ASSERT_TRUE(pollUntil([&] { return task->finished(); }));
  ASSERT_FALSE(task->error()) << task->error()->what();
  EXPECT_GT(task->value()->expectedMilliseconds, 0.0);
  EXPECT_LE(task->value()->expectedMilliseconds, 600000.0);
}

TEST_F(TargetJobGlTest, WhatNothingKeepsIsRefused) {
  const auto task = targetTask(subject("depth=0.000000001mm"));
  ASSERT_TRUE(pollUntil([&] { return task->finished(); }));
  ASSERT_TRUE(task->error());
  EXPECT_EQ(task->error()->kind(), base::ErrorKind::usage);
}

TEST_F(TargetJobGlTest, ADroppedSearchEnds) {
  {
    const auto task = targetTask(subject("depth=0.01mm"));
    EXPECT_GE(runningSearches(), 1);
  }
  ASSERT_TRUE(pollUntil([] { return runningSearches() == 0; }));
}

}  // namespace
}  // namespace isolux::test
