// How large derivatives' errors are at each scale of a ladder, from data whose truth nobody knows.
//
// What changes from one scale to the next beyond what noise changes is shape that the larger scale has lost:
//   E |A(s') - A(s)|^2 = noise^2 V(s, s') + change of shape,
// with V known from the filters. The error at a scale is its noise and all that was lost up to it, and the
// least of both is the best scale (after Lepski 1990, "On a problem of adaptive estimation"; the squares are
// means over many points, so that noise leaves them nearly alone). Where noise drowns a change, a quarter of
// that between the next two scales is taken for it, which is right for smooth shapes; rough ones lose more.
//
// The same changes tell what a surface has of noise: no more than explains any of them, and no less than
// leaves shape that does not grow toward fine scales. What is rougher than its voxels' noise explains
// (rounding, terraces, what a scanner leaves at edges) counts as noise.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace isolux::volume {

// Mean squares over points; of the last scale the changes are 0. Those of noise are for noise of variance 1.
struct ScaleStep {
  double noise = 0.0;          // of the measure at this scale
  double change = 0.0;         // from this scale to the next, measured
  double changeOfNoise = 0.0;  // the part of noise in it
};

struct ScaleErrors {
  double noiseVariance = 0.0;
  std::vector<double> noise;  // at each scale, mean squares
  std::vector<double> lost;
  std::size_t best = 0;
};

// The variance of the noise, given that of single voxels.
double surfaceNoise(std::span<const ScaleStep> steps, double estimated);

ScaleErrors scaleErrors(std::span<const ScaleStep> steps, double noiseVariance);

}  // namespace isolux::volume
