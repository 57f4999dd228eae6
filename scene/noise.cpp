#include "scene/noise.h"

#include <algorithm>
#include <cmath>

namespace isolux::scene {

double NoiseModel::at(double value) const {
  if (values.empty()) return 0.0;
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(values, value) - values.begin());
  if (above == 0) return deviations.front();
  if (above == values.size()) return deviations.back();
  const double low = values[above - 1], part = (value - low) / (values[above] - low);
  return std::lerp(deviations[above - 1], deviations[above], part);
}

double noiseCorrelation(double blur, int distance) {
  if (distance == 0) return 1.0;
  if (!(blur > 0.0)) return 0.0;
  const int reach = static_cast<int>(std::ceil(7.0 * blur));
  const auto weight = [&](int k) { return std::exp(-0.5 * k * k / (blur * blur)); };
  double product = 0.0, square = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    product += weight(k) * weight(k + distance);
    square += weight(k) * weight(k);
  }
  return product / square;
}

double meanBlur(const glm::dvec3& blur) {
  return std::cbrt(blur.x * blur.y * blur.z);
}

}  // namespace isolux::scene
