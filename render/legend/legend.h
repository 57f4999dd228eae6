// The legend drawn in a picture whose colours stand for numbers: title with unit, colour bar or (kappa1,
// kappa2) square, ticks.
//
// Drawn on the CPU in pixels of the final picture (never supersampled), sized by the picture's height. The
// font (DejaVu Sans) is part of the program: no file is looked up.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace isolux::render {

struct Legend {
  std::string quantity;          // UTF-8: "κ₁"; for the square the horizontal one
  std::string quantityVertical;  // of the square; empty: a bar
  std::string unit;              // "1/mm"; empty: a pure number
  double low = 0.0,
         high = 1.0;         // of the colours; both axes of the square. Finite; may coincide or be swapped
  bool logarithmic = false;  // a bar from low to high, both above 0
  std::string note;          // a line below; empty: none
  std::vector<std::string> hatched;  // what hatched pixels are: lines below, a sample beside the first
  std::vector<glm::vec3> colors;     // linear RGB: low to high, or the square's rows from below; none: no bar
};

// Diagonal lines that can be told from any colour: dark, beside them bright, and as much as both left as it
// is.
enum class Hatch { none, dark, bright };
Hatch hatchAt(glm::ivec2 pixel, int lineWidth);
inline constexpr float kHatchDark = 0.05f, kHatchBright = 0.97f;  // as they are encoded

// Row 0 is the top row; sRGB, premultiplied by alpha in the encoded space.
struct LegendImage {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> rgba;
};

LegendImage drawLegend(const Legend& legend, int pictureHeight);
// As large as suits a picture of this size: smaller, as long as it can be read, where it would take more than
// two fifths of its width or half its height. Empty where it would still take most of one.
LegendImage legendFor(const Legend& legend, glm::ivec2 picture);
glm::ivec2 legendSizeFor(const Legend& legend, glm::ivec2 picture);  // of the same; 0: empty

// Multiples of 1, 2 or 5 times a power of ten within [low, high], about `count` of them, ascending; the value
// itself where low and high coincide.
std::vector<double> tickValues(double low, double high, int count);

// Of a logarithmic axis, 0 < low < high: powers of ten, and 2 and 5 times these where the range is short; an
// end that has none near.
std::vector<double> logarithmicTicks(double low, double high);
// Whether these are written as powers of ten, all of them: where one would have too many digits.
bool areShownAsPowers(const std::vector<double>& ticks);
// "0.02", or as a power of ten "2·10⁻²".
std::string logarithmicTickText(double value, bool asPower);

// How ticks of a range are written: value * 10^-exponent with that many decimals. The exponent is 0 for handy
// numbers.
struct TickFormat {
  int exponent = 0, decimals = 0;
};
TickFormat tickFormat(const std::vector<double>& ticks);
std::string tickText(double value, const TickFormat& format);  // "−0.5", with a real minus sign
// "κ₁ (1/mm)", "K (10⁻⁴ 1/mm²)", "shape index".
std::string axisTitle(const std::string& quantity, const std::string& unit, int exponent);

}  // namespace isolux::render
