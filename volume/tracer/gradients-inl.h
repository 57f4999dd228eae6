// Gradients: one point at a time, four samples of a row at once. Included once per instruction set by
// simd_kernels-inl.h.
#if defined(ISOLUX_VOLUME_ISOSURFACE_TRACER_GRADIENTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_ISOSURFACE_TRACER_GRADIENTS_INL_H
#undef ISOLUX_VOLUME_ISOSURFACE_TRACER_GRADIENTS_INL_H
#else
#define ISOLUX_VOLUME_ISOSURFACE_TRACER_GRADIENTS_INL_H
#endif

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <hwy/highway.h>

#include "volume/field/cubic_weights.h"
#include "volume/tracer/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

namespace hn = hwy::HWY_NAMESPACE;

using F4 = hn::FixedTag<float, 4>;
using V4 = hn::Vec<F4>;

HWY_INLINE V4 loadRow(const float* row) {
  return hn::LoadU(F4(), row);
}

template <class T>
HWY_INLINE V4 loadRow(const T* row) {
  return hn::ConvertTo(F4(),
                       hn::PromoteTo(hn::FixedTag<std::int32_t, 4>(), hn::LoadU(hn::FixedTag<T, 4>(), row)));
}

template <class T>
HWY_INLINE void gradientsOf(const View& view, const T* voxels, const glm::vec3* points, std::size_t count,
                            glm::vec3* result) {
  const F4 f;
  const std::size_t row = static_cast<std::size_t>(view.dims.x),
                    slice = row * static_cast<std::size_t>(view.dims.y);
  const glm::vec3 last(view.dims - 2);
  const auto scalar = scalarKernels().gradients;
  for (std::size_t n = 0; n < count; ++n) {
    const glm::vec3 p = points[n];
    // All 64 samples in the volume.
    if (!(p.x >= 1.0f && p.y >= 1.0f && p.z >= 1.0f && p.x < last.x && p.y < last.y && p.z < last.z)) {
      scalar(view, &p, 1, result + n);
      continue;
    }
    const int x = static_cast<int>(p.x), y = static_cast<int>(p.y), z = static_cast<int>(p.z);
    alignas(16) const CubicWeights wx = cubicWeights(p.x - static_cast<float>(x));
    const CubicWeights wy = cubicWeights(p.y - static_cast<float>(y)),
                       wz = cubicWeights(p.z - static_cast<float>(z));
    const T* corner = voxels + static_cast<std::size_t>(z - 1) * slice +
                      static_cast<std::size_t>(y - 1) * row + static_cast<std::size_t>(x - 1);
    // Of values like 1e6 + small only the small part may be weighted.
    const V4 reference = hn::Set(f, static_cast<float>(corner[slice + row + 1]));
    // Sums over y and z, with the derivative along neither, y and z.
    V4 alongX = hn::Zero(f), alongY = alongX, alongZ = alongX;
    for (int k = 0; k < 4; ++k, corner += slice) {
      V4 s = hn::Zero(f), sy = s;
      for (std::size_t j = 0; j < 4; ++j) {
        const V4 samples = hn::Sub(loadRow(corner + j * row), reference);
        s = hn::MulAdd(hn::Set(f, wy.w[j]), samples, s);
        sy = hn::MulAdd(hn::Set(f, wy.d1[j]), samples, sy);
      }
      alongX = hn::MulAdd(hn::Set(f, wz.w[k]), s, alongX);
      alongY = hn::MulAdd(hn::Set(f, wz.w[k]), sy, alongY);
      alongZ = hn::MulAdd(hn::Set(f, wz.d1[k]), s, alongZ);
    }
    const V4 weights = hn::Load(f, wx.w);
    const float gx = hn::GetLane(hn::SumOfLanes(f, hn::Mul(hn::Load(f, wx.d1), alongX)));
    const float gy = hn::GetLane(hn::SumOfLanes(f, hn::Mul(weights, alongY)));
    const float gz = hn::GetLane(hn::SumOfLanes(f, hn::Mul(weights, alongZ)));
    result[n] = {gx, gy, gz};
    if (std::is_same_v<T, float> && std::isnan(gx + gy + gz)) scalar(view, &p, 1, result + n);
  }
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
