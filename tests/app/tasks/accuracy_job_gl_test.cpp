// Bounds of a picture on a thread of their own: those that are measured here, of what drew the picture; and a
// task that is dropped ends.
#include "app/accuracy/accuracy.h"

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/poll.h"

namespace isolux::test {
namespace {

class AccuracyJobGlTest : public RenderGlTest {
 protected:
  app::AccuracySubject subject(bool onProcessor) {
    const auto volume = phantom("torus", 32);
    return {{volume, scene::resolve(assigned({}), volume->facts), nullptr, {96, 80}}, onProcessor};
  }
};

TEST_F(AccuracyJobGlTest, FindsWhatIsMeasuredHere) {
  for (const bool onProcessor : {true, false}) {
    SCOPED_TRACE(onProcessor);
    const app::AccuracySubject asked = subject(onProcessor);
    const auto task = app::accuracyTask(asked);
    scene::HostSettings host;
    host.executor = onProcessor ? scene::Executor::cpu : scene::Executor::gpu;
    renderer_->setHostSettings(host);
    renderer_->setVolume(asked.volume);
    renderer_->invalidate();
    base::Progress progress;
    const app::Accuracy here = app::accuracyOf(app::measureErrors(*renderer_, asked, progress));
    ASSERT_TRUE(pollUntil([&] { return task->finished(); }));
    ASSERT_FALSE(task->error()) << task->error()->what();
    const app::Accuracy& found = task->value().accuracy;
    EXPECT_EQ(found.pixels, 96u * 80u);
    EXPECT_GT(found.seen, 500u);
    // The processor casts for both; whose arithmetic is bounded decides the bound.
    EXPECT_NEAR(found.depthMm.median, here.depthMm.median, 1e-3 * here.depthMm.median);
    EXPECT_NEAR(found.normalDegrees.most99, here.normalDegrees.most99, 1e-3 * here.normalDegrees.most99);
  }
}

TEST_F(AccuracyJobGlTest, ADroppedJobEnds) {
  app::accuracyTask(subject(true));
  EXPECT_TRUE(base::awaitDestroyed(60.0));
}

}  // namespace
}  // namespace isolux::test
