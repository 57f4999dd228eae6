#include "render/legend/legend.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>

#include "base/color.h"
#include "render/legend/font.h"
#include "volume/voxels/extent.h"

namespace isolux::render {

namespace {

// Values as they are encoded, 0..1. A dark glass panel with bright text reads on light and dark pictures
// alike.
constexpr glm::vec3 panelColor{0.07f, 0.075f, 0.085f}, textColor{0.93f}, frameColor{0.75f};
constexpr float panelAlpha = 0.72f;

class Canvas {
 public:
  explicit Canvas(glm::ivec2 size) : size_(size), pixels_(volume::Extent2{size}.count()) {}

  void over(glm::ivec2 p, const glm::vec3& color, float alpha) {
    const volume::Extent2 extent{size_};
    if (!extent.contains(p)) return;
    Pixel& pixel = pixels_[extent.index(p)];
    pixel.color = color * alpha + pixel.color * (1.0f - alpha);
    pixel.alpha = alpha + pixel.alpha * (1.0f - alpha);
  }
  void fill(glm::ivec2 from, glm::ivec2 to, const glm::vec3& color) {  // `to` excluded
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x) over({x, y}, color, 1.0f);
  }
  void frame(glm::ivec2 from, glm::ivec2 to, int width) {  // around [from, to)
    fill({from.x - width, from.y - width}, {to.x + width, from.y}, frameColor);
    fill({from.x - width, to.y}, {to.x + width, to.y + width}, frameColor);
    fill({from.x - width, from.y}, {from.x, to.y}, frameColor);
    fill({to.x, from.y}, {to.x + width, to.y}, frameColor);
  }
  // The panel: the whole canvas with rounded, antialiased corners.
  void panel(float radius) {
    const glm::vec2 half = glm::vec2(size_) * 0.5f;
    for (int y = 0; y < size_.y; ++y)
      for (int x = 0; x < size_.x; ++x) {
        const glm::vec2 beyond =
            glm::max(glm::abs(glm::vec2(x, y) + 0.5f - half) - (half - glm::vec2(radius)), glm::vec2(0.0f));
        const float outside = std::hypot(beyond.x, beyond.y) - radius;
        over({x, y}, panelColor, panelAlpha * glm::clamp(0.5f - outside, 0.0f, 1.0f));
      }
  }
  void text(const Font& font, const std::string& text, glm::ivec2 origin) {
    font.draw(text, origin, [this](glm::ivec2 p, int coverage) {
      over(p, textColor, static_cast<float>(coverage) / 255.0f);
    });
  }
  LegendImage image() const {
    LegendImage image{size_, {}};
    image.rgba.reserve(pixels_.size() * 4);
    const auto byte = [](float v) { return static_cast<std::uint8_t>(std::lround(v * 255.0f)); };
    for (const Pixel& p : pixels_)
      image.rgba.insert(image.rgba.end(), {byte(p.color.x), byte(p.color.y), byte(p.color.z), byte(p.alpha)});
    return image;
  }

 private:
  struct Pixel {
    glm::vec3 color{0.0f};  // premultiplied
    float alpha = 0.0f;
  };
  glm::ivec2 size_;
  std::vector<Pixel> pixels_;
};

glm::vec3 encoded(const glm::vec3& linear) {
  glm::vec3 result;
  for (int c = 0; c < 3; ++c)
    result[c] = static_cast<float>(base::encodeSrgb(static_cast<double>(linear[c])));
  return result;
}

// All lengths follow the text's size.
struct Measures {
  int text, line, pad, gap, tick, bar;
  explicit Measures(int pictureHeight)
      : text(std::clamp(pictureHeight / 36, 9, 60)),
        line(std::max(1, text / 14)),
        pad(text * 7 / 10),
        gap(text * 4 / 10),
        tick(std::max(2, text * 3 / 10)),
        bar(text * 11 / 10) {}
};

struct Ticks {
  std::vector<double> values, places;  // places: 0 at the low end of the axis, 1 at the high end
  std::vector<std::string> texts;
  TickFormat format;
  Ticks(const Legend& legend, int count) {
    const double low = legend.low, high = legend.high;
    values = legend.logarithmic ? logarithmicTicks(low, high) : tickValues(low, high, count);
    if (!legend.logarithmic) format = tickFormat(values);
    const bool powers = areShownAsPowers(values);
    for (const double value : values) {
      texts.push_back(legend.logarithmic ? logarithmicTickText(value, powers) : tickText(value, format));
      places.push_back(high == low          ? 0.5
                       : legend.logarithmic ? std::log(value / low) / std::log(high / low)
                                            : (value - low) / (high - low));
    }
  }
  int width(const Font& font) const {
    int widest = 0;
    for (const std::string& text : texts) widest = std::max(widest, font.width(text));
    return widest;
  }
};

// Pixels from the low end of an axis of `length` pixels.
int along(double place, int length) {
  return static_cast<int>(std::lround(place * (length - 1)));
}

// The lines below: what they take, and themselves in a panel of that height.
struct LinesBelow {
  const Legend& legend;
  const Measures& m;
  const Font& font;

