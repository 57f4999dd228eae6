#include "volume/field/reconstruct.h"

#include <algorithm>

#include <glm/matrix.hpp>

#include "volume/field/cubic_weights.h"
#include "volume/field/quintic_weights.h"
#include "volume/field/tensor_product.h"

namespace isolux::volume {

namespace {

template <std::size_t taps, class Weights>
void setWeights(AxisTaps<taps>& at, const Weights& weights) {
  std::copy_n(weights.w, taps, at.w.begin());
  std::copy_n(weights.d1, taps, at.d1.begin());
  std::copy_n(weights.d2, taps, at.d2.begin());
}

AxisTaps<4> cubicTapsAt(double coordinate, int n) {
  const auto [cell, t] = cellPosition(coordinate, n);
  AxisTaps<4> taps;
  setWeights(taps, cubicWeights(t));
  for (int k = 0; k < 4; ++k) taps.sample[static_cast<std::size_t>(k)] = std::clamp(cell - 1 + k, 0, n - 1);
  return taps;
}

AxisTaps<kQuinticTaps> quinticTapsAt(double coordinate, int n) {
  const auto [cell, t] = cellPosition(coordinate, n);
  const QuinticTaps<double> folded = quinticTaps(cell, t, n);
  AxisTaps<kQuinticTaps> taps;
  setWeights(taps, folded.weights);
  taps.count = static_cast<std::size_t>(std::min(kQuinticTaps, n));
  for (int k = 0; k < kQuinticTaps; ++k) taps.sample[static_cast<std::size_t>(k)] = folded.first + k;
  return taps;
}

// Sums values, one for each voxel of the grid, with the weights that tapsAt(coordinate, voxels) has on an
// axis.
template <class T, class TapsAt>
FieldSample sumAt(const Grid& grid, const std::vector<T>& values, glm::dvec3 voxel, const TapsAt& tapsAt) {
  const glm::ivec3 dims = grid.dims();
  return tensorProduct(tapsAt(voxel.x, dims.x), tapsAt(voxel.y, dims.y), tapsAt(voxel.z, dims.z),
                       [&](int x, int y, int z) { return static_cast<double>(values[grid.index(x, y, z)]); });
}

void toDataUnits(FieldSample& sample, const Grid& grid) {
  sample.value = grid.valueOfStored(sample.value);
  sample.gradient *= grid.slope();
  sample.hessian *= grid.slope();
}

template <class TapsAt>
FieldSample sampleSpline(const Coefficients& coefficients, const Grid& grid, glm::dvec3 voxel,
                         const TapsAt& tapsAt) {
  FieldSample out = sumAt(grid, coefficients.values, voxel, tapsAt);
  out.value += coefficients.offset;  // the weights sum to 1, their derivatives to 0
  toDataUnits(out, grid);
  return out;
}

}  // namespace

FieldSample sampleTrilinear(const Grid& grid, glm::dvec3 voxel) {
  const glm::ivec3 dims = grid.dims();
  int low[3], high[3];
  double t[3];
  for (int axis = 0; axis < 3; ++axis) {
    const CellPosition at = cellPosition(voxel[axis], dims[axis]);
    low[axis] = at.cell;
    high[axis] = std::min(low[axis] + 1, dims[axis] - 1);
    t[axis] = at.t;
  }
  double c[2][2][2];
  grid.visit([&](const auto& voxels) {
    for (int k = 0; k < 2; ++k)
      for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 2; ++i)
          c[k][j][i] = static_cast<double>(
              voxels[grid.index(i ? high[0] : low[0], j ? high[1] : low[1], k ? high[2] : low[2])]);
  });
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
  const auto sum = [&](const auto& voxels) { return sumAt(grid, voxels, voxel, cubicTapsAt); };
  FieldSample out = grid.visit(sum);
  toDataUnits(out, grid);
  return out;
}

FieldSample sampleCubic(const Coefficients& coefficients, const Grid& grid, glm::dvec3 voxel) {
  return sampleSpline(coefficients, grid, voxel, cubicTapsAt);
}

FieldSample sampleScaled(const ScaledField& scaled, const Grid& grid, glm::dvec3 voxel) {
  return sampleSpline(scaled.coefficients, grid, voxel, quinticTapsAt);
}

FieldSample sampleField(const Grid& grid, scene::Field field, const Coefficients* coefficients,
                        glm::dvec3 voxel, const ScaledField* scaled) {
  if (scaled) return sampleScaled(*scaled, grid, voxel);
  if (field == scene::Field::trilinear) return sampleTrilinear(grid, voxel);
  return coefficients ? sampleCubic(*coefficients, grid, voxel) : sampleCubic(grid, voxel);
}

glm::dvec3 worldGradient(const GridGeometry& geometry, glm::dvec3 voxelGradient) {
  return glm::transpose(glm::inverse(glm::dmat3(geometry.worldFromVoxel))) * voxelGradient;
}

glm::dmat3 worldHessian(const GridGeometry& geometry, const glm::dmat3& voxelHessian) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(geometry.worldFromVoxel));
  return glm::transpose(inverse) * voxelHessian * inverse;
}

}  // namespace isolux::volume
