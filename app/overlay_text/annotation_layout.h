// Finds where on a picture its letters and texts stand, each clear of what stands there already.
//
// Pictures in pixels, row 0 at the top.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/overlay_text/annotation.h"
#include "app/overlay_text/free_places.h"
#include "render/legend/font.h"

namespace isolux::app {

// Returns whether each line has a sample of its surface's colour: with several surfaces that show theirs.
bool areKeyed(const std::vector<ShownValue>& values, const scene::Scene& scene);
std::string lineOf(const ShownValue& value, bool keyed);

class AnnotationLayout {
 public:
  explicit AnnotationLayout(glm::ivec2 picture);

  static bool hasLetters(glm::ivec2 picture);
  static bool hasTexts(glm::ivec2 picture);  // and a scale bar
  static double longestBar(glm::ivec2 picture);

  int margin() const { return margin_; }
  const render::Font& letterFont() const { return letterFont_; }
  const render::Font& textFont() const { return textFont_; }
  int indent(bool keyed) const { return keyed ? textFont_.ascent() + textFont_.ascent() / 2 : 0; }
  glm::ivec2 textSize(const std::vector<std::string>& lines) const;

  // Each takes its place.
  void take(const PixelBox& box) { taken_.push_back(box); }
  PixelBox bar(const ScaleBar& bar);
  PixelBox values(const std::vector<ShownValue>& values, bool keyed);
  PixelBox caveats(glm::ivec2 size);
  std::array<PixelBox, 4> letters(const scene::EdgeLetters& letters);  // left, right, top, bottom

 private:
  PixelBox inCorner(glm::ivec2 size, bool top);
  PixelBox besideOthers(const PixelBox& wanted, int axis);
  bool isFree(const PixelBox& box) const;

  glm::ivec2 picture_;
  int margin_;
  render::Font letterFont_, textFont_;
  std::vector<PixelBox> taken_;
};

}  // namespace isolux::app
