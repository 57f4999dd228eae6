// Models the noise of a volume's values.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

namespace isolux::scene {

// Gaussian noise whose standard deviation may depend on the value; otherwise stationary, as if white noise
// were blurred along each axis by a Gaussian.
struct NoiseModel {
  // Standard deviations of a voxel, data units, at `values`, ascending. Both are empty if the noise is
  // unknown.
  std::vector<double> values, deviations;
  // Standard deviation σ of the blur along each axis, voxels; 0: neighbours are independent.
  glm::dvec3 correlation{0.0};
  // The largest slice distance, mm, between which values were interpolated when the volume was read; 0: none
  // were.
  double slicesMm = 0.0;

  // Returns the standard deviation at `value`: linear between `values`, constant beyond the first and last; 0
  // without values.
  double at(double value) const;
  bool operator==(const NoiseModel&) const = default;
};

// Returns the correlation of two voxels `distance` voxels apart along an axis with this blur, from the
// sampled Gaussian.
double noiseCorrelation(double blur, int distance);

// Returns the geometric mean of a blur along the three axes, voxels.
double meanBlur(const glm::dvec3& blur);

}  // namespace isolux::scene
