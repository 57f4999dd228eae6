#include "app/slices/slice_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/overlay_text/free_places.h"
#include "app/overlay_text/ink.h"
#include "base/number_text.h"
#include "base/numbers.h"
#include "render/legend/font.h"
#include "scene/settings/choice_names.h"

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

// Sizes of what is written, by the size of the picture.
struct Measures {
  int margin;
  render::Font large, small;
  Measures(glm::ivec2 size, double pixelRatio)
      : margin(std::clamp(std::min(size.x, size.y) / 48, 4, 40)),
        large(textPixels(size, pixelRatio, 22, 15, 96)),
        small(textPixels(size, pixelRatio, 40, 11, 64)) {}

  static int textPixels(glm::ivec2 size, double pixelRatio, int part, int least, int most) {
    const int onScreen = static_cast<int>(std::lround(least * std::max(1.0, pixelRatio)));
    return std::max(std::clamp(std::min(size.x, size.y) / part, least, most), onScreen);
  }
};

// Broken between words where it is wider than that.
std::vector<std::string> wrapped(const std::string& text, const render::Font& font, int width) {
  std::vector<std::string> result;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string now;
    for (std::string word; words >> word;) {
      const std::string longer = now.empty() ? word : now + ' ' + word;
      if (!now.empty() && font.width(longer) > width) {
        result.push_back(now);
        now = word;
      } else {
        now = longer;
      }
    }
    if (!now.empty()) result.push_back(now);
  }
  return result;
}

// Lines one below the other, the first at `low`.
std::vector<WrittenText> stacked(const std::vector<std::string>& lines, const render::Font& font,
                                 glm::ivec2 low) {
  std::vector<WrittenText> result;
  for (const std::string& line : lines) {
    result.push_back({line, {glm::dvec2(low), glm::dvec2(font.width(line), font.ascent())}});
    low.y += font.lineHeight();
  }
  return result;
}

void drawRuler(const ScaleBar& ruler, const render::Font& font, int margin, Ink& ink, glm::ivec2 size) {
  const int length = static_cast<int>(std::lround(ruler.pixels)), thick = std::max(2, font.ascent() / 6);
  const int right = size.x - margin, bottom = size.y - margin, tick = font.ascent() / 2;
  ink.fill({right - length, bottom - thick}, {right, bottom});
  ink.fill({right - length, bottom - tick}, {right - length + thick, bottom});
  ink.fill({right - thick, bottom - tick}, {right, bottom});
}

// The ruler's text above it; its box has the ruler, too.
std::pair<WrittenText, TextBox> rulerBoxes(const ScaleBar& ruler, const render::Font& font, int margin,
                                           glm::ivec2 size) {
  const int length = static_cast<int>(std::lround(ruler.pixels)), tick = font.ascent() / 2;
  const int wide = font.width(ruler.text), right = size.x - margin,
            top = size.y - margin - tick - font.ascent() / 3 - font.ascent();
  const int left = std::min(right - (length + wide) / 2, right - wide);
  const int leftmost = std::min(left, right - length);
  return {{ruler.text, {glm::dvec2(left, top), glm::dvec2(wide, font.ascent())}},
          {glm::dvec2(leftmost, top), glm::dvec2(right - leftmost, size.y - margin - top)}};
}

int keyIndent(const render::Font& font) {
  return font.ascent() + font.ascent() / 2;
}

// Lines one below the other that end at the right margin. None where there is no room.
std::vector<WrittenText> placedKey(const std::vector<ShownValue>& key, const Measures& m, glm::ivec2 size,
                                   FreePlaces& free) {
  if (key.empty()) return {};
  int wide = 0;
  for (const ShownValue& line : key) wide = std::max(wide, keyIndent(m.small) + m.small.width(line.text));
  const int high = m.small.ascent() + m.small.lineHeight() * (static_cast<int>(key.size()) - 1);
  const auto box = free.place({glm::dvec2(size.x - m.margin - wide, m.margin), glm::dvec2(wide, high)}, 1);
  std::vector<WrittenText> lines;
  for (std::size_t i = 0; box && i < key.size(); ++i)
    lines.push_back({key[i].text,
                     {box->low + glm::dvec2(0.0, static_cast<double>(i) * m.small.lineHeight()),
                      glm::dvec2(wide, m.small.ascent())}});
  return lines;
}

struct PlacedWords {
  SliceWordPlaces places;
  int crowded = 0;  // letters that no place is free for
};

