#include "volume/field/reconstruct.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/matrix.hpp>

#include "volume/field/cubic_weights.h"
#include "volume/field/quintic_weights.h"

namespace isolux::volume {

namespace {

// Samples of one axis and what they weigh for the value and both derivatives.
template <int taps>
struct AxisTaps {
  int count = taps;  // those behind are not there
  std::array<int, taps> sample{};
  std::array<double, taps> w{}, d1{}, d2{};
};

double clampedCoordinate(double x, int n) {
  // A NaN coordinate stays NaN in std::clamp; max/min in this order turn it into 0.
  return std::min(std::max(0.0, x), static_cast<double>(n - 1));
}

int cellOf(double x, int n) {
  return std::clamp(static_cast<int>(std::floor(x)), 0, std::max(n - 2, 0));
}

template <int taps, class Weights>
void setWeights(AxisTaps<taps>& at, const Weights& weights) {
  std::copy_n(weights.w, taps, at.w.begin());
  std::copy_n(weights.d1, taps, at.d1.begin());
  std::copy_n(weights.d2, taps, at.d2.begin());
}

AxisTaps<4> cubicTapsAt(double coordinate, int n) {
  const double x = clampedCoordinate(coordinate, n);
  const int cell = cellOf(x, n);
  AxisTaps<4> taps;
  setWeights(taps, cubicWeights(x - cell));
  for (int k = 0; k < 4; ++k) taps.sample[static_cast<std::size_t>(k)] = std::clamp(cell - 1 + k, 0, n - 1);
  return taps;
}

AxisTaps<kQuinticTaps> quinticTapsAt(double coordinate, int n) {
  const double x = clampedCoordinate(coordinate, n);
  const int cell = cellOf(x, n);
  const QuinticTaps<double> folded = quinticTaps(cell, x - cell, n);
  AxisTaps<kQuinticTaps> taps;
  setWeights(taps, folded.weights);
  taps.count = std::min(kQuinticTaps, n);
  for (int k = 0; k < kQuinticTaps; ++k) taps.sample[static_cast<std::size_t>(k)] = folded.first + k;
  return taps;
}

// Tensor product of three axes: value, gradient and Hessian from the same samples.
template <int taps, class Fetch>
FieldSample tensorProduct(const AxisTaps<taps>& x, const AxisTaps<taps>& y, const AxisTaps<taps>& z,
                          const Fetch& fetch) {
  const auto count = [](const AxisTaps<taps>& axis) { return static_cast<std::size_t>(axis.count); };
  FieldSample out;
  for (std::size_t k = 0; k < count(z); ++k) {
    // Of the plane: f, fx, fy, fxx, fxy, fyy.
    double f = 0, fx = 0, fy = 0, fxx = 0, fxy = 0, fyy = 0;
    for (std::size_t j = 0; j < count(y); ++j) {
      double v = 0, vx = 0, vxx = 0;
      for (std::size_t i = 0; i < count(x); ++i) {
        const double s = fetch(x.sample[i], y.sample[j], z.sample[k]);
        v += x.w[i] * s;
        vx += x.d1[i] * s;
        vxx += x.d2[i] * s;
      }
      f += y.w[j] * v;
      fx += y.w[j] * vx;
      fy += y.d1[j] * v;
      fxx += y.w[j] * vxx;
      fxy += y.d1[j] * vx;
      fyy += y.d2[j] * v;
    }
    out.value += z.w[k] * f;
    out.gradient += glm::dvec3(z.w[k] * fx, z.w[k] * fy, z.d1[k] * f);
    out.hessian[0][0] += z.w[k] * fxx;
    out.hessian[1][1] += z.w[k] * fyy;
    out.hessian[2][2] += z.d2[k] * f;
    out.hessian[1][0] += z.w[k] * fxy;
    out.hessian[2][0] += z.d1[k] * fx;
    out.hessian[2][1] += z.d1[k] * fy;
  }
  out.hessian[0][1] = out.hessian[1][0];
  out.hessian[0][2] = out.hessian[2][0];
  out.hessian[1][2] = out.hessian[2][1];
  return out;
}

template <class Fetch>
FieldSample tensorCubic(glm::ivec3 dims, glm::dvec3 voxel, const Fetch& fetch) {
  return tensorProduct(cubicTapsAt(voxel.x, dims.x), cubicTapsAt(voxel.y, dims.y),
                       cubicTapsAt(voxel.z, dims.z), fetch);
}

void toDataUnits(FieldSample& sample, const Grid& grid) {
  sample.value = grid.valueOfStored(sample.value);
  sample.gradient *= grid.slope();
  sample.hessian *= grid.slope();
}

}  // namespace

FieldSample sampleTrilinear(const Grid& grid, glm::dvec3 voxel) {
  const glm::ivec3 dims = grid.dims();
  int low[3], high[3];
  double t[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double x = clampedCoordinate(voxel[axis], dims[axis]);
    low[axis] = cellOf(x, dims[axis]);
    high[axis] = std::min(low[axis] + 1, dims[axis] - 1);
    t[axis] = x - low[axis];
  }
  double c[2][2][2];
  std::visit(
      [&](const auto& voxels) {
        for (int k = 0; k < 2; ++k)
          for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i)
              c[k][j][i] = static_cast<double>(
                  voxels[grid.index(i ? high[0] : low[0], j ? high[1] : low[1], k ? high[2] : low[2])]);
      },
      grid.voxels());
  // Edges along x, then along y, then along z: value and slope of each.
  double v[2][2], vx[2][2];
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 2; ++j) {
      vx[k][j] = c[k][j][1] - c[k][j][0];
      v[k][j] = c[k][j][0] + t[0] * vx[k][j];
    }
  }
  double f[2], fx[2], fy[2], fxy[2];
  for (int k = 0; k < 2; ++k) {
    fy[k] = v[k][1] - v[k][0];
    fxy[k] = vx[k][1] - vx[k][0];
    f[k] = v[k][0] + t[1] * fy[k];
    fx[k] = vx[k][0] + t[1] * fxy[k];
  }
  FieldSample out;
  out.value = f[0] + t[2] * (f[1] - f[0]);
  out.gradient = {fx[0] + t[2] * (fx[1] - fx[0]), fy[0] + t[2] * (fy[1] - fy[0]), f[1] - f[0]};
  out.hessian[0][1] = out.hessian[1][0] = fxy[0] + t[2] * (fxy[1] - fxy[0]);
  out.hessian[0][2] = out.hessian[2][0] = fx[1] - fx[0];
  out.hessian[1][2] = out.hessian[2][1] = fy[1] - fy[0];
  toDataUnits(out, grid);
  return out;
}

