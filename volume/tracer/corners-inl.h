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

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