PlacedWords placedWords(const SliceWords& words, glm::ivec2 size, const Measures& m, bool withKey) {
  PlacedWords result;
  SliceWordPlaces& places = result.places;
  FreePlaces free({glm::dvec2(m.margin), glm::dvec2(size - 2 * m.margin)}, std::max(2, m.margin / 2));
  const auto take = [&](std::vector<WrittenText> texts) {
    for (WrittenText& text : texts) {
      free.take(text.box);
      places.texts.push_back(std::move(text));
    }
  };
  if (std::min(size.x, size.y) >= kLowestWithWords) {
    auto [text, box] = rulerBoxes(words.ruler, m.small, m.margin, size);
    free.take(box);
    places.texts.push_back(std::move(text));
    const int wide = size.x - 2 * m.margin;
    take(stacked(wrapped(words.place + '\n' + words.convention, m.small, wide), m.small,
                 glm::ivec2(m.margin)));
    const int beside = static_cast<int>(box.low.x) - 2 * m.margin - m.small.ascent();
    const std::vector<std::string> lines = wrapped(words.window, m.small, beside);
    const int high = m.small.ascent() + m.small.lineHeight() * (static_cast<int>(lines.size()) - 1);
    take(stacked(lines, m.small, {m.margin, size.y - m.margin - high}));
    if (withKey) places.key = placedKey(words.key, m, size, free);
  }
  const int high = m.large.ascent();
  const auto letter = [&](const std::string& text, glm::dvec2 part, int axis) {  // of the room there is
    const glm::dvec2 extent(m.large.width(text), high), room = glm::dvec2(size - 2 * m.margin) - extent;
    const TextBox wanted{glm::floor(glm::dvec2(m.margin) + part * room), extent};
    const std::optional<TextBox> box = free.place(wanted, axis);
    result.crowded += box ? 0 : 1;
    return WrittenText{text, box.value_or(wanted)};
  };
  const SliceLetters& letters = words.letters;
  places.letters = {letter(letters.left, {0.0, 0.5}, 1), letter(letters.right, {1.0, 0.5}, 1),
                    letter(letters.top, {0.5, 0.0}, 0), letter(letters.bottom, {0.5, 1.0}, 0)};
  return result;
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

bool showsLeftAndRight(const SliceLetters& letters) {
  return (letters.left + letters.right + letters.top + letters.bottom).find_first_of("LR") !=
         std::string::npos;
}

std::string windowText(const SliceContent& content, const scene::Slice& slice, const std::string& unit) {
  if (content.labels) return "labels of the nearest voxels";
  std::string text = "level " + signedText(content.window.level, 4) + " \u00b7 width " +
                     base::shortText(content.window.width, 4) + (unit.empty() ? "" : " " + unit);
  if (slice.slab > 0.0)
    text +=
        " \u00b7 " + std::string(scene::choiceName(slice.slabMode)) + " of " + lengthText(slice.slab) + " mm";
  return text;
}

ScaleBar rulerOf(const volume::SlicePlane& plane) {
  const double pixel = plane.pixelMm(), mm = base::niceBelow(0.2 * plane.size.x * pixel);
  return {mm, mm / pixel, base::shortText(mm, 6) + " mm"};
}

SliceWords wordsOf(const SliceContent& content, const volume::SlicePlane& plane, const scene::Slice& slice,
                   const volume::Volume& volume) {
  SliceWords words;
  words.letters = lettersOf(plane, volume.axes);
  words.place = placeText(plane, volume.axes);
  if (volume.axes != scene::WorldAxes::anatomical || showsLeftAndRight(words.letters))
    words.convention = conventionText(slice.convention, volume.axes);
  words.window = windowText(content, slice, volume.unit);
  words.ruler = rulerOf(plane);
  if (slice.contourWidth > 0.0 && !content.labels)
    for (const SurfaceOnSlice& surface : content.surfaces)
      words.key.push_back(
          {signedText(surface.isovalue, 5) + (volume.unit.empty() ? "" : " " + volume.unit), surface.color});
  return words;
}

SliceWordPlaces placesOf(const SliceWords& words, glm::ivec2 size, double pixelRatio) {
  if (size.y < kLowestWithLetters || size.x < kLowestWithLetters) return {};
  const Measures m(size, pixelRatio);
  PlacedWords with = placedWords(words, size, m, true), without = placedWords(words, size, m, false);
  return with.crowded > without.crowded ? without.places : with.places;
}

glm::dvec2 letterBorder(const SliceLetters& letters, glm::ivec2 size, double pixelRatio) {
  const Measures m(size, pixelRatio);
  const int wide = std::max(m.large.width(letters.left), m.large.width(letters.right));
  return glm::dvec2(2 * m.margin) + glm::dvec2(wide, m.large.ascent());
}

void drawWords(const SliceWords& words, render::ColorImage& image, double pixelRatio) {
  if (image.size.y < kLowestWithLetters || image.size.x < kLowestWithLetters) return;
  const int least = std::min(image.size.x, image.size.y);
  const Measures m(image.size, pixelRatio);
  const SliceWordPlaces places = placesOf(words, image.size, pixelRatio);
  Ink ink(image.size);
  const auto write = [&](const WrittenText& text, const render::Font& font) {
    ink.text(font, text.text, glm::ivec2(text.box.low) + glm::ivec2(0, font.ascent()));
  };
  for (const WrittenText& letter : places.letters) write(letter, m.large);
  for (const WrittenText& text : places.texts) write(text, m.small);
  if (least >= kLowestWithWords) drawRuler(words.ruler, m.small, m.margin, ink, image.size);
  const int sample = m.small.ascent();
  for (const WrittenText& line : places.key) {
    const glm::ivec2 low(line.box.low);
    ink.fill(low, low + sample);
    ink.text(m.small, line.text, low + glm::ivec2(keyIndent(m.small), sample));
  }
  ink.blendOver(image, least >= 400 ? 2 : 1);
  const int rim = std::max(1, sample / 8);
  for (std::size_t i = 0; i < places.key.size(); ++i) {
    const glm::ivec2 low(places.key[i].box.low);
    fillWith(image, low + rim, low + sample - rim, words.key[i].color);
  }
}

}  // namespace isolux::app
