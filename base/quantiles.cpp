#include "base/quantiles.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

namespace isolux::base {

namespace {

double valueAt(std::span<double> values, std::size_t rank) {
  assert(rank < values.size());
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

double placeOf(double part, std::size_t count) {
  return part * static_cast<double>(count - 1);
}

}  // namespace

double median(std::vector<double> values) {
  const double upper = valueAt(values, values.size() / 2);
  return values.size() % 2 == 1 ? upper : (valueAt(values, values.size() / 2 - 1) + upper) / 2.0;
}

double quantile(std::span<double> values, double part) {
  return valueAt(values, static_cast<std::size_t>(std::lround(placeOf(part, values.size()))));
}

double lowerQuantile(std::span<double> values, double part) {
  return valueAt(values, static_cast<std::size_t>(placeOf(part, values.size())));
}

double upperQuantile(std::span<double> values, double part) {
  return valueAt(values, static_cast<std::size_t>(std::ceil(placeOf(part, values.size()))));
}

}  // namespace isolux::base
