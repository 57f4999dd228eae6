// Symmetric kernels along one axis that derivatives at a scale are made with: of smoothing, and of the
// prefilter of the quintic B-spline.
#pragma once

#include <vector>

#include "scene/choices.h"

namespace isolux::volume {

// Weight k of a symmetric kernel stands at distance k, voxels; at least one.
using HalfKernel = std::vector<double>;

// A sampled Gaussian of sum 1 whose variance is deviation^2: its parameter is the deviation itself from one
// voxel on, and solved for below, where sampling changes the variance. Voxels.
HalfKernel gaussianKernel(double deviation);

// What samples are smoothed with before `field` is derived. `cubic` smooths by itself, with the variance 1/3
// of its B-spline: where the Gaussian has less, the samples of the B-spline (1/6, 4/6, 1/6) take its place.
HalfKernel smoothingKernel(scene::Field field, double deviation);

// The response by which samples become coefficients of the quintic B-spline: the inverse of (1, 26, 66, 26,
// 1) / 120, whose poles are -0.4306 and -0.0431 (Unser, Aldroubi & Eden 1993, part II, table I).
HalfKernel quinticPrefilter();

HalfKernel convolved(const HalfKernel& a, const HalfKernel& b);

// Without what has less than 1e-9 of the sum at its ends; the rest of sum 1.
HalfKernel cutToSumOne(HalfKernel kernel);

// From samples to coefficients of the field at a scale, along one axis: smoothing and prefilter.
HalfKernel scaleKernel(const HalfKernel& smoothing);

// The parameter of the sampled Gaussian whose variance this is.
double gaussianParameter(double variance);

}  // namespace isolux::volume
