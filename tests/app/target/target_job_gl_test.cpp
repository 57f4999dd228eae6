// Searches on a thread of their own: what TargetSearch finds, refusals as errors, and an end when they are
// dropped.
#include "app/target/target_job.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/render/gl_fixture.h"
#include "tests/support/poll.h"

namespace isolux::test {
namespace {

using namespace app;

class TargetJobGlTest : public RenderGlTest {
 protected:
  TargetJob::Subject subject(const std::string& target) {
    TargetJob::Subject subject;
    subject.volume = phantom("gyroid", 48);
    subject.scene = assigned({"derivatives.normal_scale=0"});
    subject.picture.size = {160, 120};
    subject.machine.executor = scene::Executor::cpu;
    if (!target.empty()) subject.limits = parseErrorTarget(target);
    return subject;
  }
};

TEST_F(TargetJobGlTest, FindsWhatTheSearchFinds) {
  const TargetJob::Subject asked = subject("normal=30deg");
  const TargetJob job(asked);
  renderer_->setMachine(asked.machine);
  renderer_->setVolume(asked.volume);
  base::Progress progress;
  TargetSearch search(*renderer_, {asked.volume, asked.scene, asked.picture, asked.machine, true, {}});
  const TargetAnswer here = search.keepErrors(asked.limits, progress).value();
  ASSERT_TRUE(pollUntil([&] { return job.finished(); }));
  ASSERT_FALSE(job.error()) << job.error()->what();
  const TargetAnswer& found = job.answer().value();
  EXPECT_EQ(found.measured[found.chosen].candidate.assignments,
            here.measured[here.chosen].candidate.assignments);
  EXPECT_THAT(found.measured[found.chosen].candidate.assignments,
              testing::Contains("derivatives.field=trilinear"));
}

TEST_F(TargetJobGlTest, ATimeIsKeptByTheClock) {
  TargetJob::Subject asked = subject("");
  asked.milliseconds = 600000.0;
  const TargetJob job(std::move(asked));
  ASSERT_TRUE(pollUntil([&] { return job.finished(); }));
  ASSERT_FALSE(job.error()) << job.error()->what();
  EXPECT_GT(job.answer()->expectedMilliseconds, 0.0);
  EXPECT_LE(job.answer()->expectedMilliseconds, 600000.0);
}

TEST_F(TargetJobGlTest, WhatNothingKeepsIsRefused) {
  const TargetJob job(subject("depth=0.000000001mm"));
  ASSERT_TRUE(pollUntil([&] { return job.finished(); }));
  ASSERT_TRUE(job.error());
  EXPECT_EQ(job.error()->kind(), base::ErrorKind::usage);
  EXPECT_FALSE(job.answer());
}

TEST_F(TargetJobGlTest, ADroppedSearchEnds) {
  {
    const TargetJob job(subject("depth=0.01mm"));
    EXPECT_GE(TargetJob::running(), 1);
  }
  ASSERT_TRUE(pollUntil([] { return TargetJob::running() == 0; }));
}

}  // namespace
}  // namespace isolux::test
