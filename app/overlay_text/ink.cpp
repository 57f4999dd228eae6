#include "app/overlay_text/ink.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "base/color.h"

namespace isolux::app {

namespace {

constexpr double kBright = 245.0, kDark = 12.0;  // sRGB
constexpr double kRimAlpha = 0.75;

// `color` with `alpha` over a pixel of straight alpha.
void blendOnto(std::uint8_t* pixel, double color, double alpha) {
  const double below = pixel[3] / 255.0 * (1.0 - alpha), covered = alpha + below;
  if (covered <= 0.0) return;
  for (int i = 0; i < 3; ++i)
    pixel[i] = static_cast<std::uint8_t>(std::lround((color * alpha + pixel[i] * below) / covered));
  pixel[3] = static_cast<std::uint8_t>(std::lround(covered * 255.0));
}

}  // namespace

Ink::Ink(glm::ivec2 size) : size_(size), ink_(volume::Extent2{size}.count()) {}

void Ink::plot(glm::ivec2 p, int coverage) {
  if (!volume::Extent2{size_}.contains(p) || coverage <= 0) return;
  std::uint8_t& at = ink_[index(p)];
  at = std::max(at, static_cast<std::uint8_t>(coverage));
  low_ = glm::min(low_, p);
  high_ = glm::max(high_, p);
}

void Ink::fill(glm::ivec2 from, glm::ivec2 to) {
  for (int y = from.y; y < to.y; ++y)
    for (int x = from.x; x < to.x; ++x) plot({x, y}, 255);
}

void Ink::text(const render::Font& font, const std::string& text, glm::ivec2 origin) {
  font.draw(text, origin, [this](glm::ivec2 p, int coverage) { plot(p, coverage); });
}

// The ink, each pixel of it spread over a disc.
std::vector<std::uint8_t> Ink::rimOf(int rim) const {
  std::vector<std::uint8_t> spread(ink_.size());
  for (int y = low_.y; y <= high_.y; ++y)
    for (int x = low_.x; x <= high_.x; ++x) {
      const int ink = ink_[index({x, y})];
      if (ink == 0) continue;
      for (int v = std::max(0, y - rim); v <= std::min(size_.y - 1, y + rim); ++v)
        for (int u = std::max(0, x - rim); u <= std::min(size_.x - 1, x + rim); ++u) {
          const double inside = rim + 0.5 - std::hypot(u - x, v - y);
          const auto dark = static_cast<std::uint8_t>(ink * std::clamp(inside, 0.0, 1.0));
          spread[index({u, v})] = std::max(spread[index({u, v})], dark);
        }
    }
  return spread;
}

void Ink::blendOver(render::ColorImage& image, int rim, bool bright) const {
  const std::vector<std::uint8_t> spread = rimOf(rim);
  const glm::ivec2 from = glm::max(low_ - rim, glm::ivec2(0)), to = glm::min(high_ + rim, size_ - 1);
  for (int y = from.y; y <= to.y; ++y)
    for (int x = from.x; x <= to.x; ++x) {
      const std::size_t at = index({x, y});
      if (spread[at] == 0) continue;
      blendOnto(&image.rgba[4 * at], bright ? 0.0 : 255.0, kRimAlpha * spread[at] / 255.0);
      blendOnto(&image.rgba[4 * at], bright ? kBright : kDark, ink_[at] / 255.0);
    }
}

void fillWith(render::ColorImage& image, glm::ivec2 from, glm::ivec2 to, const glm::dvec3& color) {
  from = glm::max(from, glm::ivec2(0));
  to = glm::min(to, image.size);
  for (int y = from.y; y < to.y; ++y)
    for (int x = from.x; x < to.x; ++x) {
      std::uint8_t* const pixel = &image.rgba[4 * volume::Extent2{image.size}.index(x, y)];
      for (int i = 0; i < 3; ++i) pixel[i] = base::screenByte(color[i]);
      pixel[3] = 255;
    }
}

}  // namespace isolux::app
