// Pictures of a thread: the newest order counts, drafts are shown, and stopping costs nothing of the next.
#include "app/tasks/picture_thread.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "base/destroy_in_background.h"
#include "base/error.h"
#include "render/renderer.h"
#include "scene/camera.h"
#include "scene/rules/automatic.h"
#include "tests/support/losing_context.h"
#include "tests/support/own_waits.h"
#include "tests/support/poll.h"
#include "tests/support/surfaces.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

app::PictureThread::Options inSoftware() {
  return {.context = [] { return render::OffscreenContext::create(render::ContextChoice::software); }};
}

class PictureThreadGlTest : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(pollUntil([&] { return thread_.context() != nullptr; }));
    ASSERT_TRUE(thread_.context()->description.has_value());
  }

  app::PictureOrder order(double fov, glm::ivec2 size = {128, 96}) {
    app::PictureOrder order;
    order.volume = volume_;
    scene::Scene scene;
    scene.camera.fov = fov;
    order.scene = scene::resolve(scene, volume_->facts);
    order.request.size = size;
    return order;
  }

  app::PictureThread::Result next() {
    std::optional<app::PictureThread::Result> result;
    EXPECT_TRUE(pollUntil([&] {
      result = thread_.take();
      return result.has_value();
    }));
    return std::move(*result);
  }
  // Until the thread has begun to draw the order that gave it `volume`, which nobody else has: the renderer
  // holds it then, too.
  static void awaitBegin(const std::shared_ptr<const volume::PreparedVolume>& volume) {
    constexpr long here = 1, inTheOrder = 1;
    EXPECT_TRUE(pollUntil([&] { return volume.use_count() > here + inTheOrder; }));
  }
  static std::shared_ptr<const volume::PreparedVolume> anotherVolume() {
    scene::Source source;
    source.path = "phantom:gyroid:48";
    base::Progress progress;
    return volume::loadVolume(source, progress);
  }
  static std::pair<std::uint64_t, std::shared_ptr<const volume::PreparedVolume>> begun(
      app::PictureThread& thread, app::PictureOrder asked) {
    const auto volume = asked.volume = anotherVolume();
    return {thread.draw(std::exchange(asked, {})), volume};
  }
  app::DrawnPicture nextPicture() { return std::get<app::DrawnPicture>(next()); }

  // The same by a renderer of this thread.
  std::vector<std::uint8_t> expected(const app::PictureOrder& order) {
    const auto context = render::OffscreenContext::create(render::ContextChoice::software);
    context->makeCurrent();
    render::Renderer renderer(context->gl());
    renderer.setVolume(order.volume);
    renderer.render(order.scene, order.request);
    return renderer.readColor().rgba;
  }

  std::shared_ptr<const volume::PreparedVolume> volume_ = phantom("gyroid", 48);
  app::PictureThread thread_{inSoftware()};
};

}  // namespace

TEST_F(PictureThreadGlTest, APictureIsThatOfARendererHere) {
  app::PictureOrder asked = order(30.0);
  asked.request.hits = render::FrameRequest::Hits::many;
  const std::uint64_t number = thread_.draw(asked);
  EXPECT_TRUE(thread_.busy());
  const app::DrawnPicture picture = nextPicture();
  EXPECT_FALSE(thread_.busy());
  EXPECT_EQ(picture.order, number);
  EXPECT_EQ(picture.color.rgba, expected(asked));
  EXPECT_GT(picture.milliseconds, 0.0);
  for (const auto* hits : {&picture.hitVoxels.outer, &picture.hitVoxels.inner}) {
    ASSERT_FALSE(hits->empty());
    for (const glm::vec3& hit : *hits) {
      EXPECT_GE(std::min({hit.x, hit.y, hit.z}), 0.0F);
      EXPECT_LE(std::max({hit.x, hit.y, hit.z}), 47.0F);
    }
  }
}

TEST_F(PictureThreadGlTest, TheNewestOrderIsDrawnAndIsRight) {
  for (int round = 0; round < 5; ++round) {
    std::uint64_t last = 0;
    app::PictureOrder asked;
    for (int i = 0; i < 20; ++i) {
      asked = order(20.0 + i + round, i % 2 == 0 ? glm::ivec2{160, 120} : glm::ivec2{96, 64});
      asked.draft = i % 3 == 0;
      last = thread_.draw(asked);
      std::this_thread::sleep_for(std::chrono::milliseconds(i % 4));
    }
    app::DrawnPicture picture;
    while (picture.order < last) picture = nextPicture();
    EXPECT_EQ(picture.color.rgba, expected(asked));
    EXPECT_FALSE(thread_.busy());
    EXPECT_FALSE(thread_.take().has_value());
  }
}

