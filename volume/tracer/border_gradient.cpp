// The gradient of the tri-cubic B-spline one sample at a time.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include "volume/field/cubic_weights.h"
#include "volume/tracer/kernels.h"

namespace isolux::volume::tracing {

namespace {

float mixed(float a, float b, float t) {
  return (1.0f - t) * a + t * b;
}

template <class T>
glm::vec3 trilinearGradient(const T* voxels, const std::size_t offset[3][4], const float t[3]) {
  float c[8];
  for (std::size_t i = 0; i < 8; ++i)
    c[i] = static_cast<float>(
        voxels[offset[0][1 + (i & 1)] + offset[1][1 + (i >> 1 & 1)] + offset[2][1 + (i >> 2)]]);
  const auto face = [&](float a, float b, float e, float f, float u, float v) {
    return mixed(mixed(a, b, u), mixed(e, f, u), v);
  };
  const glm::vec3 g(face(c[1] - c[0], c[3] - c[2], c[5] - c[4], c[7] - c[6], t[1], t[2]),
                    face(c[2] - c[0], c[3] - c[1], c[6] - c[4], c[7] - c[5], t[0], t[2]),
                    face(c[4] - c[0], c[5] - c[1], c[6] - c[2], c[7] - c[3], t[0], t[1]));
  return std::isnan(g.x + g.y + g.z) ? glm::vec3(0.0f) : g;
}

template <class T>
glm::vec3 gradientAt(const View& view, const T* voxels, glm::vec3 position) {
  std::size_t offset[3][4];
  float t[3];
  std::size_t stride = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const int n = view.dims[axis];
    // In this order NaN becomes 0.
    const float x = std::min(std::max(0.0f, position[axis]), static_cast<float>(n - 1));
    const int cell = std::min(static_cast<int>(x), std::max(n - 2, 0));
    t[axis] = x - static_cast<float>(cell);
    for (int k = 0; k < 4; ++k)
      offset[axis][k] = stride * static_cast<std::size_t>(std::clamp(cell - 1 + k, 0, n - 1));
    stride *= static_cast<std::size_t>(n);
  }
  const CubicWeights wx = cubicWeights(t[0]), wy = cubicWeights(t[1]), wz = cubicWeights(t[2]);
  // Of values like 1e6 + small only the small part may be weighted.
  const auto reference = static_cast<float>(voxels[offset[2][1] + offset[1][1] + offset[0][1]]);
  float gx = 0, gy = 0, gz = 0;
  for (int k = 0; k < 4; ++k) {
    float f = 0, fx = 0, fy = 0;
    for (int j = 0; j < 4; ++j) {
      const T* row = voxels + offset[2][k] + offset[1][j];
      const auto less = [&](int i) { return static_cast<float>(row[offset[0][i]]) - reference; };
      const float a = less(0), b = less(1), c = less(2), e = less(3);
      const float v = (wx.w[0] * a + wx.w[1] * b) + (wx.w[2] * c + wx.w[3] * e);
      f += wy.w[j] * v;
      fy += wy.d1[j] * v;
      fx += wy.w[j] * ((wx.d1[0] * a + wx.d1[1] * b) + (wx.d1[2] * c + wx.d1[3] * e));
    }
    gx += wz.w[k] * fx;
    gy += wz.w[k] * fy;
    gz += wz.d1[k] * f;
  }
  if (std::is_same_v<T, float> && std::isnan(gx + gy + gz)) return trilinearGradient(voxels, offset, t);
  return {gx, gy, gz};
}

}  // namespace

glm::vec3 borderGradient(const View& view, glm::vec3 voxel) {
  return view.withVoxels([&](const auto* voxels) { return gradientAt(view, voxels, voxel); });
}

}  // namespace isolux::volume::tracing
