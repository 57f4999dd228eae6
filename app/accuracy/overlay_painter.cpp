#include "app/accuracy/overlay_painter.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "base/color.h"
#include "scene/color_maps.h"

namespace isolux::app {

namespace {

constexpr double kDarkest = 0.55;  // of a colour, where the picture is black

// Premultiplied over straight alpha.
void blend(const std::uint8_t* over, std::uint8_t* pixel) {
  const double below = pixel[3] / 255.0 * (1.0 - over[3] / 255.0), covered = over[3] / 255.0 + below;
  if (covered <= 0.0) return;
  for (int c = 0; c < 3; ++c)
    pixel[c] = static_cast<std::uint8_t>(std::lround((over[c] + pixel[c] * below) / covered));
  pixel[3] = static_cast<std::uint8_t>(std::lround(255.0 * covered));
}

// How many pixels of a rectangle, row 0 the lowest, show a surface or lie under what is `taken`.
std::int64_t coveredOf(const std::vector<std::uint8_t>& seen, glm::ivec2 size,
                       const std::optional<render::Tile>& taken, const volume::Rectangle& rectangle) {
  const glm::ivec2 low = glm::max(rectangle.low, glm::ivec2(0)),
                   high = glm::min(rectangle.low + rectangle.size, size);
  std::int64_t covered = 0;
  for (int y = low.y; y < high.y; ++y) {
    const std::uint8_t* const row = &seen[volume::Extent2{size}.index(0, size.y - 1 - y)];
    covered += std::count(row + low.x, row + high.x, std::uint8_t{1});
  }
  if (taken) {
    const glm::ivec2 shared = common(rectangle, {taken->origin, taken->size}).size;
    covered += std::int64_t{shared.x} * shared.y;
  }
  return covered;
}

}  // namespace

OverlayPainter::OverlayPainter(render::ColorImage& image)
    : image_(image), lineWidth_(std::max(1, std::min(image.size.x, image.size.y) / 240)) {}

void OverlayPainter::color(const std::vector<double>& bounds, glm::dvec2 range) {
  const std::vector<glm::vec3> colors = scene::colorMapSamples(scene::ColorMap::cividis, kOverlayColors);
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (std::isnan(bounds[i])) continue;
    glm::dvec3 at(0.35);
    if (std::isfinite(bounds[i])) {
      const double place =
          bounds[i] > 0.0 ? std::log(bounds[i] / range.x) / std::log(range.y / range.x) : 0.0;
      at = colors[static_cast<std::size_t>(std::lround(std::clamp(place, 0.0, 1.0) * (kOverlayColors - 1)))];
    }
    std::uint8_t* const pixel = &image_.rgba[4 * i];
    const double bright = (0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2]) / 255.0;
    const double shade = kDarkest + (1.0 - kDarkest) * bright;
    for (int c = 0; c < 3; ++c) pixel[c] = base::screenByte(at[c] * shade);
    pixel[3] = 255;
  }
}

void OverlayPainter::hatch(const std::vector<std::uint8_t>& hatched) {
  for (std::size_t i = 0; i < hatched.size(); ++i) {
    const render::Hatch part = render::hatchAt(volume::Extent2{image_.size}.at(i), lineWidth_);
    if (!hatched[i] || part == render::Hatch::none) continue;
    const float grey = part == render::Hatch::dark ? render::kHatchDark : render::kHatchBright;
    std::fill_n(&image_.rgba[4 * i], 3, static_cast<std::uint8_t>(std::lround(255.0f * grey)));
    image_.rgba[4 * i + 3] = 255;
  }
}

std::optional<render::Tile> OverlayPainter::addLegend(const render::Legend& legend,
                                                      scene::LegendCorner corner,
                                                      const std::vector<std::uint8_t>& seen,
                                                      const std::optional<render::Tile>& taken) {
  const glm::ivec2 size = image_.size;
  const auto covered = [&](const volume::Rectangle& rectangle) {
    return coveredOf(seen, size, taken, rectangle);
  };
  const render::LegendImage drawn = render::legendFor(legend, size);
  if (drawn.size.x == 0) return std::nullopt;
  const render::Tile place{render::legendPlace(corner, drawn.size, size, covered), drawn.size};
  const glm::ivec2 low(place.origin.x, size.y - place.origin.y - drawn.size.y);
  for (int y = 0; y < drawn.size.y; ++y)
    for (int x = 0; x < drawn.size.x; ++x)
      blend(&drawn.rgba[4 * volume::Extent2{drawn.size}.index(x, y)],
            &image_.rgba[4 * volume::Extent2{size}.index(low + glm::ivec2(x, y))]);
  return place;
}

}  // namespace isolux::app
