#include "app/annotation/annotation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "app/annotation/ink.h"
#include "base/color.h"
#include "base/number_text.h"
#include "base/numbers.h"
#include "scene/rules/needs.h"
#include "volume/pieces/hidden_pieces.h"
#include "volume/pieces/piece_sets.h"
#include "volume/read/length_doubt.h"

namespace isolux::app {

namespace {

constexpr int kLowestWithLetters = 48, kLowestWithWords = 160;  // pixels
constexpr double kInvisible = 0.5 / 255.0;                      // an opacity that changes no pixel
constexpr double kBarPart = 0.175;                              // of the picture's height, at most

// Pixels, y down.
struct Box {
  glm::ivec2 low{0}, size{0};
  glm::ivec2 high() const { return low + size; }
};

bool meet(const Box& a, const Box& b, int gap) {
  return a.low.x < b.high().x + gap && b.low.x < a.high().x + gap && a.low.y < b.high().y + gap &&
         b.low.y < a.high().y + gap;
}

std::string valueText(double value, const std::string& unit) {
  std::string text = base::shortText(value, 5);
  if (text.starts_with('-')) text.replace(0, 1, "\u2212");
  return unit.empty() ? text : text + " " + unit;
}

// Places things on the picture one after the other, each clear of what stands there.
class AnnotationPainter {
 public:
  AnnotationPainter(const scene::Scene& resolved, const std::optional<render::Tile>& legend,
                    render::ColorImage& image)
      : scene_(resolved),
        image_(image),
        least_(std::min(image.size.x, image.size.y)),
        margin_(std::max(4, least_ / 48)),
        inks_{Ink(image.size), Ink(image.size)} {
    if (legend)  // from below
      taken_.push_back({{legend->origin.x, image.size.y - legend->origin.y - legend->size.y}, legend->size});
  }

  void drawLetters(const scene::EdgeLetters& letters) {
    const render::Font font(std::max(15, least_ / 26));
    const glm::ivec2 size = image_.size;
    const int height = font.ascent(), middle = (size.y - height) / 2;
    const auto width = [&](const std::string& text) { return font.width(text); };
    const auto centred = [&](const std::string& text) { return (size.x - width(text)) / 2; };
    const auto put = [&](const std::string& text, glm::ivec2 low, int axis) {
      if (!text.empty()) write(font, text, besideOthers({low, {width(text), height}}, axis));
    };
    put(letters.left, {margin_, middle}, 1);
    put(letters.right, {size.x - margin_ - width(letters.right), middle}, 1);
    put(letters.top, {centred(letters.top), margin_}, 0);
    put(letters.bottom, {centred(letters.bottom), size.y - margin_ - height}, 0);
  }

  void drawBar(const ScaleBar& bar) {
    const render::Font font(textPixels());
    const int length = static_cast<int>(std::lround(bar.pixels)), thick = std::max(2, font.ascent() / 6);
    const int tick = std::max(3, font.ascent() / 2), gap = std::max(3, font.ascent() / 2);
    const Box box = inCorner({std::max(length, font.width(bar.text)), font.ascent() + gap + tick}, false);
    const bool atRight = box.low.x > image_.size.x / 2;
    const int left = atRight ? box.high().x - length : box.low.x, bottom = box.high().y;
    Ink& ink = inkAt(box);
    ink.fill({left, bottom - thick}, {left + length, bottom});
    ink.fill({left, bottom - tick}, {left + thick, bottom});
    ink.fill({left + length - thick, bottom - tick}, {left + length, bottom});
    ink.text(font, bar.text,
             {atRight ? box.high().x - font.width(bar.text) : box.low.x, box.low.y + font.ascent()});
  }

  // "Isovalue 300 HU"; of several surfaces a line each, with its colour.
  void drawValues(const std::vector<ShownValue>& values) {
    const render::Font font(textPixels());
    const bool several = values.size() > 1 && !scene::isMeasure(scene_.look.mode);  // colours are to be seen
    const int chip = several ? font.ascent() : 0, indent = several ? chip + chip / 2 : 0;
    std::vector<std::string> lines;
    int width = 0;
    for (const ShownValue& value : values) {
      lines.push_back(several ? value.text : "Isovalue " + value.text);
      width = std::max(width, indent + font.width(lines.back()));
    }
    const int step = font.lineHeight();
    const Box box = inCorner({width, step * static_cast<int>(lines.size() - 1) + font.ascent()}, true);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const glm::ivec2 low = box.low + glm::ivec2(0, step * static_cast<int>(i));
      if (several) {
        inkAt(box).fill(low, low + chip);
        const int rim = std::max(1, chip / 8);
        chips_.push_back({{low + rim, glm::ivec2(chip - 2 * rim)}, values[i].color});
      }
      inkAt(box).text(font, lines[i], low + glm::ivec2(indent, font.ascent()));
    }
  }

