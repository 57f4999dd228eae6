// What a picture's error may be at most, or its time: values, their texts and units.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace isolux::app {

// depth has two units and is a quantity in each; parts: 0.02 is 2 %.
enum class Quantity {
  depthMm,  // 99 % quantile of the distance along the ray to the true hit, over pixels of the same crossing
  depthVoxels,  // the same in voxel coordinates
  missed,       // part of the surface's pixels whose first crossing was not found, or that show one not there
  normal,       // degrees, 99 % quantile of the angle between the normals
  curvature,    // parts, 99 % quantile of app::curvatureError()
  light         // parts of the mean irradiance E, root mean square
};
inline constexpr std::size_t kQuantities = 6;
inline constexpr std::array<Quantity, kQuantities> kAllQuantities{Quantity::depthMm,   Quantity::depthVoxels,
                                                                  Quantity::missed,    Quantity::normal,
                                                                  Quantity::curvature, Quantity::light};
constexpr std::size_t indexOf(Quantity quantity) {
  return static_cast<std::size_t>(quantity);
}
const char* nameOf(Quantity quantity);  // "depth", as in --error
const char* keyOf(Quantity quantity);   // "depth_mm", as in JSON

struct Limit {
  Quantity quantity;
  double most = 0.0;  // above 0; missed: 0 to 1
  bool operator==(const Limit&) const = default;
};

// An error as it was measured, and between what it lies in the picture itself, nearly always: the margins of
// choices (app/error_budget/choice.h). NaN where it was not measured.
struct ErrorBound {
  double value = std::numeric_limits<double>::quiet_NaN();
  double least = std::numeric_limits<double>::quiet_NaN();
  double bound = std::numeric_limits<double>::quiet_NaN();
};
using TargetErrors = std::array<ErrorBound, kQuantities>;

// "depth=0.01mm,missed=0.1%,normal=0.5deg": depth in mm or vox, normal in deg, curvature and light in %,
// missed in % or as a part. Throws base::Error{usage} naming what is unknown, with the nearest word.
std::vector<Limit> parseErrorTarget(const std::string& text);
// "100ms", "0.1s": milliseconds, above 0. Throws base::Error{usage}.
double parseTimeTarget(const std::string& text);

// "0.01 mm", "2 %", "0.5 degrees".
std::string errorText(Quantity quantity, double error);
// "depth at most 0.01 mm"; of several, joined by ", ".
std::string limitsText(std::span<const Limit> limits);

}  // namespace isolux::app
