#include "render/passes/brick_rounds.h"

#include <limits>
#include <utility>

#include <glm/common.hpp>

namespace isolux::render {

namespace {
constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
constexpr int kSmallestArea = 8;   // rays per axis
constexpr int kAreaOfFiles = 128;  // rays per axis whose bricks are neighbours in a file
}  // namespace

BrickRounds::BrickRounds(FrameState& frame, const Pass& pass, std::function<void()> drawAtHits)
    : frame_(frame),
      pass_(pass),
      bricks_(*frame.volume->bricks()),
      drawAtHits_(std::move(drawAtHits)),
      complete_(frame.request.brickUploadBytes == 0),
      largestArea_(bricks_.readsTwice() ? kAreaOfFiles : std::numeric_limits<int>::max()) {}

void BrickRounds::castRound(const volume::Rectangle& area, bool again) {
  frame_.raysOfRound = area;
  bricks_.forgetWanted();
  bricks_.beginRound();
  frame_.onlyWaiting = again;
  pass_.run(frame_);
  frame_.onlyWaiting = false;
  bricks_.endRound();
  frame_.raysOfRound.reset();
}

BrickRounds::Unfinished BrickRounds::ofLastRound() const {
  return {bricks_.waitingRays(), bricks_.lostRays()};
}

BrickRounds::Unfinished BrickRounds::cast() {
  const volume::Rectangle picture{glm::ivec2(0), frame_.raySize()};
  castRound(picture, false);
  return complete_ ? settle(picture) : ofLastRound();
}

// After a round over the area.
BrickRounds::Unfinished BrickRounds::settle(const volume::Rectangle& area) {
  std::size_t stuckAt = 0;  // rays that waited when nothing could be replaced
  while (bricks_.waitingRays() > 0 && glm::max(area.size.x, area.size.y) <= largestArea_) {
    if (bricks_.wouldReplace()) drawAtHits_();
    // What rays of this round used on their way stays, or none would get further.
    const bool served = bricks_.serve(bricks_.thisRound(), kNoLimit) > 0;
    if (!served && bricks_.waitingRays() == stuckAt) break;
    // Not served: rays that have arrived no longer need the bricks they used; another round shows which those
    // are.
    stuckAt = served ? 0 : bricks_.waitingRays();
    castRound(area, true);
  }
  if (bricks_.waitingRays() == 0 || glm::max(area.size.x, area.size.y) <= kSmallestArea) return ofLastRound();
  Unfinished left;
  const glm::ivec2 half = (area.size + 1) / 2;
  for (const glm::ivec2& corner : {glm::ivec2(0, 0), glm::ivec2(1, 0), glm::ivec2(0, 1), glm::ivec2(1, 1)}) {
    const glm::ivec2 low = corner * half, size = glm::min(half, area.size - low);
    if (size.x <= 0 || size.y <= 0) continue;
    const volume::Rectangle part{area.low + low, size};
    castRound(part, true);
    const Unfinished now = settle(part);
    left.waiting += now.waiting;
    left.lost += now.lost;
  }
  return left;
}

BrickRounds::Unfinished BrickRounds::draw() {
  do {
    bricks_.beginRound();
    pass_.run(frame_);
    bricks_.endRound();
  } while (complete_ && bricks_.waitingRays() > 0 && bricks_.serve(bricks_.thisRound(), kNoLimit) > 0);
  return ofLastRound();
}

}  // namespace isolux::render
