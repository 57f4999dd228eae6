#include "ui/picture_quality.h"

#include <algorithm>
#include <cmath>

namespace isolux::ui {

namespace {
constexpr double slowMilliseconds = 70.0, quickMilliseconds = 25.0;
constexpr double scales[] = {0.25, 0.375, 0.5, 0.75, 1.0};  // few sizes: images are reallocated with each
}  // namespace

bool PictureQuality::complete(int supersampling) const {
  return stage_ == Stage::full || (supersampling <= 1 && scale() == 1.0);
}

bool PictureQuality::refine(int supersampling) {
  if (complete(supersampling)) return false;
  // From a small picture first to the full size at one ray per pixel, which costs a fraction of the last
  // step.
  stage_ = stage_ == Stage::moving && scale_ < 1.0 ? Stage::sharp : Stage::full;
  return true;
}

double PictureQuality::pauseMilliseconds(int supersampling) const {
  const double expected = stage_ == Stage::sharp ? lastMilliseconds_ * supersampling * supersampling : 0.0;
  return std::clamp(0.5 * expected, 60.0, 1000.0);
}

void PictureQuality::measured(double milliseconds) {
  lastMilliseconds_ = milliseconds;
  if (stage_ != Stage::moving) return;
  const auto* current = std::find(std::begin(scales), std::end(scales), scale_);
  if (milliseconds > slowMilliseconds) {
    // Time goes with the area: the largest scale that would have been quick enough.
    const double wanted = scale_ * std::sqrt(0.5 * slowMilliseconds / milliseconds);
    const auto* next = current;
    while (next != std::begin(scales) && *next > wanted) --next;
    scale_ = *next;
  } else if (milliseconds < quickMilliseconds && current + 1 != std::end(scales)) {
    scale_ = current[1];
  }
}

render::FrameRequest PictureQuality::request(glm::ivec2 pixels, int supersampling) const {
  render::FrameRequest request;
  const glm::dvec2 scaled = glm::dvec2(pixels) * scale();
  request.size = {std::max(1, static_cast<int>(std::lround(scaled.x))),
                  std::max(1, static_cast<int>(std::lround(scaled.y)))};
  request.supersampling = stage_ == Stage::full ? std::clamp(supersampling, 1, 4) : 1;
  return request;
}

}  // namespace isolux::ui
