// The eight voxels of a cell, of one cell per SIMD lane, as floats. Included once per instruction set.
#if defined(ISOLUX_VOLUME_TRACER_CORNERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_TRACER_CORNERS_INL_H
#undef ISOLUX_VOLUME_TRACER_CORNERS_INL_H
#else
#define ISOLUX_VOLUME_TRACER_CORNERS_INL_H
#endif

#include <cstring>
#include <type_traits>

#include "volume/tracer/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// The values at a cell's corners x and x + 1.
struct Edge {
  VF low, high;
};

// The four edges along x of every lane's cell.
struct Corners {
  Edge e00, e10, e01, e11;
};

HWY_INLINE Edge edgeOf(const std::int16_t*, VI pair) {
  return {hn::ConvertTo(F(), hn::ShiftRight<16>(hn::ShiftLeft<16>(pair))),
          hn::ConvertTo(F(), hn::ShiftRight<16>(pair))};
}

HWY_INLINE Edge edgeOf(const std::uint16_t*, VI pair) {
  return {hn::ConvertTo(F(), hn::And(pair, hn::Set(I(), 0xffff))),
          hn::ConvertTo(F(), hn::BitCast(I(), hn::ShiftRight<16>(hn::BitCast(U(), pair))))};
}

HWY_INLINE Edge edgeOf(const float*, const std::int64_t* pairs) {
  const hn::Repartition<std::int64_t, F> l;
  const VF a = hn::BitCast(F(), hn::Load(l, pairs)), b = hn::BitCast(F(), hn::Load(l, pairs + kLanes / 2));
  return {hn::ConcatEven(F(), b, a), hn::ConcatOdd(F(), b, a)};
}

// Of the two lower bytes.
HWY_INLINE Edge edgeOf(const std::int8_t*, VI pair) {
  return {hn::ConvertTo(F(), hn::ShiftRight<24>(hn::ShiftLeft<24>(pair))),
          hn::ConvertTo(F(), hn::ShiftRight<24>(hn::ShiftLeft<16>(pair)))};
}

HWY_INLINE Edge edgeOf(const std::uint8_t*, VI pair) {
  const VI byte = hn::Set(I(), 0xff);
  return {hn::ConvertTo(F(), hn::And(pair, byte)),
          hn::ConvertTo(F(), hn::And(hn::ShiftRight<8>(pair), byte))};
}

template <class T>
HWY_INLINE Edge edgeOf(const T* type, const std::int32_t* pairs) {
  return edgeOf(type, hn::Load(I(), pairs));
}

// The cells whose lowest corners are voxels at[lane].
template <class T, class Index>
HWY_INLINE Corners loadCorners(const T* voxels, const Index* at, std::size_t row, std::size_t slice) {
  using Pair = std::conditional_t<std::is_same_v<T, float>, std::int64_t, std::int32_t>;
  alignas(64) Pair pairs[4][kLanes];
  const auto load = [](Pair& pair, const T* corner) {
    if constexpr (sizeof(T) == 1) pair = 0;
    std::memcpy(&pair, corner, 2 * sizeof(T));
  };
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const T* corner = voxels + at[lane];
    load(pairs[0][lane], corner);
    load(pairs[1][lane], corner + row);
    load(pairs[2][lane], corner + slice);
    load(pairs[3][lane], corner + slice + row);
  }
  return {edgeOf(voxels, pairs[0]), edgeOf(voxels, pairs[1]), edgeOf(voxels, pairs[2]),
          edgeOf(voxels, pairs[3])};
}

template <class T>
HWY_INLINE Corners loadCorners(const T* voxels, VI index, std::size_t row, std::size_t slice) {
  alignas(64) std::uint32_t at[kLanes];
  hn::Store(hn::BitCast(U(), index), U(), at);
  return loadCorners(voxels, at, row, slice);
}

// A place in [0, 1] between two values. Of values on one side of 0 never one on the other, however far apart
// they are.
struct Between {
  VF at, rest;
  explicit HWY_INLINE Between(VF s) : at(s), rest(hn::Sub(hn::Set(F(), 1.0f), s)) {}
  HWY_INLINE VF operator()(VF a, VF b) const { return hn::MulAdd(at, b, hn::Mul(rest, a)); }
};

struct BernsteinCoefficients {
  VF b0, b1, b2, b3;
};

// Of the trilinear function along the stretch of its cell from p to q: its polar form at the two ends.
// changed(v): what is interpolated of a corner's value.
template <class Changed>
HWY_INLINE BernsteinCoefficients bernsteinOf(const Corners& c, const VF (&p)[3], const VF (&q)[3],
                                             const Changed& changed) {
  const Between px(p[0]), py(p[1]), pz(p[2]), qx(q[0]), qy(q[1]), qz(q[2]);
  const VF a00 = changed(c.e00.low), a10 = changed(c.e10.low), a01 = changed(c.e01.low),
           a11 = changed(c.e11.low);
  const VF b00 = changed(c.e00.high), b10 = changed(c.e10.high), b01 = changed(c.e01.high),
           b11 = changed(c.e11.high);
  const VF p00 = px(a00, b00), p10 = px(a10, b10), p01 = px(a01, b01), p11 = px(a11, b11);
  const VF q00 = qx(a00, b00), q10 = qx(a10, b10), q01 = qx(a01, b01), q11 = qx(a11, b11);
  const VF pp0 = py(p00, p10), pp1 = py(p01, p11), pq0 = qy(p00, p10), pq1 = qy(p01, p11);
  const VF qp0 = py(q00, q10), qp1 = py(q01, q11), qq0 = qy(q00, q10), qq1 = qy(q01, q11);
  const VF third = hn::Set(F(), 1.0f / 3.0f);
  return {pz(pp0, pp1), hn::Mul(third, hn::Add(hn::Add(pz(qp0, qp1), pz(pq0, pq1)), qz(pp0, pp1))),
          hn::Mul(third, hn::Add(hn::Add(pz(qq0, qq1), qz(qp0, qp1)), qz(pq0, pq1))), qz(qq0, qq1)};
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
