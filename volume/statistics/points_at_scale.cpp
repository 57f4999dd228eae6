#include "volume/statistics/points_at_scale.h"

#include <array>
#include <cmath>

#include "scene/noise.h"
#include "volume/field/cubic_weights.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
#include "volume/field/symmetric_filter.h"
#include "volume/field/tensor_product.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

constexpr double kSplineVariance = 1.0 / 3.0;  // voxels^2

// Symmetric, by distance from the middle, of sum 1 and this variance (voxels^2).
std::vector<double> smoothingKernel(double variance) {
  if (!(variance > 0.0)) return {1.0};
  if (variance < 0.4) return {1.0 - variance, 0.5 * variance};
  const int reach = static_cast<int>(std::ceil(3.5 * std::sqrt(variance)));
  std::vector<double> kernel;
  double sum = 0.0;
  for (int k = 0; k <= reach; ++k) {
    kernel.push_back(std::exp(-0.5 * k * k / variance));
    sum += (k == 0 ? 1.0 : 2.0) * kernel.back();
  }
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

// As AxisTaps, of any number. A sample is given by its offset in the array.
struct LongAxisTaps {
  explicit LongAxisTaps(std::size_t expected) {
    sample.reserve(expected);
    for (std::vector<double>* const weights : {&w, &d1, &d2}) weights->reserve(expected);
  }

  std::size_t count = 0;
  std::vector<std::size_t> sample;
  std::vector<double> w, d1, d2;

  // Folds samples beyond the border.
  void add(int at, int length, std::size_t stride, double weight, double slope, double bend) {
    addReflected(at, length, [&](int from, double factor) {
      sample.push_back(static_cast<std::size_t>(from) * stride);
      w.push_back(factor * weight);
      d1.push_back(factor * slope);
      d2.push_back(factor * bend);
      ++count;
    });
  }
  std::size_t middle() const { return sample[count / 2]; }
};

LongAxisTaps tapsAlong(const std::vector<double>& kernel, double position, int length, std::size_t stride) {
  const auto [cell, t] = cellPosition(position, length);
  const CubicWeights<double> spline = cubicWeights(t);
  const int reach = static_cast<int>(kernel.size()) - 1;
  LongAxisTaps out(2 * kernel.size() + 2);
  for (int tap = -1 - reach; tap <= 2 + reach; ++tap) {
    double w = 0.0, d1 = 0.0, d2 = 0.0;
    for (int k = 0; k < 4; ++k) {
      const int apart = std::abs(tap - (k - 1));
      if (apart > reach) continue;
      const double weight = kernel[static_cast<std::size_t>(apart)];
      w += weight * spline.w[k];
      d1 += weight * spline.d1[k];
      d2 += weight * spline.d2[k];
    }
    out.add(cell + tap, length, stride, w, d1, d2);
  }
  return out;
}

// What is left of the variance of noise with this blur, voxels.
double varianceAfter(const std::vector<double>& kernel, double blur) {
  const int reach = static_cast<int>(kernel.size()) - 1;
  double sum = 0.0;
  for (int i = -reach; i <= reach; ++i)
    for (int j = -reach; j <= reach; ++j)
      sum += kernel[static_cast<std::size_t>(std::abs(i))] * kernel[static_cast<std::size_t>(std::abs(j))] *
             scene::noiseCorrelation(blur, i - j);
  return sum;
}

}  // namespace

glm::dvec3 smoothingAtScale(const GridGeometry& geometry, double scaleMm) {
  const glm::dvec3 voxels = scaleMm / geometry.spacingMm();
  return glm::max(voxels * voxels, glm::dvec3(kSplineVariance));
}

PointNoise pointNoise(const GridGeometry& geometry, const glm::dvec3& smoothing,
                      const glm::dvec3& noiseBlur) {
  // Noise that is smoothed is less, and more correlated.
  double variance = 1.0;
  glm::dvec3 blur = noiseBlur;
  for (int axis = 0; axis < 3; ++axis) {
    const double added = smoothing[axis] - kSplineVariance;
    if (!(added > 0.0)) continue;
    variance *= varianceAfter(smoothingKernel(added), noiseBlur[axis]);
    blur[axis] = std::sqrt(noiseBlur[axis] * noiseBlur[axis] + added);
  }
  const CurvatureScale scale = curvatureScale(geometry, scene::Field::cubic, std::sqrt(variance), blur);
  return {scale.gradientNoise * scale.gradientNoise, scale.hessianNoise * scale.hessianNoise};
}

std::vector<PointDerivatives> derivativesAtScale(const Grid& grid, std::span<const glm::dvec3> points,
                                                 double scaleMm, const std::vector<float>* filled) {
  const GridGeometry& geometry = grid.geometry();
  const glm::dvec3 smoothing = smoothingAtScale(geometry, scaleMm);
  std::array<std::vector<double>, 3> kernels;
  for (int axis = 0; axis < 3; ++axis)
    kernels[static_cast<std::size_t>(axis)] = smoothingKernel(smoothing[axis] - kSplineVariance);
  std::vector<PointDerivatives> out(points.size());
  const std::array<std::size_t, 3> strides{1, grid.index(0, 1, 0), grid.index(0, 0, 1)};
  const auto sum = [&](const auto& voxels) {
    parallelEach(points.size(), [&](std::size_t i) {
      const auto along = [&](int axis) {
        const auto a = static_cast<std::size_t>(axis);
        return tapsAlong(kernels[a], points[i][axis], geometry.dims[axis], strides[a]);
      };
      const LongAxisTaps x = along(0), y = along(1), z = along(2);
      // Nothing is lost of values like 1e6.
      const auto middle = static_cast<double>(voxels[x.middle() + y.middle() + z.middle()]);
      const FieldSample around = tensorProduct(x, y, z, [&](auto atX, auto atY, auto atZ) {
        return static_cast<double>(voxels[atX + atY + atZ]) - middle;
      });
      out[i] = {worldGradient(geometry, grid.slope() * around.gradient),
                worldHessian(geometry, grid.slope() * around.hessian)};
    });
  };
  if (filled)
    sum(*filled);
  else
    grid.visit(sum);
  return out;
}

}  // namespace isolux::volume