FieldSample sampleCubic(const Grid& grid, glm::dvec3 voxel) {
  FieldSample out = std::visit(
      [&](const auto& voxels) {
        return tensorCubic(grid.dims(), voxel, [&](int x, int y, int z) {
          return static_cast<double>(voxels[grid.index(x, y, z)]);
        });
      },
      grid.voxels());
  toDataUnits(out, grid);
  return out;
}

FieldSample sampleCubic(const Coefficients& coefficients, const Grid& grid, glm::dvec3 voxel) {
  FieldSample out = tensorCubic(grid.dims(), voxel, [&](int x, int y, int z) {
    return static_cast<double>(coefficients.values[grid.index(x, y, z)]);
  });
  out.value += coefficients.offset;  // the weights sum to 1, their derivatives to 0
  toDataUnits(out, grid);
  return out;
}

FieldSample sampleScaled(const ScaledField& scaled, const Grid& grid, glm::dvec3 voxel) {
  const glm::ivec3 dims = grid.dims();
  const std::vector<float>& values = scaled.coefficients.values;
  FieldSample out = tensorProduct(
      quinticTapsAt(voxel.x, dims.x), quinticTapsAt(voxel.y, dims.y), quinticTapsAt(voxel.z, dims.z),
      [&](int x, int y, int z) { return static_cast<double>(values[grid.index(x, y, z)]); });
  out.value += scaled.coefficients.offset;
  toDataUnits(out, grid);
  return out;
}

glm::dvec3 worldGradient(const GridGeometry& geometry, glm::dvec3 voxelGradient) {
  return glm::transpose(glm::inverse(glm::dmat3(geometry.worldFromVoxel))) * voxelGradient;
}

glm::dmat3 worldHessian(const GridGeometry& geometry, const glm::dmat3& voxelHessian) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(geometry.worldFromVoxel));
  return glm::transpose(inverse) * voxelHessian * inverse;
}

}  // namespace isolux::volume
