// Gradient and Hessian of the field at a scale at points: one point at a time, the six coefficients of a row
// in eight lanes. Included once per instruction set by simd_cast.cpp.
#if defined(ISOLUX_VOLUME_CAST_SCALED_DERIVATIVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_SCALED_DERIVATIVES_INL_H
#undef ISOLUX_VOLUME_CAST_SCALED_DERIVATIVES_INL_H
#else
#define ISOLUX_VOLUME_CAST_SCALED_DERIVATIVES_INL_H
#endif

#include <algorithm>

#include <hwy/highway.h>

#include "volume/cast/derivatives_at-inl.h"
#include "volume/field/quintic_weights.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

// Eight lanes: one vector, or two where vectors have four.
struct Lanes8 {
  using Part = hn::CappedTag<float, 8>;
  using V = hn::Vec<Part>;
  static constexpr std::size_t kWidth = hn::MaxLanes(Part()), kParts = 8 / kWidth;
  V part[kParts];

  static HWY_INLINE Lanes8 zero() {
    Lanes8 out;
    for (std::size_t i = 0; i < kParts; ++i) out.part[i] = hn::Zero(Part());
    return out;
  }
  static HWY_INLINE Lanes8 load(const float* eight) {
    Lanes8 out;
    for (std::size_t i = 0; i < kParts; ++i) out.part[i] = hn::LoadU(Part(), eight + i * kWidth);
    return out;
  }
  HWY_INLINE Lanes8 less(float reference) const {
    Lanes8 out;
    for (std::size_t i = 0; i < kParts; ++i) out.part[i] = hn::Sub(part[i], hn::Set(Part(), reference));
    return out;
  }
  HWY_INLINE void add(float weight, const Lanes8& v) {
    for (std::size_t i = 0; i < kParts; ++i)
      part[i] = hn::MulAdd(hn::Set(Part(), weight), v.part[i], part[i]);
  }
  HWY_INLINE float dot(const Lanes8& v) const {
    V sum = hn::Mul(part[0], v.part[0]);
    for (std::size_t i = 1; i < kParts; ++i) sum = hn::MulAdd(part[i], v.part[i], sum);
    return hn::GetLane(hn::SumOfLanes(Part(), sum));
  }
};

class ScaledDerivativesAt {
 public:
  explicit ScaledDerivativesAt(const DerivativesView& view)
      : dims_(view.dims),
        coefficients_(view.scaled),
        row_(static_cast<std::size_t>(view.dims.x)),
        slice_(row_ * static_cast<std::size_t>(view.dims.y)) {}

  template <bool hessian>
  HWY_INLINE PointDerivatives operator()(glm::vec4 point) const;

 private:
  // What the eight coefficients of a row from `first` on weigh.
  struct RowWeights {
    int first;
    Lanes8 w, d1, d2;
  };
  HWY_INLINE RowWeights rowWeights(const QuinticTaps<float>& taps) const;
  HWY_INLINE Lanes8 eightOf(const float* row, int first) const;

  glm::ivec3 dims_;
  const float* coefficients_;
  std::size_t row_, slice_;
};

// Eight lanes may begin before the taps: so none lies behind the row's end.
HWY_INLINE ScaledDerivativesAt::RowWeights ScaledDerivativesAt::rowWeights(
    const QuinticTaps<float>& taps) const {
  const int first = std::max(std::min(taps.first, dims_.x - 8), 0), before = taps.first - first;
  float w[8] = {}, d1[8] = {}, d2[8] = {};
  for (int i = 0; i < kQuinticTaps; ++i) {
    w[before + i] = taps.weights.w[i];
    d1[before + i] = taps.weights.d1[i];
    d2[before + i] = taps.weights.d2[i];
  }
  return {first, Lanes8::load(w), Lanes8::load(d1), Lanes8::load(d2)};
}

HWY_INLINE Lanes8 ScaledDerivativesAt::eightOf(const float* row, int first) const {
  if (dims_.x >= 8) return Lanes8::load(row + first);
  float eight[8] = {};
  std::copy_n(row, dims_.x, eight);
  return Lanes8::load(eight);
}

template <bool hessian>
HWY_INLINE PointDerivatives ScaledDerivativesAt::operator()(glm::vec4 point) const {
  const Located p = locate(dims_, point);
  const QuinticTaps<float> x = quinticTaps(p.cell.x, p.part.x, dims_.x),
                           y = quinticTaps(p.cell.y, p.part.y, dims_.y),
                           z = quinticTaps(p.cell.z, p.part.z, dims_.z);
  const RowWeights along = rowWeights(x);
  const auto rowAt = [&](int j, int k) {
    return coefficients_ + static_cast<std::size_t>(z.first + k) * slice_ +
           static_cast<std::size_t>(y.first + j) * row_;
  };
  const float reference = *(rowAt(0, 0) + x.first);
  const int countY = std::min(kQuinticTaps, dims_.y), countZ = std::min(kQuinticTaps, dims_.z);
  // Sums over y and z, along x still apart; y, z: how often they are derived.
  Lanes8 sum = Lanes8::zero(), sumY = sum, sumZ = sum, sumYY = sum, sumYZ = sum, sumZZ = sum;
  for (int k = 0; k < countZ; ++k) {
    Lanes8 s = Lanes8::zero(), sy = s, syy = s;
    for (int j = 0; j < countY; ++j) {
      const Lanes8 samples = eightOf(rowAt(j, k), along.first).less(reference);
      s.add(y.weights.w[j], samples);
      sy.add(y.weights.d1[j], samples);
      if constexpr (hessian) syy.add(y.weights.d2[j], samples);
    }
    const float w = z.weights.w[k], d = z.weights.d1[k];
    sum.add(w, s);
    sumY.add(w, sy);
    sumZ.add(d, s);
    if constexpr (hessian) {
      sumYY.add(w, syy);
      sumYZ.add(d, sy);
      sumZZ.add(z.weights.d2[k], s);
    }
  }
  PointDerivatives out{};
  out.gradient = {along.d1.dot(sum), along.w.dot(sumY), along.w.dot(sumZ)};
  if constexpr (hessian) {
    out.diagonal = {along.d2.dot(sum), along.w.dot(sumYY), along.w.dot(sumZZ)};
    out.mixed = {along.d1.dot(sumY), along.d1.dot(sumZ), along.w.dot(sumYZ)};
  }
  const glm::ivec3 low = p.cell - 2, high = p.cell + 3 - (dims_ - 1);
  out.known = true;
  out.within = low.x >= 0 && low.y >= 0 && low.z >= 0 && high.x <= 0 && high.y <= 0 && high.z <= 0;
  return out;
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
