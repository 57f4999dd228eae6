#include "volume/statistics/points_at_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "scene/noise.h"
#include "volume/field/cubic_weights.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
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

// What each sample of one axis contributes to value, first and second derivative.
struct AxisWeights {
  std::vector<std::size_t> offsets;  // of samples, elements
  std::vector<std::array<double, 3>> weights;

  // Samples beyond the border continue by point reflection, f(-k) = 2 f(0) - f(k).
  void add(int at, int length, std::size_t stride, std::array<double, 3> weight) {
    const auto twice = [&](int border) {
      push(border, stride, {2.0 * weight[0], 2.0 * weight[1], 2.0 * weight[2]});
    };
    while (length > 1 && (at < 0 || at >= length)) {
      const int border = at < 0 ? 0 : length - 1;
      twice(border);
      at = 2 * border - at;
      for (double& part : weight) part = -part;
    }
    push(std::clamp(at, 0, length - 1), stride, weight);
  }

 private:
  void push(int at, std::size_t stride, const std::array<double, 3>& weight) {
    offsets.push_back(static_cast<std::size_t>(at) * stride);
    weights.push_back(weight);
  }
};

AxisWeights weightsAlong(const std::vector<double>& kernel, double position, int length, std::size_t stride) {
  const double at = std::clamp(position, 0.0, static_cast<double>(length - 1));
  const int cell = std::min(static_cast<int>(at), std::max(length - 2, 0));
  const CubicWeights<double> spline = cubicWeights(at - cell);
  const int reach = static_cast<int>(kernel.size()) - 1;
  AxisWeights out;
  for (int tap = -1 - reach; tap <= 2 + reach; ++tap) {
    std::array<double, 3> sums{};
    for (int k = 0; k < 4; ++k) {
      const int apart = std::abs(tap - (k - 1));
      if (apart > reach) continue;
      const double weight = kernel[static_cast<std::size_t>(apart)];
      sums[0] += weight * spline.w[k];
      sums[1] += weight * spline.d1[k];
      sums[2] += weight * spline.d2[k];
    }
    out.add(cell + tap, length, stride, sums);
  }
  return out;
}

struct VoxelDerivatives {
  glm::dvec3 gradient{0.0};
  glm::dmat3 hessian{0.0};
};

// Stored units. Sums over x, then y, then z. What the middle has is taken off first: nothing is lost of
// values like 1e6.
template <class T>
VoxelDerivatives sumAround(const std::vector<T>& voxels, const std::array<AxisWeights, 3>& along) {
  const AxisWeights &x = along[0], &y = along[1], &z = along[2];
  const auto middle =
      static_cast<double>(voxels[x.offsets[x.offsets.size() / 2] + y.offsets[y.offsets.size() / 2] +
                                 z.offsets[z.offsets.size() / 2]]);
  double v100 = 0, v010 = 0, v001 = 0, v200 = 0, v020 = 0, v002 = 0, v110 = 0, v101 = 0, v011 = 0;
  for (std::size_t k = 0; k < z.offsets.size(); ++k) {
    double p00 = 0, p10 = 0, p01 = 0, p20 = 0, p02 = 0, p11 = 0;
    for (std::size_t j = 0; j < y.offsets.size(); ++j) {
      const T* const row = voxels.data() + y.offsets[j] + z.offsets[k];
      double s0 = 0, s1 = 0, s2 = 0;
      for (std::size_t i = 0; i < x.offsets.size(); ++i) {
        const double value = static_cast<double>(row[x.offsets[i]]) - middle;
        s0 += x.weights[i][0] * value;
        s1 += x.weights[i][1] * value;
        s2 += x.weights[i][2] * value;
      }
      const auto& w = y.weights[j];
      p00 += w[0] * s0, p10 += w[0] * s1, p20 += w[0] * s2;
      p01 += w[1] * s0, p11 += w[1] * s1, p02 += w[2] * s0;
    }
    const auto& w = z.weights[k];
    v100 += w[0] * p10, v010 += w[0] * p01, v200 += w[0] * p20, v020 += w[0] * p02, v110 += w[0] * p11;
    v001 += w[1] * p00, v101 += w[1] * p10, v011 += w[1] * p01, v002 += w[2] * p00;
  }
  return {{v100, v010, v001}, glm::dmat3(v200, v110, v101, v110, v020, v011, v101, v011, v002)};
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
  const auto sum = [&](const auto& voxels) {
    parallelEach(points.size(), [&](std::size_t i) {
      std::array<AxisWeights, 3> along;
      std::size_t stride = 1;
      for (int axis = 0; axis < 3; stride *= static_cast<std::size_t>(geometry.dims[axis++]))
        along[static_cast<std::size_t>(axis)] = weightsAlong(kernels[static_cast<std::size_t>(axis)],
                                                             points[i][axis], geometry.dims[axis], stride);
      const VoxelDerivatives around = sumAround(voxels, along);
      out[i] = {worldGradient(geometry, grid.slope() * around.gradient),
                worldHessian(geometry, grid.slope() * around.hessian)};
    });
  };
  if (filled)
    sum(*filled);
  else
    std::visit(sum, grid.voxels());
  return out;
}

}  // namespace isolux::volume
