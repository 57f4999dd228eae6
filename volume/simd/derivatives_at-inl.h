// Computes gradient and Hessian at points: one point at a time, four samples of a row at once. Included once
// per instruction set.
#if defined(ISOLUX_VOLUME_SIMD_DERIVATIVES_AT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_SIMD_DERIVATIVES_AT_INL_H
#undef ISOLUX_VOLUME_SIMD_DERIVATIVES_AT_INL_H
#else
#define ISOLUX_VOLUME_SIMD_DERIVATIVES_AT_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include <hwy/highway.h>
#include <glm/common.hpp>

#include "volume/field/cubic_weights.h"
#include "volume/simd/lanes-inl.h"
#include "volume/voxels/extent.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

using Row = hn::FixedTag<float, 4>;
using VRow = hn::Vec<Row>;

template <class T>
HWY_INLINE VRow loadSamples(const T* row) {
  if constexpr (std::is_same_v<T, float>) {
    return hn::LoadU(Row(), row);
  } else {
    alignas(8) T four[4];
    std::memcpy(four, row, sizeof four);
    return hn::ConvertTo(
        Row(), hn::PromoteTo(hn::FixedTag<std::int32_t, 4>(), hn::Load(hn::FixedTag<T, 4>(), four)));
  }
}

// In stored units per voxel (and per voxel squared).
struct PointDerivatives {
  glm::vec3 gradient, diagonal, mixed;  // diagonal: xx, yy, zz; mixed: xy, xz, yz
  bool known, within;                   // all samples are there; are the volume's own
};

// The cell that a point in the volume lies in, and where in it.
struct Located {
  glm::ivec3 cell;
  glm::vec3 part;
};

HWY_INLINE Located locate(glm::ivec3 dims, glm::vec3 point) {
  Located at;
  for (int axis = 0; axis < 3; ++axis) {
    const float last = static_cast<float>(dims[axis] - 1), above = point[axis] > 0.0f ? point[axis] : 0.0f;
    const float p = above < last ? above : last;
    at.cell[axis] = std::max(std::min(static_cast<int>(p), dims[axis] - 2), 0);
    at.part[axis] = p - static_cast<float>(at.cell[axis]);
  }
  return at;
}

template <class T>
class DerivativesAt {
 public:
  DerivativesAt(const T* voxels, glm::ivec3 dims) : voxels_(voxels), extent_{dims} {}

  // Returns zeros where a corner of the cell is missing.
  HWY_INLINE PointDerivatives trilinear(const Located& p) const;
  // Derives the B-spline whose coefficients the voxels are; not known where one of the 64 is missing.
  template <bool hessian>
  HWY_INLINE PointDerivatives spline(const Located& p) const;
  // Whether all those 64 lie in the volume.
  HWY_INLINE bool isWithin(glm::ivec3 cell) const {
    const glm::ivec3 high = cell + 2 - extent_.dims;
    return cell.x >= 1 && cell.y >= 1 && cell.z >= 1 && high.x < 0 && high.y < 0 && high.z < 0;
  }

 private:
  // Copies the 4^3 samples from `first` on; beyond the border samples repeat.
  HWY_NOINLINE void repeatBorder(glm::ivec3 first, float* repeated) const;
  HWY_INLINE const T* at(int x, int y, int z) const { return voxels_ + extent_.index(x, y, z); }

  const T* voxels_;
  Extent3 extent_;
};

template <class T>
HWY_INLINE PointDerivatives DerivativesAt<T>::trilinear(const Located& p) const {
  const std::size_t row = extent_.row(), slice = extent_.slice();
  const T* const corner = at(p.cell.x, p.cell.y, p.cell.z);
  const auto reference = static_cast<float>(corner[0]);
  // Only the small part of values like 1e6 + small may be weighted.
  const auto less = [&](std::size_t i) { return static_cast<float>(corner[i]) - reference; };
  const float c000 = less(0), c100 = less(1), c010 = less(row), c110 = less(row + 1), c001 = less(slice),
              c101 = less(slice + 1), c011 = less(slice + row), c111 = less(slice + row + 1);
  const auto mix = [](float a, float b, float t) { return a + t * (b - a); };
  const float x = p.part.x, y = p.part.y, z = p.part.z;
  const float c00 = mix(c000, c001, z), c10 = mix(c100, c101, z), c01 = mix(c010, c011, z),
              c11 = mix(c110, c111, z);
  const float r00 = c001 - c000, r10 = c101 - c100, r01 = c011 - c010, r11 = c111 - c110;
  PointDerivatives out{};
  out.gradient = {mix(c10 - c00, c11 - c01, y), mix(c01 - c00, c11 - c10, x),
                  mix(mix(r00, r10, x), mix(r01, r11, x), y)};
  out.mixed = {c11 - c01 - c10 + c00, mix(r10 - r00, r11 - r01, y), mix(r01 - r00, r11 - r10, x)};
  const float sum = (c000 + c100) + (c010 + c110) + (c001 + c101) + (c011 + c111);
  out.known = !std::isnan(sum - sum);
  if (!out.known) out = {};
  return out;
}

