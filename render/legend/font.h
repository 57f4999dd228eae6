// Renders text as coverage, in the font that is part of the program (DejaVu Sans), through FreeType.
//
// Text is UTF-8. Coordinates are pixels, y down, the origin of a text at its left end on the baseline.
// The embedded font is part of the program: if FreeType rejects it, a std::logic_error is thrown.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <glm/vec2.hpp>

namespace isolux::render {

class Font {
 public:
  explicit Font(int pixels);  // height of the em square
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  int width(const std::string& text) const;
  int ascent() const;  // from the baseline to the top of capitals
  int lineHeight() const;
  // Calls `plot` with a pixel and its coverage, 0..255, for every pixel that the text touches.
  using Plot = std::function<void(glm::ivec2 pixel, int coverage)>;
  void draw(const std::string& text, glm::ivec2 origin, const Plot& plot) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isolux::render
