#include "base/numbers.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace isolux::base {

double niceBelow(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double mantissa = value / power;
  return (mantissa >= 5.0 ? 5.0 : mantissa >= 2.0 ? 2.0 : 1.0) * power;
}

double niceAbove(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  const double mantissa = value / power;
  return power * (mantissa <= 1.0 ? 1.0 : mantissa <= 2.0 ? 2.0 : mantissa <= 5.0 ? 5.0 : 10.0);
}

double roundedToStep(double value, double step) {
  if (!(step > 0.0) || !std::isfinite(value)) return value;
  const double rounded = std::round(value / step) * step;
  const int decimals = std::clamp(-static_cast<int>(std::floor(std::log10(step))), 0, 300);
  std::array<char, 700> text{};
  const auto written =
      std::to_chars(text.data(), text.data() + text.size(), rounded, std::chars_format::fixed, decimals);
  if (written.ec != std::errc()) return rounded;
  double nearest = rounded;
  std::from_chars(text.data(), written.ptr, nearest);
  return nearest;
}

}  // namespace isolux::base
