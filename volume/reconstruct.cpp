#include "volume/reconstruct.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <glm/matrix.hpp>

namespace isolux::volume {

namespace {

// Up to four samples of one axis and what they weigh for the value and both derivatives.
struct AxisTaps {
  std::array<int, 4> sample;
  CubicWeights weights;
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
  const CubicWeights &wx = tx.weights, &wy = ty.weights, &wz = tz.weights;
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

// Missing voxels become the mean of their finite neighbours, ring by ring until none is left.
void fillMissing(std::vector<float>& values, glm::ivec3 dims) {
  const auto at = [dims](int x, int y, int z) {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(dims.y) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(dims.x) +
           static_cast<std::size_t>(x);
  };
  struct Fill {
    std::size_t index;
    float value;
  };
  std::vector<glm::ivec3> missing;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        if (std::isnan(values[at(x, y, z)])) missing.emplace_back(x, y, z);
  while (!missing.empty()) {
    std::vector<Fill> fills;
    std::vector<glm::ivec3> left;
    for (const glm::ivec3& p : missing) {
      double sum = 0.0;
      int count = 0;
      for (int z = std::max(p.z - 1, 0); z <= std::min(p.z + 1, dims.z - 1); ++z)
        for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, dims.y - 1); ++y)
          for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, dims.x - 1); ++x)
            if (const float v = values[at(x, y, z)]; !std::isnan(v)) sum += static_cast<double>(v), ++count;
      if (count > 0)
        fills.push_back({at(p.x, p.y, p.z), static_cast<float>(sum / count)});
      else
        left.push_back(p);
    }
    if (fills.empty()) {  // nothing is known at all
      std::fill(values.begin(), values.end(), 0.0f);
      return;
    }
    for (const Fill& fill : fills) values[fill.index] = fill.value;
    missing = std::move(left);
  }
}

const double kPole = std::sqrt(3.0) - 2.0;

// Turns samples into cubic B-spline coefficients in place (Unser, Aldroubi & Eden 1993, part II, box 2): one
// causal and one anticausal first-order recursion. Both boundaries are mirrors half a sample beyond the
// border sample, c[-1] = c[0] and c[n] = c[n-1], because that is what clamped lookups see: so the spline
// interpolates at the border samples too.
void prefilterLine(std::vector<double>& c) {
  const std::size_t n = c.size();
  if (n < 2) return;
  // c+[0] = f[0] + sum_{m>=1} z^m f[-m], the mirrored signal having period 2n.
  double sum = 0.0, power = kPole;
  const double wrap = std::pow(kPole, 2.0 * static_cast<double>(n));
  for (std::size_t k = 0; k < n; ++k) {
    sum += power * c[k];
    power *= kPole;
    if (std::abs(power) < 1e-30) break;
  }
  if (std::abs(wrap) > 1e-30) {
    double back = wrap;
    for (std::size_t k = 0; k < n; ++k) {
      sum += back * c[k];
      back /= kPole;
    }
  }
  c[0] += sum / (1.0 - wrap);
  for (std::size_t k = 1; k < n; ++k) c[k] += kPole * c[k - 1];
  c[n - 1] *= kPole / (kPole - 1.0);
  for (std::size_t k = n - 1; k-- > 0;) c[k] = kPole * (c[k + 1] - c[k]);
  for (double& value : c) value *= 6.0;
}

}  // namespace

CubicWeights cubicWeights(double t) {
  // Hadwiger et al. 2005 eq. (6); the weights are the four pieces of the uniform cubic B-spline.
  const double s = 1.0 - t;
  CubicWeights out;
  out.w[0] = s * s * s / 6.0;
  out.w[1] = (4.0 + t * t * (3.0 * t - 6.0)) / 6.0;
  out.w[2] = (4.0 + s * s * (3.0 * s - 6.0)) / 6.0;
  out.w[3] = t * t * t / 6.0;
  out.d1[0] = -0.5 * s * s;
  out.d1[1] = t * (1.5 * t - 2.0);
  out.d1[2] = -s * (1.5 * s - 2.0);
  out.d1[3] = 0.5 * t * t;
  out.d2[0] = s;
  out.d2[1] = 3.0 * t - 2.0;
  out.d2[2] = 3.0 * s - 2.0;
  out.d2[3] = t;
  return out;
}

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

FieldSample sampleCubic(const std::vector<float>& coefficients, const Grid& grid, glm::dvec3 voxel) {
  FieldSample out = tensorCubic(grid.dims(), voxel, [&](int x, int y, int z) {
    return static_cast<double>(coefficients[grid.index(x, y, z)]);
  });
  toDataUnits(out, grid);
  return out;
}

std::vector<float> interpolatingCoefficients(const Grid& grid) {
  const glm::ivec3 dims = grid.dims();
  std::vector<float> values = std::visit(
      [](const auto& voxels) { return std::vector<float>(voxels.begin(), voxels.end()); }, grid.voxels());
  if (grid.missingCount() > 0) fillMissing(values, dims);

  for (int axis = 0; axis < 3; ++axis) {
    const int n = dims[axis];
    if (n < 2) continue;
    const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;  // the two other axes
    const std::size_t stride = axis == 0 ? 1
                               : axis == 1
                                   ? static_cast<std::size_t>(dims.x)
                                   : static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y);
    tbb::parallel_for(tbb::blocked_range<int>(0, dims[b]), [&](const tbb::blocked_range<int>& range) {
      std::vector<double> line(static_cast<std::size_t>(n));
      for (int q = range.begin(); q != range.end(); ++q) {
        for (int p = 0; p < dims[a]; ++p) {
          glm::ivec3 start(0);
          start[a] = p;
          start[b] = q;
          float* first = values.data() + grid.index(start.x, start.y, start.z);
          for (std::size_t i = 0; i < line.size(); ++i) line[i] = static_cast<double>(first[i * stride]);
          prefilterLine(line);
          for (std::size_t i = 0; i < line.size(); ++i) first[i * stride] = static_cast<float>(line[i]);
        }
      }
    });
  }
  return values;
}

glm::dvec3 worldGradient(const GridGeometry& geometry, glm::dvec3 voxelGradient) {
  return glm::transpose(glm::inverse(glm::dmat3(geometry.worldFromVoxel))) * voxelGradient;
}

glm::dmat3 worldHessian(const GridGeometry& geometry, const glm::dmat3& voxelHessian) {
  const glm::dmat3 inverse = glm::inverse(glm::dmat3(geometry.worldFromVoxel));
  return glm::transpose(inverse) * voxelHessian * inverse;
}

}  // namespace isolux::volume
