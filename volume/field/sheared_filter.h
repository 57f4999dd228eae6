// Smoothing by a Gaussian that is not separable along the axes of a grid, because they are not orthogonal:
// one line of the lattice after another, at most six, whatever the covariance (Selling 1874; Fehrenbach &
// Mirebeau 2014).
#pragma once

#include <vector>

#include <glm/mat3x3.hpp>

#include "base/progress.h"
#include "volume/field/symmetric_filter.h"

namespace isolux::volume {

// A direction of the lattice, and the variance along it in steps of that length.
struct LatticeLine {
  glm::ivec3 step{0};
  double variance = 0.0;
};

// Lines whose variances, each times the square of its step (v v^T), sum to the covariance (voxels^2). It may
// be singular.
std::vector<LatticeLine> latticeLines(const glm::dmat3& covariance);

// `values` convolved with sampled Gaussians along all lines. Time proportional to voxels and taps along the
// lines.
void filterLatticeLines(std::vector<float>& values, glm::ivec3 dims, const std::vector<LatticeLine>& lines,
                        Beyond beyond, base::Progress& progress, base::ProgressRange share);

}  // namespace isolux::volume
