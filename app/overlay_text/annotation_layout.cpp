#include "app/overlay_text/annotation_layout.h"

#include <algorithm>
#include <cmath>

#include "scene/rules/needs.h"

namespace isolux::app {

namespace {

constexpr int kLowestWithLetters = 48, kLowestWithTexts = 160;  // pixels
constexpr double kBarPart = 0.175;                              // of the picture's smaller side, at most

int leastOf(glm::ivec2 picture) {
  return std::min(picture.x, picture.y);
}

}  // namespace

bool areKeyed(const std::vector<ShownValue>& values, const scene::Scene& scene) {
  return values.size() > 1 && !scene::isMeasure(scene.look.mode);
}

std::string lineOf(const ShownValue& value, bool keyed) {
  return keyed ? value.text : "Isovalue " + value.text;
}

bool AnnotationLayout::hasLetters(glm::ivec2 picture) {
  return leastOf(picture) >= kLowestWithLetters;
}

bool AnnotationLayout::hasTexts(glm::ivec2 picture) {
  return leastOf(picture) >= kLowestWithTexts;
}

double AnnotationLayout::longestBar(glm::ivec2 picture) {
  return kBarPart * leastOf(picture);
}

AnnotationLayout::AnnotationLayout(glm::ivec2 picture)
    : picture_(picture),
      margin_(std::max(4, leastOf(picture) / 48)),
      letterFont_(std::max(15, leastOf(picture) / 26)),
      textFont_(std::max(11, leastOf(picture) / 42)) {}

glm::ivec2 AnnotationLayout::textSize(const std::vector<std::string>& lines) const {
  int width = 0;
  for (const std::string& line : lines) width = std::max(width, textFont_.width(line));
  return {width, textFont_.lineHeight() * static_cast<int>(lines.size() - 1) + textFont_.ascent()};
}

PixelBox AnnotationLayout::bar(const ScaleBar& bar) {
  const int length = static_cast<int>(std::lround(bar.pixels)), ascent = textFont_.ascent();
  return inCorner({std::max(length, textFont_.width(bar.text)), ascent + 2 * std::max(3, ascent / 2)}, false);
}

PixelBox AnnotationLayout::values(const std::vector<ShownValue>& values, bool keyed) {
  std::vector<std::string> lines;
  for (const ShownValue& value : values) lines.push_back(lineOf(value, keyed));
  return inCorner(textSize(lines) + glm::ivec2(indent(keyed), 0), true);
}

// In the right corner at the bottom, moved up over what stands there already.
PixelBox AnnotationLayout::caveats(glm::ivec2 size) {
  PixelBox box{picture_ - margin_ - size, size};
  for (const PixelBox& other : taken_)
    if (!isFree(box) && meet(box, other, margin_ / 2)) box.low.y = other.low.y - margin_ - box.size.y;
  taken_.push_back(box);
  return box;
}

std::array<PixelBox, 4> AnnotationLayout::letters(const scene::EdgeLetters& letters) {
  const int height = letterFont_.ascent(), middle = (picture_.y - height) / 2;
  const auto width = [&](const std::string& text) { return letterFont_.width(text); };
  const auto centred = [&](const std::string& text) { return (picture_.x - width(text)) / 2; };
  const auto put = [&](const std::string& text, glm::ivec2 low, int axis) {
    return text.empty() ? PixelBox{} : besideOthers({low, {width(text), height}}, axis);
  };
  return {put(letters.left, {margin_, middle}, 1),
          put(letters.right, {picture_.x - margin_ - width(letters.right), middle}, 1),
          put(letters.top, {centred(letters.top), margin_}, 0),
          put(letters.bottom, {centred(letters.bottom), picture_.y - margin_ - height}, 0)};
}

// In the left corner at the top or at the bottom; in the right one where the legend stands in that.
PixelBox AnnotationLayout::inCorner(glm::ivec2 size, bool top) {
  const int y = top ? margin_ : picture_.y - margin_ - size.y;
  const PixelBox left{{margin_, y}, size}, right{{picture_.x - margin_ - size.x, y}, size};
  taken_.push_back(isFree(left) || !isFree(right) ? left : right);
  return taken_.back();
}

// Moved along its edge of the picture where something stands already.
PixelBox AnnotationLayout::besideOthers(const PixelBox& wanted, int axis) {
  PixelBox best = wanted;
  int least = picture_[axis];
  if (!isFree(wanted)) {
    for (const PixelBox& other : taken_) {
      for (const int at :
           {other.low[axis] - margin_ - wanted.size[axis] - 1, other.high()[axis] + margin_ + 1}) {
        PixelBox moved = wanted;
        moved.low[axis] = at;
        const int far = std::abs(at - wanted.low[axis]);
        if (at < margin_ || at + wanted.size[axis] > picture_[axis] - margin_ || far >= least ||
            !isFree(moved))
          continue;
        best = moved;
        least = far;
      }
    }
  }
  taken_.push_back(best);
  return best;
}

bool AnnotationLayout::isFree(const PixelBox& box) const {
  return std::ranges::none_of(taken_, [&](const PixelBox& other) { return meet(box, other, margin_ / 2); });
}

}  // namespace isolux::app
