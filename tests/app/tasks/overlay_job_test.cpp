// Errors laid over a picture on a thread of its own: the same as where they are painted by hand.
#include "app/accuracy/error_overlay.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/support/poll.h"

namespace isolux::app {
namespace {

constexpr glm::ivec2 kSize{64, 48};

std::shared_ptr<const PictureErrors> rising() {
  const auto count = static_cast<std::size_t>(kSize.x * kSize.y);
  PictureErrors errors;
  errors.size = kSize;
  errors.certain.assign(count, 1);
  for (std::size_t i = 0; i < count; ++i) errors.depthMm.push_back(1e-6f * static_cast<float>(i + 1));
  return std::make_shared<const PictureErrors>(std::move(errors));
}

render::ColorImage grey() {
  return {kSize, std::vector<std::uint8_t>(static_cast<std::size_t>(4 * kSize.x * kSize.y), 150), false};
}

TEST(OverlayJob, PaintsWhatIsPaintedByHand) {
  const auto errors = rising();
  const OverlayRequest request{true, ErrorImage::depth, {{Quantity::depthMm, 1e-3}}};
  const auto task = overlayTask({grey, errors, request, 0.5, scene::LegendCorner::automatic, {}});
  ASSERT_TRUE(test::pollUntil([&] { return task->finished(); }));
  ASSERT_FALSE(task->error()) << task->error()->what();
  render::ColorImage byHand = grey();
  paintErrors(*errors, request, 0.5, scene::LegendCorner::automatic, {}, byHand);
  EXPECT_EQ(task->value().image.rgba, byHand.rgba);
  EXPECT_NE(task->value().image.rgba, grey().rgba);
}

TEST(OverlayJob, ARefusalIsItsError) {
  const auto task = overlayTask({grey, rising(), {true, ErrorImage::light, {}}, 0.5, {}, {}});
  ASSERT_TRUE(test::pollUntil([&] { return task->finished(); }));
  ASSERT_TRUE(task->error());
  EXPECT_EQ(task->error()->kind(), base::ErrorKind::usage);
}

}  // namespace
}  // namespace isolux::app
