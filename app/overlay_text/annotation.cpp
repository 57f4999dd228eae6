#include "app/overlay_text/annotation.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "app/overlay_text/annotation_layout.h"
#include "app/overlay_text/ink.h"
#include "base/color.h"
#include "base/number_text.h"
#include "base/numbers.h"
#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"
#include "volume/pieces/piece_sets.h"
#include "volume/read/input/spacing_reliability.h"
#include "volume/visible/hidden_pieces.h"

namespace isolux::app {

namespace {

constexpr double kInvisible = 0.5 / 255.0;  // an opacity that changes no pixel

std::string valueText(double value, const std::string& unit) {
  std::string text = base::shortText(value, 5);
  if (text.starts_with('-')) text.replace(0, 1, "\u2212");
  return unit.empty() ? text : text + " " + unit;
}

// Writes things on the picture one after the other.
class AnnotationPainter {
 public:
  AnnotationPainter(const scene::Scene& resolved, const std::optional<render::Tile>& legend,
                    render::ColorImage& image)
      : scene_(resolved),
        image_(image),
        least_(std::min(image.size.x, image.size.y)),
        layout_(image.size),
        inks_{Ink(image.size), Ink(image.size)} {
    if (legend)  // from below
      layout_.take({{legend->origin.x, image.size.y - legend->origin.y - legend->size.y}, legend->size});
  }

  void drawLetters(const scene::EdgeLetters& letters) {
    const std::array<PixelBox, 4> boxes = layout_.letters(letters);
    const std::array<const std::string*, 4> texts{&letters.left, &letters.right, &letters.top,
                                                  &letters.bottom};
    for (std::size_t i = 0; i < boxes.size(); ++i)
      inkAt(boxes[i]).text(layout_.letterFont(), *texts[i],
                           boxes[i].low + glm::ivec2(0, layout_.letterFont().ascent()));
  }

  void drawBar(const ScaleBar& bar) {
    const render::Font& font = layout_.textFont();
    const int length = static_cast<int>(std::lround(bar.pixels)), thick = std::max(2, font.ascent() / 6);
    const int tick = std::max(3, font.ascent() / 2);
    const PixelBox box = layout_.bar(bar);
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
    const render::Font& font = layout_.textFont();
    const bool several = areKeyed(values, scene_);
    const int chip = font.ascent(), step = font.lineHeight();
    const PixelBox box = layout_.values(values, several);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const glm::ivec2 low = box.low + glm::ivec2(0, step * static_cast<int>(i));
      if (several) {
        inkAt(box).fill(low, low + chip);
        const int rim = std::max(1, chip / 8);
        chips_.push_back({{low + rim, glm::ivec2(chip - 2 * rim)}, values[i].color});
      }
      inkAt(box).text(font, lineOf(values[i], several),
                      low + glm::ivec2(layout_.indent(several), font.ascent()));
    }
  }

  void drawCaveats(const std::vector<std::string>& lines) {
    const render::Font& font = layout_.textFont();
    const PixelBox box = layout_.caveats(layout_.textSize(lines));
    for (std::size_t i = 0; i < lines.size(); ++i)
      inkAt(box).text(font, lines[i],
                      {box.high().x - font.width(lines[i]),
                       box.low.y + font.lineHeight() * static_cast<int>(i) + font.ascent()});
  }

  void blend() {
    const int rim = std::max(scene_.picture.transparent ? 2 : 1, least_ / 400);
    for (const bool bright : {false, true}) inks_[bright ? 1 : 0].blendOver(image_, rim, bright);
    for (const auto& [box, color] : chips_) fillWith(image_, box.low, box.high(), color);
  }

 private:
  // As the window's: by the background there. At this luminance black and white have about the same contrast.
  Ink& inkAt(const PixelBox& box) {
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

  const scene::Scene& scene_;
  render::ColorImage& image_;
  const int least_;
  AnnotationLayout layout_;
  std::array<Ink, 2> inks_;  // dark, bright
  std::vector<std::pair<PixelBox, glm::dvec3>> chips_;
};

}  // namespace

std::optional<ScaleBar> scaleBarOf(const scene::CameraFrame& frame, double pictureHeight, double longest) {
  const bool perspective = frame.projection == scene::Projection::perspective;
  const double heightMm = 2.0 * frame.halfHeight * (perspective ? frame.distance : 1.0);
  const double pixelMm = heightMm / std::max(1.0, pictureHeight);
  if (!(pixelMm > 0.0) || !std::isfinite(pixelMm)) return std::nullopt;
  const double mm = base::niceBelow(longest * pixelMm);
  return ScaleBar{mm, mm / pixelMm, base::shortText(mm) + " mm" + (perspective ? " at the centre" : "")};
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
    caveats.hidden += static_cast<std::size_t>(std::ranges::count(shown, false));
  }
  return caveats;
}

Annotation annotationOf(const scene::Scene& resolved, const volume::PreparedVolume& volume, glm::ivec2 size) {
  Annotation annotation;
  const scene::CameraFrame frame = scene::frameOf(resolved.camera);
  if (resolved.picture.letters) annotation.letters = scene::edgeLetters(frame, volume.volume.axes);
  if (resolved.picture.scaleBar)
    annotation.scaleBar = scaleBarOf(frame, size.y, AnnotationLayout::longestBar(size));
  if (resolved.picture.caveats) annotation.caveats = caveatsOf(resolved, volume).lines();
  if (!resolved.picture.isovalue) return annotation;
  for (const auto& surface : scene::shownSurfaces(resolved))
    if (surface.value && surface.opacity >= kInvisible)
      annotation.values.push_back({valueText(*surface.value, volume.volume.unit), surface.albedo});
  return annotation;
}

void drawAnnotation(const Annotation& annotation, const scene::Scene& resolved,
                    const std::optional<render::Tile>& legend, render::ColorImage& image) {
  if (annotation.empty() || !AnnotationLayout::hasLetters(image.size)) return;
  AnnotationPainter painter(resolved, legend, image);
  if (AnnotationLayout::hasTexts(image.size)) {
    if (annotation.scaleBar) painter.drawBar(*annotation.scaleBar);
    if (!annotation.values.empty()) painter.drawValues(annotation.values);
    if (!annotation.caveats.empty()) painter.drawCaveats(annotation.caveats);
  }
  painter.drawLetters(annotation.letters);
  painter.blend();
}

void annotate(const scene::Scene& resolved, const volume::PreparedVolume& volume,
              const render::FrameReport& report, render::ColorImage& image) {
  Annotation annotation = annotationOf(resolved, volume, image.size);
  if (resolved.picture.caveats && resolved.look.overlay == scene::WorkOverlay::bricks && !report.bricks.inUse)
    annotation.caveats.emplace_back("nothing is held in bricks");
  drawAnnotation(annotation, resolved, report.legend, image);
}

}  // namespace isolux::app