template <class T>
HWY_NOINLINE void DerivativesAt<T>::repeatBorder(glm::ivec3 first, float* repeated) const {
  forEachIn(first, first + 4, [&](glm::ivec3 v) {
    const glm::ivec3 sample = glm::clamp(v, glm::ivec3(0), extent_.dims - 1);
    *repeated++ = static_cast<float>(*at(sample.x, sample.y, sample.z));
  });
}

template <class T>
template <bool hessian>
HWY_INLINE PointDerivatives DerivativesAt<T>::spline(const Located& p) const {
  const Row f;
  alignas(16) const CubicWeights wx = cubicWeights(p.part.x);
  const CubicWeights wy = cubicWeights(p.part.y), wz = cubicWeights(p.part.z);
  const glm::ivec3 first = p.cell - 1;
  const bool within = isWithin(p.cell);
  const auto reference = static_cast<float>(*at(p.cell.x, p.cell.y, p.cell.z));
  alignas(16) float repeated[64];
  if (!within) repeatBorder(first, repeated);
  const T* const corner = within ? at(first.x, first.y, first.z) : nullptr;
  const std::size_t row = extent_.row(), slice = extent_.slice();
  const auto rowAt = [&](std::size_t j, std::size_t k) {
    return within ? loadSamples(corner + k * slice + j * row) : hn::Load(f, repeated + 4 * (4 * k + j));
  };
  const VRow zero = hn::Zero(f), base = hn::Set(f, reference);
  // Sums over y and z, along x still separate; y, z: how often they are derived.
  VRow sum = zero, sumY = zero, sumZ = zero, sumYY = zero, sumYZ = zero, sumZZ = zero;
  for (std::size_t k = 0; k < 4; ++k) {
    VRow s = zero, sy = zero, syy = zero;
    for (std::size_t j = 0; j < 4; ++j) {
      const VRow samples = hn::Sub(rowAt(j, k), base);
      s = hn::MulAdd(hn::Set(f, wy.w[j]), samples, s);
      sy = hn::MulAdd(hn::Set(f, wy.d1[j]), samples, sy);
      if constexpr (hessian) syy = hn::MulAdd(hn::Set(f, wy.d2[j]), samples, syy);
    }
    const VRow w = hn::Set(f, wz.w[k]), d = hn::Set(f, wz.d1[k]);
    sum = hn::MulAdd(w, s, sum);
    sumY = hn::MulAdd(w, sy, sumY);
    sumZ = hn::MulAdd(d, s, sumZ);
    if constexpr (hessian) {
      sumYY = hn::MulAdd(w, syy, sumYY);
      sumYZ = hn::MulAdd(d, sy, sumYZ);
      sumZZ = hn::MulAdd(hn::Set(f, wz.d2[k]), s, sumZZ);
    }
  }
  const VRow w = hn::Load(f, wx.w), d = hn::Load(f, wx.d1);
  const auto along = [&](VRow weights, VRow v) {
    return hn::GetLane(hn::SumOfLanes(f, hn::Mul(weights, v)));
  };
  PointDerivatives out{};
  out.gradient = {along(d, sum), along(w, sumY), along(w, sumZ)};
  if constexpr (hessian) {
    out.diagonal = {along(hn::Load(f, wx.d2), sum), along(w, sumYY), along(w, sumZZ)};
    out.mixed = {along(d, sumY), along(d, sumZ), along(w, sumYZ)};
  }
  const float all = out.gradient.x + out.gradient.y + out.gradient.z;
  out.known = !std::isnan(all - all);
  out.within = within;
  return out;
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
