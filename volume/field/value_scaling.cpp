#include "volume/field/value_scaling.h"

#include <algorithm>
#include <cmath>

namespace isolux::volume {

int exponentOf(double least, double most) {
  const double largest = std::max(std::fabs(least), std::fabs(most));
  int exponent = 0;
  if (largest > 0.0) std::frexp(largest, &exponent);
  // What stands for no value (-1e30, -FLT_MAX) lies far beyond the others: they stay numbers that float has
  // in full.
  constexpr int ordinary = 40;
  if (exponent > ordinary) exponent = std::max(ordinary, exponent - ordinary);
  return std::clamp(exponent, -126, 127);
}

ValueScaling scalingOf(double least, double most) {
  const bool oneSign = least > 0.0 || most < 0.0;
  const double nearest = std::min(std::fabs(least), std::fabs(most)),
               farthest = std::max(std::fabs(least), std::fabs(most));
  if (!oneSign || farthest > 2.0 * nearest || least == most) return {0.0f, exponentOf(least, most)};
  const auto middle = static_cast<float>(least + 0.5 * (most - least));
  const double offset = static_cast<double>(middle);
  return {middle, exponentOf(least - offset, most - offset)};
}

}  // namespace isolux::volume
