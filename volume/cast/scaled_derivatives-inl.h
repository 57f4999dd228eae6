// Computes gradient and Hessian of the field at a scale at points: one point at a time, the six coefficients
// of a row in eight lanes. Included once per instruction set by simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_SCALED_DERIVATIVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_SCALED_DERIVATIVES_INL_H
#undef ISOLUX_VOLUME_CAST_SCALED_DERIVATIVES_INL_H
#else
#define ISOLUX_VOLUME_CAST_SCALED_DERIVATIVES_INL_H
#endif

#include <algorithm>

#include <hwy/highway.h>

#include "volume/cast/cast_kernels.h"
#include "volume/field/quintic_weights.h"
#include "volume/simd/derivatives_at-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

using casting::DerivativesView;

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
  HWY_INLINE void store(float* eight) const {
    for (std::size_t i = 0; i < kParts; ++i) hn::StoreU(part[i], Part(), eight + i * kWidth);
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

// Factors of the quintic weights' polynomials, lowest power first, for eight taps.
template <int order>
struct QuinticFactors {
  float of[6 - order][8];
  constexpr QuinticFactors() : of{} {
    for (int power = 0; power < 6 - order; ++power)
      for (int tap = 0; tap < 8; ++tap) of[power][tap] = static_cast<float>(quinticFactor(order, power, tap));
  }
};
template <int order>
inline constexpr QuinticFactors<order> kQuinticFactors;

// Weights of eight taps of which six count.
struct Weights8 {
  Lanes8 w, d1, d2;

  static HWY_INLINE Weights8 at(float t) { return {polynomial<0>(t), polynomial<1>(t), polynomial<2>(t)}; }
  template <int order>
  static HWY_INLINE Lanes8 polynomial(float t) {
    Lanes8 sum = Lanes8::load(kQuinticFactors<order>.of[5 - order]);
    for (int power = 4 - order; power >= 0; --power) {
      Lanes8 next = Lanes8::load(kQuinticFactors<order>.of[power]);
      next.add(t, sum);
      sum = next;
    }
    return sum;
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
  HWY_INLINE PointDerivatives operator()(const Located& p) const;

 private:
  // Six rows of one axis, of which the last may be none, and what they weigh.
  struct Rows {
    int first, count;
    float w[8], d1[8], d2[8];
  };
  // What the eight coefficients of a row from `first` on weigh.
  struct RowWeights {
    int first;
    Weights8 weights;
  };
  template <bool hessian, class LoadEight>
  HWY_INLINE PointDerivatives sums(const RowWeights& x, const Rows& y, const Rows& z, int countY, int countZ,
                                   const LoadEight& loadEight) const;
  template <bool hessian>
  HWY_NOINLINE PointDerivatives nearBorder(const Located& p) const;
  static HWY_INLINE Rows rowsWithin(int cell, float t);
  static Rows rowsFolded(int cell, float t, int n);

  glm::ivec3 dims_;
  const float* coefficients_;
  std::size_t row_, slice_;
};

HWY_INLINE ScaledDerivativesAt::Rows ScaledDerivativesAt::rowsWithin(int cell, float t) {
  Rows rows;
  rows.first = cell - 2;
  rows.count = kQuinticTaps;
  const Weights8 weights = Weights8::at(t);
  weights.w.store(rows.w);
  weights.d1.store(rows.d1);
  weights.d2.store(rows.d2);
  return rows;
}

ScaledDerivativesAt::Rows ScaledDerivativesAt::rowsFolded(int cell, float t, int n) {
  const QuinticTaps<float> taps = quinticTaps(cell, t, n);
  Rows rows{taps.first, std::min(kQuinticTaps, n), {}, {}, {}};
  std::copy_n(taps.weights.w, kQuinticTaps, rows.w);
  std::copy_n(taps.weights.d1, kQuinticTaps, rows.d1);
  std::copy_n(taps.weights.d2, kQuinticTaps, rows.d2);
  return rows;
}

// Sums over y and z, along x still apart; then along x.
template <bool hessian, class LoadEight>
HWY_INLINE PointDerivatives ScaledDerivativesAt::sums(const RowWeights& x, const Rows& y, const Rows& z,
                                                      int countY, int countZ,
                                                      const LoadEight& loadEight) const {
  const float* const corner = coefficients_ + static_cast<std::size_t>(z.first) * slice_ +
                              static_cast<std::size_t>(y.first) * row_ + static_cast<std::size_t>(x.first);
  const float reference = corner[0];
  // y, z: how often they are derived.
  Lanes8 sum = Lanes8::zero(), sumY = sum, sumZ = sum, sumYY = sum, sumYZ = sum, sumZZ = sum;
  for (int k = 0; k < countZ; ++k) {
    const float* const slice = corner + static_cast<std::size_t>(k) * slice_;
    Lanes8 s = Lanes8::zero(), sy = s, syy = s;
    for (int j = 0; j < countY; ++j) {
      const Lanes8 samples = loadEight(slice + static_cast<std::size_t>(j) * row_).less(reference);
      s.add(y.w[j], samples);
      sy.add(y.d1[j], samples);
      if constexpr (hessian) syy.add(y.d2[j], samples);
    }
    sum.add(z.w[k], s);
    sumY.add(z.w[k], sy);
    sumZ.add(z.d1[k], s);
    if constexpr (hessian) {
      sumYY.add(z.w[k], syy);
      sumYZ.add(z.d1[k], sy);
      sumZZ.add(z.d2[k], s);
    }
  }
  const auto& [w, d1, d2] = x.weights;
  PointDerivatives out{};
  out.gradient = {d1.dot(sum), w.dot(sumY), w.dot(sumZ)};
  if constexpr (hessian) {
    out.diagonal = {d2.dot(sum), w.dot(sumYY), w.dot(sumZZ)};
    out.mixed = {d1.dot(sumY), d1.dot(sumZ), w.dot(sumYZ)};
  }
  out.known = true;
  return out;
}

// Where taps lie beyond the border, or eight lanes would end behind it.
template <bool hessian>
HWY_NOINLINE PointDerivatives ScaledDerivativesAt::nearBorder(const Located& p) const {
  const Rows x = rowsFolded(p.cell.x, p.part.x, dims_.x), y = rowsFolded(p.cell.y, p.part.y, dims_.y),
             z = rowsFolded(p.cell.z, p.part.z, dims_.z);
  // Eight lanes may begin before the taps: so none lies behind the row's end.
  const int first = std::max(std::min(x.first, dims_.x - 8), 0), before = x.first - first;
  float w[8] = {}, d1[8] = {}, d2[8] = {};
  std::copy_n(x.w, kQuinticTaps, w + before);
  std::copy_n(x.d1, kQuinticTaps, d1 + before);
  std::copy_n(x.d2, kQuinticTaps, d2 + before);
  const RowWeights along{first, {Lanes8::load(w), Lanes8::load(d1), Lanes8::load(d2)}};
  const auto loadEight = [width = dims_.x](const float* row) {
    if (width >= 8) return Lanes8::load(row);
    float eight[8] = {};
    std::copy_n(row, width, eight);
    return Lanes8::load(eight);
  };
  return sums<hessian>(along, y, z, y.count, z.count, loadEight);
}

template <bool hessian>
HWY_INLINE PointDerivatives ScaledDerivativesAt::operator()(const Located& p) const {
  const glm::ivec3 low = p.cell - 2, high = p.cell + 3 - (dims_ - 1);
  const bool within = low.x >= 0 && low.y >= 0 && low.z >= 0 && high.x <= 0 && high.y <= 0 && high.z <= 0;
  PointDerivatives out;
  if (within && low.x + 8 <= dims_.x)
    out = sums<hessian>({low.x, Weights8::at(p.part.x)}, rowsWithin(p.cell.y, p.part.y),
                        rowsWithin(p.cell.z, p.part.z), kQuinticTaps, kQuinticTaps,
                        [](const float* row) { return Lanes8::load(row); });
  else
    out = nearBorder<hessian>(p);
  out.within = true;  // coefficients go on beyond the border
  return out;
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