  int sample() const { return legend.hatched.empty() ? 0 : 2 * m.bar + m.gap; }
  int width() const {
    int widest = font.width(legend.note);
    for (const std::string& line : legend.hatched) widest = std::max(widest, sample() + font.width(line));
    return widest;
  }
  int height() const {
    const int lines = (legend.note.empty() ? 0 : 1) + static_cast<int>(legend.hatched.size());
    return lines == 0 ? 0 : m.gap + lines * font.lineHeight();
  }
  void draw(Canvas& canvas, int panelHeight) const {
    int top = panelHeight - m.pad - height() + m.gap;
    if (!legend.note.empty()) {
      canvas.text(font, legend.note, {m.pad, top + font.ascent()});
      top += font.lineHeight();
    }
    if (!legend.hatched.empty()) drawSample(canvas, {m.pad, top});
    for (const std::string& line : legend.hatched) {
      canvas.text(font, line, {m.pad + sample(), top + font.ascent()});
      top += font.lineHeight();
    }
  }

 private:
  void drawSample(Canvas& canvas, glm::ivec2 low) const {
    const glm::ivec2 size(2 * m.bar, font.ascent() + 2 * m.line);
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const Hatch hatch = hatchAt({x, y}, std::max(1, m.text / 7));
        const float grey = hatch == Hatch::none ? 0.5f : hatch == Hatch::dark ? kHatchDark : kHatchBright;
        canvas.over(low + glm::ivec2(x, y), glm::vec3(grey), 1.0f);
      }
  }
};

// Pixels are left out where only the size is asked for.
enum class Want { size, image };

// What is said, without colours.
LegendImage drawLines(const Legend& legend, int pictureHeight, Want want) {
  const Measures m(pictureHeight);
  const Font font(m.text);
  const LinesBelow below{legend, m, font};
  const glm::ivec2 size(2 * m.pad + std::max(font.width(legend.quantity), below.width()),
                        2 * m.pad + font.lineHeight() + below.height());
  if (want == Want::size) return {size, {}};
  Canvas canvas(size);
  canvas.panel(static_cast<float>(m.pad) * 0.8f);
  canvas.text(font, legend.quantity, {m.pad, m.pad + font.ascent()});
  below.draw(canvas, size.y);
  return canvas.image();
}

LegendImage drawBar(const Legend& legend, int pictureHeight, Want want) {
  const Measures m(pictureHeight);
  const Font font(m.text);
  const int length = std::max(pictureHeight * 30 / 100, 4 * m.text);
  const Ticks ticks(legend, std::clamp(length / (3 * m.text) + 1, 2, 7));
  const LinesBelow below{legend, m, font};
  const std::string title = axisTitle(legend.quantity, legend.unit, ticks.format.exponent);

  const int beside = m.bar + m.line + m.tick + m.gap + ticks.width(font);
  const int widest = std::max({font.width(title), beside + 2 * m.line, below.width()});
  const glm::ivec2 size(2 * m.pad + widest, 2 * m.pad + font.lineHeight() + m.gap + m.line + length +
                                                m.text / 2 + below.height());
  if (want == Want::size) return {size, {}};
  Canvas canvas(size);
  canvas.panel(static_cast<float>(m.pad) * 0.8f);
  below.draw(canvas, size.y);
  canvas.text(font, title, {m.pad, m.pad + font.ascent()});
  const glm::ivec2 top(m.pad + m.line, m.pad + font.lineHeight() + m.gap);
  canvas.frame(top, top + glm::ivec2(m.bar, length), m.line);
  const auto last = static_cast<double>(legend.colors.size() - 1);
  for (int y = 0; y < length; ++y) {
    const double t = static_cast<double>(length - 1 - y) / (length - 1);
    const auto color = encoded(legend.colors[static_cast<std::size_t>(std::lround(t * last))]);
    canvas.fill(top + glm::ivec2(0, y), top + glm::ivec2(m.bar, y + 1), color);
  }
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const int y = top.y + length - 1 - along(ticks.places[i], length);
    const int x = top.x + m.bar + m.line;
    canvas.fill({x, y - m.line / 2}, {x + m.tick, y - m.line / 2 + m.line}, frameColor);
    canvas.text(font, ticks.texts[i], {x + m.tick + m.gap, y + font.ascent() / 2 + 1});
  }
  return canvas.image();
}

// kappa1 >= kappa2: only the half on and below the diagonal is coloured.
void drawTriangle(Canvas& canvas, const Legend& legend, glm::ivec2 top, int length) {
  const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(legend.colors.size()))));
  const auto texel = [&](int pixel) { return std::min(pixel * side / length, side - 1); };
  for (int y = 0; y < length; ++y)
    for (int x = 0; x < length; ++x) {
      const float covered = glm::clamp(static_cast<float>(x - (length - 1 - y)) + 0.5f, 0.0f, 1.0f);
      const auto at = static_cast<std::size_t>(texel(length - 1 - y)) * static_cast<std::size_t>(side) +
                      static_cast<std::size_t>(texel(x));
      canvas.over(top + glm::ivec2(x, y), encoded(legend.colors[at]), covered);
    }
}

