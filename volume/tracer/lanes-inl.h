// The rays of a group, one per SIMD lane, and what is known of those that have entered. Included once per
// instruction set by simd_kernels-inl.h.
#if defined(ISOLUX_VOLUME_ISOSURFACE_TRACER_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_ISOSURFACE_TRACER_LANES_INL_H
#undef ISOLUX_VOLUME_ISOSURFACE_TRACER_LANES_INL_H
#else
#define ISOLUX_VOLUME_ISOSURFACE_TRACER_LANES_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <hwy/highway.h>

#include "volume/tracer/simd_set.h"

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
                                                      : SimdSet{TracerTarget::neon, "NEON", HWY_TARGET};

HWY_INLINE std::uint32_t bitsOf(MI mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(I(), mask, bytes);
  std::uint32_t bits;
  std::memcpy(&bits, bytes, sizeof bits);
  return bits & static_cast<std::uint32_t>((std::uint64_t{1} << kLanes) - 1);
}

// A first entry that is known but for its place: in s in [low, high], outside at low, inside at high.
struct Found {
  alignas(64) float b0[kLanes], b1[kLanes], b2[kLanes], b3[kLanes];
  alignas(64) float low[kLanes], high[kLanes], atLow[kLanes], atHigh[kLanes];
  alignas(64) float tIn[kLanes], tOut[kLanes];
};

// Rays that step together, one per lane (PreparedRay).
struct Group {
  alignas(64) float origin[3][kLanes] = {}, direction[3][kLanes] = {}, inverse[3][kLanes] = {};
  alignas(64) float tEnd[kLanes] = {}, isovalue[kLanes] = {};
  alignas(64) std::int32_t bin[kLanes] = {}, start[3][kLanes] = {};
  alignas(64) std::uint32_t offset[kLanes] = {};  // of the words, in pairs of bytes from the table's begin
  alignas(64) std::int32_t word[kLanes] = {};
  VI cx, cy, cz;
  VF t;
  MI alive, fine, hits, waits;  // fine: at single cells, else at blocks
  MF outside;
  alignas(64) float scale[kLanes] = {}, tBegin[kLanes] = {};
  alignas(64) std::int32_t ray[kLanes] = {};
  std::uint32_t busy = 0;  // lanes whose result is not yet written
  Found found = {};
};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