  void drawCaveats(const std::vector<std::string>& lines) {
    const render::Font font(textPixels());
    int width = 0;
    for (const std::string& line : lines) width = std::max(width, font.width(line));
    const int step = font.lineHeight(), height = step * static_cast<int>(lines.size() - 1) + font.ascent();
    const Box box =
        aboveOthers({{image_.size.x - margin_ - width, image_.size.y - margin_ - height}, {width, height}});
    for (std::size_t i = 0; i < lines.size(); ++i)
      inkAt(box).text(
          font, lines[i],
          {box.high().x - font.width(lines[i]), box.low.y + step * static_cast<int>(i) + font.ascent()});
  }

  void blend() {
    const int rim = std::max(scene_.picture.transparent ? 2 : 1, least_ / 400);
    for (const bool bright : {false, true}) inks_[bright ? 1 : 0].blendOver(image_, rim, bright);
    for (const auto& [box, color] : chips_) drawChip(box, color);
  }

 private:
  int textPixels() const { return std::max(11, least_ / 42); }

  // In the left corner at the top or at the bottom; in the right one where the legend stands in that.
  Box inCorner(glm::ivec2 size, bool top) {
    const int y = top ? margin_ : image_.size.y - margin_ - size.y;
    const Box left{{margin_, y}, size}, right{{image_.size.x - margin_ - size.x, y}, size};
    taken_.push_back(isFree(left) || !isFree(right) ? left : right);
    return taken_.back();
  }

  // Moved up over what stands there already.
  Box aboveOthers(Box box) {
    for (const Box& other : std::vector<Box>(taken_))
      if (!isFree(box) && meet(box, other, margin_ / 2)) box.low.y = other.low.y - margin_ - box.size.y;
    taken_.push_back(box);
    return box;
  }