LegendImage drawSquare(const Legend& legend, int pictureHeight, Want want) {
  const Measures m(pictureHeight);
  const Font font(m.text);
  const int length = std::max(pictureHeight * 20 / 100, 6 * m.text);
  const Ticks ticks(legend, 4);
  const LinesBelow lines{legend, m, font};
  const std::string vertical = axisTitle(legend.quantityVertical, legend.unit, ticks.format.exponent);
  const std::string horizontal = axisTitle(legend.quantity, legend.unit, ticks.format.exponent);

  const int left = m.pad + ticks.width(font) + m.gap + m.tick + m.line;
  const int rightOverhang = font.width(ticks.texts.back()) / 2;
  const glm::ivec2 top(left, m.pad + font.lineHeight() + m.gap);
  const int below = top.y + length + m.line + m.tick + m.gap;
  const glm::ivec2 size(
      std::max({left + std::max(length + m.line, length - 1 + rightOverhang), m.pad + font.width(vertical),
                m.pad + lines.width()}) +
          m.pad,
      below + font.lineHeight() + m.gap + font.lineHeight() + m.pad - m.gap + lines.height());
  if (want == Want::size) return {size, {}};
  Canvas canvas(size);
  canvas.panel(static_cast<float>(m.pad) * 0.8f);
  lines.draw(canvas, size.y);
  canvas.text(font, vertical, {m.pad, m.pad + font.ascent()});
  drawTriangle(canvas, legend, top, length);
  canvas.frame(top, top + glm::ivec2(length), m.line);
  int written = 0;  // x up to which the horizontal axis has its numbers
  for (std::size_t i = 0; i < ticks.values.size(); ++i) {
    const int at = along(ticks.places[i], length), w = font.width(ticks.texts[i]);
    const int y = top.y + length - 1 - at, x = top.x + at;
    canvas.fill({top.x - m.line - m.tick, y - m.line / 2}, {top.x - m.line, y - m.line / 2 + m.line},
                frameColor);
    canvas.text(font, ticks.texts[i], {top.x - m.line - m.tick - m.gap - w, y + font.ascent() / 2 + 1});
    canvas.fill({x - m.line / 2, top.y + length + m.line},
                {x - m.line / 2 + m.line, top.y + length + m.line + m.tick}, frameColor);
    if (x - w / 2 < written) continue;  // no room between its neighbours
    canvas.text(font, ticks.texts[i], {x - w / 2, below + font.ascent()});
    written = x - w / 2 + w + m.text / 3;
  }
  canvas.text(
      font, horizontal,
      {top.x + (length - font.width(horizontal)) / 2, below + font.lineHeight() + m.gap + font.ascent()});
  return canvas.image();
}

LegendImage legendOf(const Legend& legend, int pictureHeight, Want want) {
  if (legend.colors.empty()) return drawLines(legend, pictureHeight, want);
  assert(std::isfinite(legend.low) && std::isfinite(legend.high) && legend.colors.size() >= 2);
  return legend.quantityVertical.empty() ? drawBar(legend, pictureHeight, want)
                                         : drawSquare(legend, pictureHeight, want);
}

LegendImage legendFor(const Legend& legend, glm::ivec2 picture, Want want) {
  constexpr int readable = 36 * 9;  // the height whose text is smallest
  int height = std::min(picture.y, 2 * picture.x);
  glm::ivec2 size = legendOf(legend, height, Want::size).size;
  const auto takes = [&](double width, double height) {
    return size.x > width * picture.x || size.y > height * picture.y;
  };
  while (takes(0.4, 0.5) && height > readable) {
    height = std::max(readable, height - std::max(36, height / 12));
    size = legendOf(legend, height, Want::size).size;
  }
  return takes(0.65, 0.65) ? LegendImage{} : legendOf(legend, height, want);
}

}  // namespace

LegendImage drawLegend(const Legend& legend, int pictureHeight) {
  return legendOf(legend, pictureHeight, Want::image);
}

LegendImage legendFor(const Legend& legend, glm::ivec2 picture) {
  return legendFor(legend, picture, Want::image);
}

glm::ivec2 legendSizeFor(const Legend& legend, glm::ivec2 picture) {
  return legendFor(legend, picture, Want::size).size;
}

Hatch hatchAt(glm::ivec2 pixel, int lineWidth) {
  const int phase = (pixel.x + pixel.y) % (4 * lineWidth) / lineWidth;
  return phase == 0 ? Hatch::dark : phase == 1 ? Hatch::bright : Hatch::none;
}

}  // namespace isolux::render
