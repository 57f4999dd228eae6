// Text and bars in one colour with a rim of the opposite one, written onto a finished picture.
//
// Coordinates are pixels, y down. Any thread; no errors.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "render/graph/frame.h"
#include "render/legend/font.h"
#include "volume/voxels/extent.h"

namespace isolux::app {

class Ink {
 public:
  explicit Ink(glm::ivec2 size);  // of the picture

  void plot(glm::ivec2 p, int coverage);      // 0..255; nothing outside of the picture
  void fill(glm::ivec2 from, glm::ivec2 to);  // `to` excluded
  // `origin`: the left end on the baseline.
  void text(const render::Font& font, const std::string& text, glm::ivec2 origin);
  // A round rim of `rim` pixels, then the ink: bright on dark, or dark on bright.
  void blendOver(render::ColorImage& image, int rim, bool bright = true) const;

 private:
  std::size_t index(glm::ivec2 p) const { return volume::Extent2{size_}.index(p); }
  std::vector<std::uint8_t> rimOf(int rim) const;

  glm::ivec2 size_, low_{1 << 30}, high_{-1};
  std::vector<std::uint8_t> ink_;
};

// Opaque, in a linear colour; `to` excluded.
void fillWith(render::ColorImage& image, glm::ivec2 from, glm::ivec2 to, const glm::dvec3& color);

}  // namespace isolux::app
