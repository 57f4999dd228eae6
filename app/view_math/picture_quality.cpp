#include "app/view_math/picture_quality.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isolux::app {

namespace {

struct Level {
  double scale;       // of width and height
  int supersampling;  // rays per pixel and axis
  double rays() const { return scale * scale * supersampling * supersampling; }
};
// Few sizes: images are reallocated with each.
constexpr std::array<Level, 8> levels = {
    {{0.25, 1}, {0.375, 1}, {0.5, 1}, {0.75, 1}, {1.0, 1}, {1.0, 2}, {1.0, 3}, {1.0, 4}}};
constexpr std::size_t halfSize = 2, fullSize = 4;
static_assert(levels[halfSize].scale == 0.5 && levels[fullSize].scale == 1.0);

// Parts of the target that a coarser and a finer level must be expected to keep. What lies between them and
// the target itself keeps a level from changing back and forth.
constexpr double enough = 0.9, comfortable = 0.7;

std::size_t finest(int supersampling) {
  return fullSize + static_cast<std::size_t>(std::clamp(supersampling, 1, 4) - 1);
}

}  // namespace

PictureQuality::PictureQuality(bool software)
    : levels_{software ? halfSize : fullSize, levels.size() - 1}, ceiling_(levels.size() - 1) {}

std::size_t PictureQuality::level(Motion motion) const {
  const std::size_t full = finest(supersampling_);
  if (!host_.adaptive || stage_ == Stage::full) return full;
  if (stage_ == Stage::sharp) return std::min(full, fullSize);
  const std::size_t affordable = levels_[static_cast<std::size_t>(motion)];
  return std::min({full, affordable, motion == Motion::look ? ceiling_ : full});
}

double PictureQuality::scale() const {
  return levels[level(motion_)].scale;
}

int PictureQuality::supersampling() const {
  return levels[level(motion_)].supersampling;
}

bool PictureQuality::complete() const {
  return level(motion_) == finest(supersampling_);
}

void PictureQuality::changed(Motion motion) {
  if (motion == Motion::look) ceiling_ = level(motion_);
  stage_ = Stage::moving;
  motion_ = motion;
}

void PictureQuality::animated() {
  if (stage_ == Stage::full) changed(Motion::look);
}

void PictureQuality::setLightChanging(bool changing) {
  lightChanging_ = changing;
  if (changing && stage_ == Stage::full) stage_ = Stage::sharp;
}

bool PictureQuality::mayRefine() const {
  return !complete() && !(lightChanging_ && stage_ == Stage::sharp);
}

bool PictureQuality::refine() {
  // Nothing finer follows, but what follows must not be coarser because this picture turns out slow.
  if (stage_ == Stage::moving && complete()) stage_ = lightChanging_ ? Stage::sharp : Stage::full;
  if (!mayRefine()) return false;
  // From a small picture first to the full size at one ray per pixel, which costs a fraction of the last
  // step.
  stage_ = level(motion_) < fullSize || lightChanging_ ? Stage::sharp : Stage::full;
  return true;
}

double PictureQuality::pauseMilliseconds() const {
  const double expected = stage_ == Stage::sharp ? lastMilliseconds_ * supersampling_ * supersampling_ : 0.0;
  return std::clamp(0.5 * expected, 60.0, 1000.0);
}

void PictureQuality::measured(double milliseconds, Motion motion) {
  lastMilliseconds_ = milliseconds;
  if (stage_ != Stage::moving || !host_.adaptive) return;
  const std::size_t drawn = level(motion_), full = finest(supersampling_);
  const auto expected = [&](std::size_t other) {
    return milliseconds * levels[other].rays() / levels[drawn].rays();
  };
  std::size_t next = drawn;
  if (milliseconds > host_.motionTarget) {
    while (next > 0 && expected(next) > enough * host_.motionTarget) --next;
  } else {
    while (next < full && expected(next + 1) <= comfortable * host_.motionTarget) ++next;
  }
  if (next != drawn) levels_[static_cast<std::size_t>(motion)] = next;
}

render::FrameRequest PictureQuality::request(glm::ivec2 pixels) const {
  const glm::dvec2 scaled = glm::dvec2(pixels) * scale();
  return {.size = {std::max(1, static_cast<int>(std::lround(scaled.x))),
                   std::max(1, static_cast<int>(std::lround(scaled.y)))},
          .supersampling = supersampling()};
}

}  // namespace isolux::app
