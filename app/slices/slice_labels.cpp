#include "app/slices/slice_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/annotation/ink.h"
#include "base/number_text.h"
#include "base/numbers.h"
#include "render/legend/font.h"

namespace isolux::app {

namespace {

constexpr int kLowestWithLetters = 48, kLowestWithWords = 160;  // pixels
constexpr double kAlongAxis = 1.0 - 1e-9;                       // cosine of a plane that is not oblique

std::string signedText(double value, int significant) {
  std::string text = base::shortText(value, significant);
  if (text == "-0") text = "0";
  if (text.starts_with('-')) text.replace(0, 1, "\u2212");
  return text;
}

std::string lengthText(double mm) {
  return signedText(std::round(mm * 100.0) / 100.0, 6);
}

void drawLetters(const SliceLetters& letters, const render::Font& font, int margin, Ink& ink,
                 glm::ivec2 size) {
  const int middle = (size.y + font.ascent()) / 2;
  const auto centered = [&](const std::string& text) { return (size.x - font.width(text)) / 2; };
  ink.text(font, letters.left, {margin, middle});
  ink.text(font, letters.right, {size.x - margin - font.width(letters.right), middle});
  ink.text(font, letters.top, {centered(letters.top), margin + font.ascent()});
  ink.text(font, letters.bottom, {centered(letters.bottom), size.y - margin});
}

void drawRuler(const Ruler& ruler, const render::Font& font, int margin, Ink& ink, glm::ivec2 size) {
  const int length = static_cast<int>(std::lround(ruler.pixels)), thick = std::max(2, font.ascent() / 6);
  const int right = size.x - margin, bottom = size.y - margin, tick = font.ascent() / 2;
  ink.fill({right - length, bottom - thick}, {right, bottom});
  ink.fill({right - length, bottom - tick}, {right - length + thick, bottom});
  ink.fill({right - thick, bottom - tick}, {right, bottom});
  ink.text(font, ruler.text,
           {right - (length + font.width(ruler.text)) / 2, bottom - tick - font.ascent() / 3});
}

}  // namespace

SliceLetters lettersOf(const volume::SlicePlane& plane, scene::WorldAxes axes) {
  const volume::SliceFrame frame = plane.frame();
  return {scene::axisEnd(axes, -frame.right), scene::axisEnd(axes, frame.right),
          scene::axisEnd(axes, -frame.down), scene::axisEnd(axes, frame.down)};
}

std::string placeText(const volume::SlicePlane& plane, scene::WorldAxes axes) {
  constexpr std::array<const char*, 3> names{"sagittal", "coronal", "axial"};
  const glm::dvec3 normal = plane.frame().normal();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(normal[axis]) < kAlongAxis) continue;
    const double mm = plane.originMm[axis];
    const std::string name = names[static_cast<std::size_t>(axis)];
    if (axes == scene::WorldAxes::anatomical)
      return name + " \u00b7 " + scene::axisEnd(axes, axis, mm >= 0.0) + " " + lengthText(std::abs(mm)) +
             " mm";
    constexpr std::array<const char*, 3> planes{"YZ", "XZ", "XY"};  // who knows where the patient's feet are?
    return std::string(planes[static_cast<std::size_t>(axis)]) + " \u00b7 " + "xyz"[axis] + " = " +
           lengthText(mm) + " mm";
  }
  const glm::dvec3 middle = plane.at(0.5 * glm::dvec2(plane.size - 1));
  const auto list = [](glm::dvec3 v) {
    return lengthText(v.x) + ", " + lengthText(v.y) + ", " + lengthText(v.z);
  };
  return "oblique\nthrough " + list(middle) + " mm\nacross " + list(normal);
}

std::string conventionText(scene::Convention convention, scene::WorldAxes axes) {
  if (axes != scene::WorldAxes::anatomical) return "orientation not stated";
  return convention == scene::Convention::radiological ? "radiological" : "neurological";
}

std::string windowText(const SliceContent& content, const scene::Slice& slice, const std::string& unit) {
  std::string text = "level " + signedText(content.window.level, 4) + " \u00b7 width " +
                     base::shortText(content.window.width, 4) + (unit.empty() ? "" : " " + unit);
  if (slice.slab > 0.0) {
    constexpr std::array<const char*, 3> modes{"mean", "maximum", "minimum"};
    text += std::string(" \u00b7 ") + modes[static_cast<std::size_t>(slice.slabMode)] + " of " +
            lengthText(slice.slab) + " mm";
  }
  return text;
}

Ruler rulerOf(const volume::SlicePlane& plane) {
  Ruler ruler;
  const double pixel = plane.pixelMm();
  ruler.mm = base::niceBelow(0.2 * plane.size.x * pixel);
  ruler.pixels = ruler.mm / pixel;
  ruler.text = base::shortText(ruler.mm, 6) + " mm";
  return ruler;
}

void drawWords(const SliceWords& words, render::ColorImage& image, double pixelRatio) {
  const auto atLeast = [&](int pixels) {
    return static_cast<int>(std::lround(pixels * std::max(1.0, pixelRatio)));
  };
  if (image.size.y < kLowestWithLetters || image.size.x < kLowestWithLetters) return;
  const int least = std::min(image.size.x, image.size.y);
  const int margin = std::clamp(least / 48, 4, 40);
  Ink ink(image.size);
  const render::Font large(std::max(std::clamp(least / 22, 15, 96), atLeast(15)));
  drawLetters(words.letters, large, margin, ink, image.size);
  if (least >= kLowestWithWords) {
    const render::Font small(std::max(std::clamp(least / 40, 11, 64), atLeast(11)));
    std::istringstream lines(words.place + '\n' + words.convention);
    int baseline = margin + small.ascent();
    for (std::string text; std::getline(lines, text); baseline += small.lineHeight())
      ink.text(small, text, {margin, baseline});
    ink.text(small, words.window, {margin, image.size.y - margin});
    drawRuler(words.ruler, small, margin, ink, image.size);
  }
  ink.blendOver(image, least >= 400 ? 2 : 1);
}

}  // namespace isolux::app
