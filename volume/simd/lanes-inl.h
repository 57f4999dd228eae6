// Names the vectors of an instruction set, and visits the lanes of a mask. Included once per instruction set.
#if defined(ISOLUX_VOLUME_SIMD_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_SIMD_LANES_INL_H
#undef ISOLUX_VOLUME_SIMD_LANES_INL_H
#else
#define ISOLUX_VOLUME_SIMD_LANES_INL_H
#endif

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <hwy/highway.h>

#include "volume/simd/simd_set.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using I = hn::ScalableTag<std::int32_t>;
using U = hn::ScalableTag<std::uint32_t>;
using VF = hn::Vec<F>;
using VI = hn::Vec<I>;
using MF = hn::Mask<F>;
using MI = hn::Mask<I>;
constexpr std::size_t kLanes = hn::MaxLanes(F());

constexpr float kInfinity = std::numeric_limits<float>::infinity();

constexpr SimdSet kSimdSet = HWY_TARGET == HWY_AVX3   ? SimdSet{TracerTarget::avx512, "AVX-512", HWY_TARGET}
                             : HWY_TARGET == HWY_AVX2 ? SimdSet{TracerTarget::avx2, "AVX2", HWY_TARGET}
                             : HWY_TARGET == HWY_SSE4 ? SimdSet{TracerTarget::sse4, "SSE4", HWY_TARGET}
                             : HWY_TARGET == HWY_NEON ? SimdSet{TracerTarget::neon, "NEON", HWY_TARGET}
                                                      : SimdSet{TracerTarget::scalar, "scalar", HWY_TARGET};

HWY_INLINE MF noLane() {
  return hn::Lt(hn::Zero(F()), hn::Zero(F()));
}

HWY_INLINE std::uint32_t bitsOf(MI mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(I(), mask, bytes);
  std::uint32_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits & static_cast<std::uint32_t>((std::uint64_t{1} << kLanes) - 1);
}

// Calls visit(lane) for each lane whose bit is set.
template <class Visit>
HWY_INLINE void forLanes(std::uint32_t bits, const Visit& visit) {
  for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
