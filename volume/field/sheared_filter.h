// Smoothing by a Gaussian that is not separable along the axes of a grid, because they are not orthogonal.
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>

#include "base/progress.h"
#include "volume/field/symmetric_filter.h"

namespace isolux::volume {

// A weight at an offset of voxels.
struct KernelTap {
  glm::ivec3 offset{0};
  double weight = 0.0;
};

// The sampled Gaussian of sum 1 with the parameters `deviations` along the axes and their correlations, cut
// where it is below 1e-9 of its largest. Along axes whose `alone` is set it has the one tap 0.
std::vector<KernelTap> shearedGaussian(glm::dvec3 deviations, const glm::dmat3& correlations,
                                       glm::bvec3 alone);

// The direct sum over all taps: time proportional to voxels and taps.
std::vector<float> filteredDirectly(const std::vector<float>& values, glm::ivec3 dims,
                                    const std::vector<KernelTap>& taps, Beyond beyond,
                                    base::Progress& progress, base::ProgressRange share);

}  // namespace isolux::volume
