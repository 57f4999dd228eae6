#include "app/slices/slice_draft.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace isolux::app {

namespace {

// Of a pixel along one axis: the squares on either side, and how much of the second.
struct Between {
  int low, high;
  int part;  // of 256
};

std::vector<Between> betweens(int pixels, int coarse, int squares) {
  std::vector<Between> all(static_cast<std::size_t>(pixels));
  for (int i = 0; i < pixels; ++i) {
    const double at = std::clamp((i + 0.5) / coarse - 0.5, 0.0, double(squares - 1));
    const int low = static_cast<int>(at);
    all[static_cast<std::size_t>(i)] = {low, std::min(low + 1, squares - 1),
                                        static_cast<int>(std::lround(256.0 * (at - low)))};
  }
  return all;
}

}  // namespace

volume::SlicePlane coarsened(const volume::SlicePlane& plane, int coarse) {
  if (coarse <= 1) return plane;
  volume::SlicePlane fewer = plane;
  fewer.originMm = plane.at(glm::dvec2(0.5 * (coarse - 1)));
  fewer.rightMm *= coarse;
  fewer.downMm *= coarse;
  fewer.size = (plane.size + coarse - 1) / coarse;
  return fewer;
}

render::ColorImage enlarged(render::ColorImage picture, int coarse, glm::ivec2 size) {
  if (coarse <= 1) return picture;
  render::ColorImage result{size, std::vector<std::uint8_t>(4 * volume::Extent2{size}.count())};
  const std::vector<Between> columns = betweens(size.x, coarse, picture.size.x),
                             rows = betweens(size.y, coarse, picture.size.y);
  const auto pixel = [&](int x, int y) {
    return &picture.rgba[4 * volume::Extent2{picture.size}.index(x, y)];
  };
  std::uint8_t* to = result.rgba.data();
  for (const Between& row : rows)
    for (const Between& column : columns) {
      const std::uint8_t* const corners[4] = {pixel(column.low, row.low), pixel(column.high, row.low),
                                              pixel(column.low, row.high), pixel(column.high, row.high)};
      for (int i = 0; i < 4; ++i) {
        const int above = corners[0][i] * (256 - column.part) + corners[1][i] * column.part;
        const int below = corners[2][i] * (256 - column.part) + corners[3][i] * column.part;
        *to++ = static_cast<std::uint8_t>((above * (256 - row.part) + below * row.part + (1 << 15)) >> 16);
      }
    }
  return result;
}

}  // namespace isolux::app