  // Moved along its edge of the picture where something stands already.
  Box besideOthers(const Box& wanted, int axis) {
    Box best = wanted;
    int least = image_.size[axis];
    if (!isFree(wanted)) {
      for (const Box& other : taken_) {
        for (const int at :
             {other.low[axis] - margin_ - wanted.size[axis] - 1, other.high()[axis] + margin_ + 1}) {
          Box moved = wanted;
          moved.low[axis] = at;
          const int far = std::abs(at - wanted.low[axis]);
          if (at < margin_ || at + wanted.size[axis] > image_.size[axis] - margin_ || far >= least ||
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

  bool isFree(const Box& box) const {
    return std::none_of(taken_.begin(), taken_.end(),
                        [&](const Box& other) { return meet(box, other, margin_ / 2); });
  }

  void write(const render::Font& font, const std::string& text, const Box& box) {
    inkAt(box).text(font, text, box.low + glm::ivec2(0, font.ascent()));
  }

  // As the window's: by the background there. At this luminance black and white have about the same contrast.
  Ink& inkAt(const Box& box) {
    constexpr double middle = 0.18;
    const double height =
        std::clamp(static_cast<double>(box.low.y + box.size.y / 2) / image_.size.y, 0.0, 1.0);
    const scene::Look& look = scene_.look;
    const bool environment = scene::usesGi(scene_) && scene_.light.environment.visible;
    const bool onBright = scene_.picture.transparent ||
                          (!environment && base::luminance(glm::mix(look.backgroundTop, look.backgroundBottom,
                                                                    height)) >= middle);
    return inks_[onBright ? 0 : 1];
  }

  void drawChip(const Box& box, const glm::dvec3& color) {
    for (int y = std::max(0, box.low.y); y < std::min(image_.size.y, box.high().y); ++y)
      for (int x = std::max(0, box.low.x); x < std::min(image_.size.x, box.high().x); ++x) {
        std::uint8_t* const pixel =
            &image_.rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.size.x) +
                              static_cast<std::size_t>(x))];
        for (int i = 0; i < 3; ++i) pixel[i] = base::screenByte(color[i]);
        pixel[3] = 255;
      }
  }

  const scene::Scene& scene_;
  render::ColorImage& image_;
  const int least_, margin_;
  std::array<Ink, 2> inks_;  // dark, bright
  std::vector<Box> taken_;
  std::vector<std::pair<Box, glm::dvec3>> chips_;
};

}  // namespace

std::optional<ScaleBar> scaleBarOf(const scene::CameraFrame& frame, double pictureHeight, double longest) {
  const bool perspective = frame.projection == scene::Projection::perspective;
  const double heightMm = 2.0 * frame.halfHeight * (perspective ? frame.distance : 1.0);
  const double pixelMm = heightMm / std::max(1.0, pictureHeight);
  if (!(pixelMm > 0.0) || !std::isfinite(pixelMm)) return std::nullopt;
  ScaleBar bar;
  bar.mm = base::niceBelow(longest * pixelMm);
  bar.pixels = bar.mm / pixelMm;
  bar.text = base::shortText(bar.mm) + " mm" + (perspective ? " at the centre" : "");
  return bar;
}

bool Annotation::empty() const {
  return letters.left.empty() && letters.right.empty() && letters.top.empty() && letters.bottom.empty() &&
         !scaleBar && values.empty() && caveats.empty();
}

std::vector<std::string> Caveats::lines() const {
  std::vector<std::string> result = invented;
  if (hidden > 0)
    result.push_back(std::to_string(hidden) + " of " + std::to_string(pieces) + " pieces hidden");
  return result;
}

Caveats caveatsOf(const scene::Scene& resolved, const volume::PreparedVolume& volume) {
  Caveats caveats{.invented = volume::inventedData(volume.volume.warnings)};
  if (!volume.volume.damage.empty()) caveats.invented.insert(caveats.invented.begin(), "parts missing");
  base::Progress unwatched;  // the body, where there is one, is known
  for (const volume::HiddenOfSurface& surface : volume::knownHidden(resolved, *volume.pieces)) {
    const auto pieces = volume.pieces->find(surface.isovalue, surface.inside);
    if (!pieces) continue;
    const std::vector<bool> shown = volume.pieces->shown(*pieces, resolved.pieces, unwatched);
    caveats.pieces += shown.size();
    caveats.hidden += static_cast<std::size_t>(std::count(shown.begin(), shown.end(), false));
  }
  return caveats;
}

Annotation annotationOf(const scene::Scene& resolved, const volume::PreparedVolume& volume, glm::ivec2 size) {
  Annotation annotation;
  const scene::CameraFrame frame = scene::frameOf(resolved.camera);
  if (resolved.picture.letters) annotation.letters = scene::edgeLetters(frame, volume.volume.axes);
  if (resolved.picture.scaleBar)
    annotation.scaleBar = scaleBarOf(frame, size.y, kBarPart * std::min(size.x, size.y));
  if (resolved.picture.caveats) annotation.caveats = caveatsOf(resolved, volume).lines();
  if (!resolved.picture.isovalue) return annotation;
  const auto add = [&](const std::optional<double>& value, const glm::dvec3& color, double opacity) {
    if (value && opacity >= kInvisible)
      annotation.values.push_back({valueText(*value, volume.volume.unit), color});
  };
  add(resolved.isosurface.value, resolved.isosurface.albedo, resolved.isosurface.opacity);
  for (const scene::ExtraIsosurface& extra : resolved.extraIsosurfaces)
    if (extra.shown) add(extra.value, extra.albedo, extra.opacity);
  return annotation;
}

void drawAnnotation(const Annotation& annotation, const scene::Scene& resolved,
                    const std::optional<render::Tile>& legend, render::ColorImage& image) {
  const int least = std::min(image.size.x, image.size.y);
  if (annotation.empty() || least < kLowestWithLetters) return;
  AnnotationPainter painter(resolved, legend, image);
  if (least >= kLowestWithWords) {
    if (annotation.scaleBar) painter.drawBar(*annotation.scaleBar);
    if (!annotation.values.empty()) painter.drawValues(annotation.values);
    if (!annotation.caveats.empty()) painter.drawCaveats(annotation.caveats);
  }
  painter.drawLetters(annotation.letters);
  painter.blend();
}

void annotate(const scene::Scene& resolved, const volume::PreparedVolume& volume,
              const render::FrameReport& report, render::ColorImage& image) {
  drawAnnotation(annotationOf(resolved, volume, image.size), resolved, report.legend, image);
}

}  // namespace isolux::app