// What a window calls while a picture is drawn, and when it closes.
TEST_F(PictureThreadGlTest, ItsOwnerWaitsForNothing) {
  long inCalls = std::numeric_limits<long>::max(), atTheEnd = inCalls;
  for (int i = 0; i < 5; ++i) {
    auto thread = std::make_unique<app::PictureThread>(inSoftware());
    ASSERT_TRUE(pollUntil([&] { return thread->context() != nullptr; }));
    app::PictureOrder large = order(30.0, {1024, 1024});
    large.draft = true;  // is not dropped: the thread goes on with it
    large.request.supersampling = 3;
    awaitBegin(begun(*thread, large).second);
    app::PictureOrder next = order(31.0), last = order(32.0);
    inCalls = std::min(inCalls, ownWaits([&] {
                         thread->draw(std::move(next));
                         thread->take();
                         thread->draw(std::move(last));
                         thread->drop();
                       }));
    EXPECT_FALSE(thread->busy());
    atTheEnd = std::min(atTheEnd, ownWaits([&] { thread.reset(); }));
  }
  EXPECT_EQ(inCalls, 0);
  EXPECT_EQ(atTheEnd, 0);
  EXPECT_TRUE(base::awaitDestroyed(600.0));
}

// A draft is drawn to its end whatever is ordered meanwhile; a picture that is none makes way.
TEST_F(PictureThreadGlTest, DraftsAreNotDropped) {
  app::PictureOrder large = order(30.0, {1024, 1024});
  large.draft = true;
  const auto [draft, ofDraft] = begun(thread_, large);
  awaitBegin(ofDraft);
  large.draft = false;
  large.request.supersampling = 3;  // seconds of the processor: others come before its end
  const auto [dropped, ofDropped] = begun(thread_, large);
  EXPECT_EQ(nextPicture().order, draft);
  awaitBegin(ofDropped);
  const std::uint64_t last = thread_.draw(order(32.0));
  EXPECT_EQ(nextPicture().order, last);
  EXPECT_GT(last, dropped);
}

TEST_F(PictureThreadGlTest, APictureThatFailsSaysWhyAndTheNextComes) {
  app::PictureOrder bad = order(30.0);
  test::surfaceAt(bad.scene, 1).shown = true;  // and nobody has said where it is
  test::surfaceAt(bad.scene, 1).value.reset();
  const std::uint64_t number = thread_.draw(bad);
  const app::PictureThread::Result failed = next();
  ASSERT_TRUE(std::holds_alternative<app::FailedPicture>(failed));
  EXPECT_EQ(std::get<app::FailedPicture>(failed).order, number);
  EXPECT_THROW(std::rethrow_exception(std::get<app::FailedPicture>(failed).reason), std::bad_optional_access);
  const app::PictureOrder good = order(30.0);
  thread_.draw(good);
  EXPECT_EQ(nextPicture().color.rgba, expected(good));
}

TEST_F(PictureThreadGlTest, AfterAResetOfTheDriverTheNextPictureHasAnotherContext) {
  std::atomic<int> contexts{0}, news{0};
  app::PictureThread thread({.context =
                                 [&] {
                                   ++contexts;
                                   return std::make_unique<LosingContext>(
                                       render::OffscreenContext::create(render::ContextChoice::software));
                                 },
                             .news = [&] { ++news; }});
  const auto result = [&] {
    std::optional<app::PictureThread::Result> taken;
    EXPECT_TRUE(pollUntil([&] { return (taken = thread.take()).has_value(); }));
    return std::move(*taken);
  };
  ASSERT_TRUE(pollUntil([&] { return thread.context() != nullptr; }));
  thread.draw(order(30.0));
  EXPECT_TRUE(std::holds_alternative<app::DrawnPicture>(result()));
  LosingContext::lost = true;
  thread.draw(order(31.0));
  const app::PictureThread::Result failed = result();
  LosingContext::lost = false;
  ASSERT_TRUE(std::holds_alternative<app::FailedPicture>(failed));
  EXPECT_THROW(std::rethrow_exception(std::get<app::FailedPicture>(failed).reason), render::ContextLost);
  EXPECT_EQ(contexts, 1);
  thread.draw(order(31.0));
  const app::PictureThread::Result next = result();
  ASSERT_TRUE(std::holds_alternative<app::DrawnPicture>(next));
  EXPECT_EQ(std::get<app::DrawnPicture>(next).color.rgba, expected(order(31.0)));
  EXPECT_EQ(contexts, 2);
  EXPECT_TRUE(pollUntil([&] { return news == 4; })) << "one of the context and one of each result";
}

TEST_F(PictureThreadGlTest, AStillIsDrawnWhateverIsOrderedMeanwhile) {
  thread_.draw(order(30.0, {800, 600}));
  const app::PictureOrder asked = order(25.0, {320, 240});
  const auto still = thread_.drawStill(asked);
  thread_.draw(order(31.0));
  ASSERT_TRUE(pollUntil([&] { return still->finished.load(); }));
  ASSERT_FALSE(still->failure);
  EXPECT_EQ(still->picture.color.rgba, expected(asked));
}

}  // namespace isolux::test
