#include "tests/render/picture_difference.h"

#include <algorithm>
#include <cstdlib>

namespace isolux::test {

PictureDifference differenceOf(const render::ColorImage& a, const render::ColorImage& b) {
  PictureDifference result;
  const std::size_t pixels = a.rgba.size() / 4;
  double sum = 0.0;
  std::size_t visible = 0;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    int most = 0;
    for (std::size_t i = 4 * pixel; i < 4 * pixel + 3; ++i) {
      const int difference = std::abs(int{a.rgba[i]} - int{b.rgba[i]});
      sum += difference;
      most = std::max(most, difference);
    }
    visible += most > kVisibleSteps;
    result.largest = std::max(result.largest, most);
  }
  result.mean = sum / static_cast<double>(3 * pixels);
  result.visible = static_cast<double>(visible) / static_cast<double>(pixels);
  return result;
}

bool mayBeRounding(const PictureDifference& difference) {
  return difference.mean <= 0.05 && difference.visible <= 0.005;
}

render::ColorImage amplifiedDifference(const render::ColorImage& a, const render::ColorImage& b) {
  render::ColorImage result = a;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    const int difference = static_cast<int>(a.rgba[i]) - static_cast<int>(b.rgba[i]);
    result.rgba[i] = static_cast<std::uint8_t>(std::clamp(128 + 8 * difference, 0, 255));
  }
  return result;
}

}  // namespace isolux::test
