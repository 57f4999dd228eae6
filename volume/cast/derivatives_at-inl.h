// Gradient and Hessian at points: one point at a time, four samples of a row at once. Included once per
// instruction set by simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_DERIVATIVES_AT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_DERIVATIVES_AT_INL_H
#undef ISOLUX_VOLUME_CAST_DERIVATIVES_AT_INL_H
#else
#define ISOLUX_VOLUME_CAST_DERIVATIVES_AT_INL_H
#endif

#include <cmath>
#include <cstring>

#include <hwy/highway.h>
#include <glm/common.hpp>

#include "volume/cast/cast_kernels.h"
#include "volume/field/cubic_weights.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

namespace hn = hwy::HWY_NAMESPACE;

using casting::DerivativesView;
using casting::PointDerivatives;
using Row = hn::FixedTag<float, 4>;
using VRow = hn::Vec<Row>;

HWY_INLINE VRow loadSamples(const float* row) {
  return hn::LoadU(Row(), row);
}

template <class T>
HWY_INLINE VRow loadSamples(const T* row) {
  const hn::FixedTag<std::int32_t, 4> wide;
  if constexpr (sizeof(T) == 1) {
    alignas(4) T four[4];
    std::memcpy(four, row, sizeof four);
    return hn::ConvertTo(Row(), hn::PromoteTo(wide, hn::LoadU(hn::FixedTag<T, 4>(), four)));
  } else {
    return hn::ConvertTo(Row(), hn::PromoteTo(wide, hn::LoadU(hn::FixedTag<T, 4>(), row)));
  }
}

// The cell that a point in the volume lies in, and where in it.
struct Located {
  glm::ivec3 cell;
  glm::vec3 part;
};

HWY_INLINE Located locate(glm::ivec3 dims, glm::vec4 point) {
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
  DerivativesAt(const DerivativesView& view, const T* voxels)
      : view_(view),
        voxels_(voxels),
        row_(static_cast<std::size_t>(view.dims.x)),
        slice_(row_ * static_cast<std::size_t>(view.dims.y)) {}

  // All are 0 where a corner of the cell is missing.
  HWY_NOINLINE PointDerivatives trilinear(glm::vec4 point) const;
  // Of the B-spline whose coefficients the voxels are; not known where one of the 64 is missing.
  template <bool hessian>
  HWY_NOINLINE PointDerivatives spline(glm::vec4 point) const;

 private:
  // The 4^3 samples from `first` on; beyond the border samples repeat.
  HWY_NOINLINE void repeatBorder(glm::ivec3 first, float* repeated) const;
  HWY_INLINE const T* at(int x, int y, int z) const {
    return voxels_ + static_cast<std::size_t>(z) * slice_ + static_cast<std::size_t>(y) * row_ +
           static_cast<std::size_t>(x);
  }
  const DerivativesView& view_;
  const T* voxels_;
  std::size_t row_, slice_;
};

template <class T>
HWY_NOINLINE PointDerivatives DerivativesAt<T>::trilinear(glm::vec4 point) const {
  const Located p = locate(view_.dims, point);
  const T* const corner = at(p.cell.x, p.cell.y, p.cell.z);
  const auto reference = static_cast<float>(corner[0]);
  // Of values like 1e6 + small only the small part may be weighted.
  const auto less = [&](std::size_t i) { return static_cast<float>(corner[i]) - reference; };
  const float c000 = less(0), c100 = less(1), c010 = less(row_), c110 = less(row_ + 1), c001 = less(slice_),
              c101 = less(slice_ + 1), c011 = less(slice_ + row_), c111 = less(slice_ + row_ + 1);
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
  const glm::ivec3 last = view_.dims - 1;
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const glm::ivec3 sample = glm::clamp(first + glm::ivec3(i, j, k), glm::ivec3(0), last);
        *repeated++ = static_cast<float>(*at(sample.x, sample.y, sample.z));
      }
}

