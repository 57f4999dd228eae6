// Computes the noise near the border as the curvature shader does.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/vec3.hpp>

namespace isolux::test {

// By what the noise of derivatives of a field at a scale (scaled_field.h) exceeds that within the volume,
// near its border: samples go on by point reflection, so that of the smoothing across a border at distance d
// the border's own sample takes the part 2 Phi(-d / s), Phi the normal distribution (here the logistic one),
// against a variance of 1 / (2 sqrt(pi) s) within. voxel: in the volume; deviations: of the Gaussian, voxels.
// The same as curvature.frag.glsl.
inline double noiseAtBorder(const glm::dvec3& voxel, const glm::ivec3& dims, const glm::dvec3& deviations) {
  constexpr double least = 0.2821;    // a sample's own variance is 1
  constexpr double logistic = 1.702;  // Phi(x) is 1 / (1 + exp(-1.702 x)) to 0.01
  double variance = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double scale = std::max(deviations[axis], least);
    const double distance = std::max(std::min(voxel[axis], dims[axis] - 1 - voxel[axis]), 0.0) / scale;
    const double part = 2.0 / (1.0 + std::exp(logistic * std::min(distance, 20.0)));
    variance *= 1.0 + 2.0 * std::sqrt(std::numbers::pi) * scale * part * part;
  }
  return std::sqrt(variance);
}

}  // namespace isolux::test
