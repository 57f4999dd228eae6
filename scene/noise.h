// What is known of the noise of a volume's values.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace isolux::scene {

// Noise of a Gaussian distribution whose deviation may depend on the value: stationary but for that, as if
// white noise had been blurred along each axis by a Gaussian.
struct NoiseModel {
  // Standard deviations of a voxel, data units, at `values`, ascending. Both empty: no noise is known.
  std::vector<double> values, deviations;
  // Standard deviation of the blur along each axis, voxels; 0: neighbours are independent.
  glm::dvec3 correlation{0.0};
  // mm: slices lie up to so far apart, and what lies between them was interpolated when the volume was read;
  // 0: it has none of these.
  double slicesMm = 0.0;

  // Linear between values; beyond the first and the last as there. 0 without values.
  double at(double value) const;
  bool operator==(const NoiseModel&) const = default;
};

// Correlation of two voxels `distance` voxels apart along an axis with this blur: of the sampled Gaussian.
double noiseCorrelation(double blur, int distance);

// Geometric mean of a blur along the three axes, voxels.
double meanBlur(const glm::dvec3& blur);

}  // namespace isolux::scene