template <class T>
template <bool hessian>
HWY_NOINLINE PointDerivatives DerivativesAt<T>::spline(glm::vec4 point) const {
  const Row f;
  const Located p = locate(view_.dims, point);
  alignas(16) const CubicWeights wx = cubicWeights(p.part.x);
  const CubicWeights wy = cubicWeights(p.part.y), wz = cubicWeights(p.part.z);
  const glm::ivec3 first = p.cell - 1, last = view_.dims - 1;
  const bool within = first.x >= 0 && first.y >= 0 && first.z >= 0 && first.x + 3 <= last.x &&
                      first.y + 3 <= last.y && first.z + 3 <= last.z;
  const auto reference = static_cast<float>(*at(p.cell.x, p.cell.y, p.cell.z));
  alignas(16) float repeated[64];
  if (!within) repeatBorder(first, repeated);
  const auto rowAt = [&](int j, int k) {
    return within ? loadSamples(at(first.x, first.y + j, first.z + k))
                  : hn::Load(f, repeated + 4 * (4 * k + j));
  };
  const VRow zero = hn::Zero(f), base = hn::Set(f, reference);
  // Sums over y and z, along x still apart; y, z: how often they are derived.
  VRow sum = zero, sumY = zero, sumZ = zero, sumYY = zero, sumYZ = zero, sumZZ = zero;
  for (int k = 0; k < 4; ++k) {
    VRow s = zero, sy = zero, syy = zero;
    for (int j = 0; j < 4; ++j) {
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

// H_w = A^-T H_v A^-1, of the lower triangle.
HWY_INLINE void toWorld(const glm::mat3& m, glm::vec3& diagonal, glm::vec3& mixed) {
  const glm::vec3 h0(diagonal.x, mixed.x, mixed.y), h1(mixed.x, diagonal.y, mixed.z),
      h2(mixed.y, mixed.z, diagonal.z);
  glm::vec3 rows[3];  // of A^-T H
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) rows[i][k] = m[0][i] * h0[k] + m[1][i] * h1[k] + m[2][i] * h2[k];
  const auto entry = [&](int i, int j) {
    return rows[i].x * m[0][j] + rows[i].y * m[1][j] + rows[i].z * m[2][j];
  };
  diagonal = {entry(0, 0), entry(1, 1), entry(2, 2)};
  mixed = {entry(0, 1), entry(0, 2), entry(1, 2)};
}

HWY_INLINE glm::vec4 withFlag(glm::vec3 v, float scale, bool flag) {
  return {v.x * scale, v.y * scale, v.z * scale, flag ? 1.0f : 0.0f};
}

// Writes derivativesAt(point) of each point of the target, carried to world.
template <bool hessian, class At>
HWY_INLINE void storeDerivatives(const DerivativesView& view, const casting::DerivativesTarget& target,
                                 const At& derivativesAt) {
  const glm::vec4 none(0.0f);
  const glm::mat3& m = view.worldFromVoxel;
  for (std::size_t i = 0; i < target.count; ++i) {
    const glm::vec4 point = target.points[i];
    target.gradient[i] = none;
    if (hessian) target.diagonal[i] = target.mixed[i] = none;
    if (point.w < 0.0f) continue;
    PointDerivatives at = derivativesAt(point);
    const glm::vec3 g = at.gradient;
    target.gradient[i] =
        withFlag({m[0].x * g.x + m[1].x * g.y + m[2].x * g.z, m[0].y * g.x + m[1].y * g.y + m[2].y * g.z,
                  m[0].z * g.x + m[1].z * g.y + m[2].z * g.z},
                 view.dataUnits, true);
    if (!hessian || !at.known) continue;
    toWorld(m, at.diagonal, at.mixed);
    target.diagonal[i] = withFlag(at.diagonal, view.dataUnits, true);
    target.mixed[i] = withFlag(at.mixed, view.dataUnits, at.within);
  }
}

// Sample: int16_t ... of the voxels; Spline: of what the spline is made of.
template <bool hessian, class Sample, class Spline>
HWY_INLINE void derivativesOf(const DerivativesView& view, const Sample* samples, const Spline* spline,
                              const casting::DerivativesTarget& target) {
  const DerivativesAt<Sample> cells(view, samples);
  const DerivativesAt<Spline> splines(view, spline);
  storeDerivatives<hessian>(view, target, [&](glm::vec4 point) {
    PointDerivatives at{};
    if (view.cubic) {
      at = splines.template spline<hessian>(point);
      if (!at.known) at.gradient = cells.trilinear(point).gradient;
    } else {
      at = cells.trilinear(point);
      at.within = true;
    }
    return at;
  });
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
