#include "app/tasks/step_player.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/tasks/step_ahead.h"
#include "base/destroy_in_background.h"

namespace isolux::app {

namespace {
constexpr double kPicturesPerSecond = 8.0;  // that blends are made for
}

int StepPlayer::blendsOf(double speed) {
  return static_cast<int>(std::clamp(std::round(kPicturesPerSecond / speed), 1.0, kPicturesPerSecond));
}

StepPlayer::StepPlayer(Step shown, double speed)
    : last_(std::move(shown)),
      blends_(blendsOf(speed)),
      round_((last_.volume->volume.timeSteps - 1) * blends_ + 1),
      framesPerSecond_(speed * blends_),
      first_(std::llround(last_.source.timeStep * blends_)),
      shown_(first_) {
  const bool isFrame = static_cast<double>(first_) == last_.source.timeStep * blends_;
  if (isFrame) ready_[inRound(first_)] = last_.volume;
}

std::optional<StepPlayer::Step> StepPlayer::at(double seconds) {
  const Frame now = first_ + static_cast<Frame>(seconds * framesPerSecond_);
  collect(seconds);
  const bool isNew = showNewest(now);
  loadNext(now, seconds);
  return isNew ? std::optional(last_) : std::nullopt;
}

// Of the frames whose time has come.
bool StepPlayer::showNewest(Frame now) {
  for (Frame frame = now; frame > std::max(shown_, now - round_); --frame) {
    const auto found = ready_.find(inRound(frame));
    if (found == ready_.end()) continue;
    shown_ = frame;
    if (found->second == last_.volume) return false;
    last_.source.timeStep = static_cast<double>(found->first) / blends_;
    last_.volume = found->second;
    return true;
  }
  return false;
}

void StepPlayer::collect(double seconds) {
  if (!task_ || !task_->finished()) return;
  loadSeconds_ = seconds - began_;
  const std::optional<base::Error> error = task_->error();
  const bool isFull = error && error->kind() == base::ErrorKind::memory;
  if (isFull && (!ready_.empty() || !base::awaitDestroyed(0.0)))
    ready_.clear();  // there may be room without what was kept, once it is freed
  else if (error)
    error_ = error;
  else
    ready_[loading_] = task_->value().volume;
  task_.reset();
}

// The first that is missing of those that can be loaded in time.
void StepPlayer::loadNext(Frame now, double seconds) {
  if (task_ || error_) return;
  const Frame next = now + std::max<Frame>(1, std::llround(std::ceil(loadSeconds_ * framesPerSecond_)));
  for (Frame frame = next; frame < next + round_; ++frame) {
    if (ready_.contains(inRound(frame))) continue;
    if (!makeRoom(now, frame)) return;
    loading_ = inRound(frame);
    began_ = seconds;
    scene::Source source = last_.source;
    source.timeStep = static_cast<double>(loading_) / blends_;
    task_ = loadTask(std::move(source));
    return;
  }
}

// Gives up the frame whose turn comes last, if that is after `next`; the one on show stays with its owner.
// False: not now.
bool StepPlayer::makeRoom(Frame now, Frame next) {
  if (hasRoomForStep(*last_.volume)) return true;
  const auto turn = [&](int place) { return 1 + (place - inRound(now) - 1 + round_) % round_; };
  const auto last = std::ranges::max_element(
      ready_, [&](const auto& a, const auto& b) { return turn(a.first) < turn(b.first); });
  if (last != ready_.end() && turn(last->first) > turn(inRound(next))) ready_.erase(last);
  // One at a time, however little there is: the reader refuses what does not fit when all else is freed.
  return ready_.empty() && base::awaitDestroyed(0.0);
}

}  // namespace isolux::app
