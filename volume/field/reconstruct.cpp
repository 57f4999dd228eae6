#include "volume/field/reconstruct.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/matrix.hpp>

#include "volume/field/cubic_weights.h"

namespace isolux::volume {

namespace {

// Up to four samples of one axis and what they weigh for the value and both derivatives.
struct AxisTaps {
  std::array<int, 4> sample;
  CubicWeights<double> weights;
};

double clampedCoordinate(double x, int n) {
  // A NaN coordinate stays NaN in std::clamp; max/min in this order turn it into 0.
  return std::min(std::max(0.0, x), static_cast<double>(n - 1));
}

AxisTaps cubicTaps(double coordinate, int n) {
  const double x = clampedCoordinate(coordinate, n);
  const int cell = std::clamp(static_cast<int>(std::floor(x)), 0, std::max(n - 2, 0));
  AxisTaps taps;
  taps.weights = cubicWeights(x - cell);
  for (int k = 0; k < 4; ++k) taps.sample[static_cast<std::size_t>(k)] = std::clamp(cell - 1 + k, 0, n - 1);
  return taps;
}

// Tensor product of three axes: value, gradient and Hessian from the same 64 samples.
template <class Fetch>
FieldSample tensorCubic(glm::ivec3 dims, glm::dvec3 voxel, const Fetch& fetch) {
  const AxisTaps tx = cubicTaps(voxel.x, dims.x), ty = cubicTaps(voxel.y, dims.y),
                 tz = cubicTaps(voxel.z, dims.z);
  const CubicWeights<double>&wx = tx.weights, &wy = ty.weights, &wz = tz.weights;
  FieldSample out;
  for (std::size_t k = 0; k < 4; ++k) {
    // Of the plane: f, fx, fy, fxx, fxy, fyy.
    double f = 0, fx = 0, fy = 0, fxx = 0, fxy = 0, fyy = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      double v = 0, vx = 0, vxx = 0;
      for (std::size_t i = 0; i < 4; ++i) {
        const double s = fetch(tx.sample[i], ty.sample[j], tz.sample[k]);
        v += wx.w[i] * s;
        vx += wx.d1[i] * s;
        vxx += wx.d2[i] * s;
      }
      f += wy.w[j] * v;
      fx += wy.w[j] * vx;
      fy += wy.d1[j] * v;
      fxx += wy.w[j] * vxx;
      fxy += wy.d1[j] * vx;
      fyy += wy.d2[j] * v;
    }
    out.value += wz.w[k] * f;
    out.gradient += glm::dvec3(wz.w[k] * fx, wz.w[k] * fy, wz.d1[k] * f);
    out.hessian[0][0] += wz.w[k] * fxx;
    out.hessian[1][1] += wz.w[k] * fyy;
    out.hessian[2][2] += wz.d2[k] * f;
    out.hessian[1][0] += wz.w[k] * fxy;
    out.hessian[2][0] += wz.d1[k] * fx;
    out.hessian[2][1] += wz.d1[k] * fy;
  }
  out.hessian[0][1] = out.hessian[1][0];
  out.hessian[0][2] = out.hessian[2][0];
  out.hessian[1][2] = out.hessian[2][1];
  return out;
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
    low[axis] = std::clamp(static_cast<int>(std::floor(x)), 0, std::max(dims[axis] - 2, 0));
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

glm::dvec3 worldGradient(const GridGeometry& geometry, glm::dvec3 voxelGradient) {
  return glm::transpose(glm::inverse(glm::dmat3(geometry.worldFromVoxel))) * voxelGradient;
}

glm::dmat3 worldHessian(const GridGeometry& geometry, const glm::dmat3& voxelHessian) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(geometry.worldFromVoxel));
  return glm::transpose(inverse) * voxelHessian * inverse;
}

}  // namespace isolux::volume
