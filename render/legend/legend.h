// Draws the legend of an image whose colours show numbers: title with unit, colour bar or (kappa1, kappa2)
// square, ticks.
//
// Drawn on the CPU in pixels of the final image (never supersampled), sized by the image's height. The font
// (DejaVu Sans) is part of the program: no file is looked up.
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
  std::vector<std::string> hatched;  // what hatched pixels mean: lines below, a sample next to the first
  std::vector<glm::vec3> colors;     // linear RGB: low to high, or the square's rows from below; none: no bar
};

// Diagonal lines that are visible on any colour: a dark one, a bright one, and a gap as wide as both.
enum class Hatch { none, dark, bright };
Hatch hatchAt(glm::ivec2 pixel, int lineWidth);
inline constexpr float kHatchDark = 0.05f, kHatchBright = 0.97f;  // sRGB-encoded

// Row 0 is the top row; sRGB, premultiplied by alpha in the encoded space.
struct LegendImage {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> rgba;
};

LegendImage drawLegend(const Legend& legend, int pictureHeight);
// Draws the legend at a size for this image. It is smaller, but legible, if it would cover more than two
// fifths of the width or half the height. Returns an empty image if it would still cover most of either.
LegendImage legendFor(const Legend& legend, glm::ivec2 picture);
glm::ivec2 legendSizeFor(const Legend& legend, glm::ivec2 picture);  // of the same; 0: empty

// Returns about `count` multiples of 1, 2 or 5 times a power of ten within [low, high], ascending. Returns
// the value itself if low and high coincide.
std::vector<double> tickValues(double low, double high, int count);

// Returns the ticks of a logarithmic axis, 0 < low < high: powers of ten, and for a short range 2 and 5 times
// these. An end without a tick near it is a tick, too.
std::vector<double> logarithmicTicks(double low, double high);
// Returns whether all of these are written as powers of ten: if one would have too many digits.
bool areShownAsPowers(const std::vector<double>& ticks);
// Returns "0.02", or as a power of ten "2·10⁻²".
std::string logarithmicTickText(double value, bool asPower);

// The format of a range's ticks: value * 10^-exponent with that many decimals. The exponent is 0 for numbers
// of few digits.
struct TickFormat {
  int exponent = 0, decimals = 0;
};
TickFormat tickFormat(const std::vector<double>& ticks);
std::string tickText(double value, const TickFormat& format);  // "−0.5", with a real minus sign
// Returns "κ₁ (1/mm)", "K (10⁻⁴ 1/mm²)", "shape index".
std::string axisTitle(const std::string& quantity, const std::string& unit, int exponent);

}  // namespace isolux::render
