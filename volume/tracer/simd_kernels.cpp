// The isosurface tracer with one ray per SIMD lane, compiled for every instruction set and chosen at run
// time. Indices of voxels, and offsets of pairs of bytes in the table, have 32 bits (TracerReach).
//
// Groups of rays take turns (steps-inl.h), cells are tested by
// cells-inl.h.
#include "volume/tracer/kernels.h"

// These do not differ for this code, or have vectors without a size known here. Where none is left the scalar
// kernels serve.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume/tracer/simd_kernels.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "volume/tracer/gradients-inl.h"
#include "volume/tracer/steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

// write(ray, t)
template <bool any, class Write>
HWY_INLINE void traceAll(const View& view, const TraceRay* rays, std::size_t count, const Write& write) {
  if (view.signed16)
    Tracer<std::int16_t, any>(view, view.signed16, rays, count).run(write);
  else if (view.unsigned16)
    Tracer<std::uint16_t, any>(view, view.unsigned16, rays, count).run(write);
  else
    Tracer<float, any>(view, view.float32, rays, count).run(write);
}

constexpr std::size_t kMostRays = std::size_t{1} << 30;  // at once: lanes know their ray by 32 bits

void firstEntries(const View& view, const TraceRay* rays, std::size_t count, float* t) {
  for (; count > kMostRays; count -= kMostRays, rays += kMostRays, t += kMostRays)
    firstEntries(view, rays, kMostRays, t);
  traceAll<false>(view, rays, count, [t](std::size_t ray, float found) { t[ray] = found; });
}

void anyEntries(const View& view, const TraceRay* rays, std::size_t count, std::uint8_t* hit) {
  for (; count > kMostRays; count -= kMostRays, rays += kMostRays, hit += kMostRays)
    anyEntries(view, rays, kMostRays, hit);
  traceAll<true>(view, rays, count,
                 [hit](std::size_t ray, float found) { hit[ray] = found < kInfinity ? 1 : 0; });
}

void gradients(const View& view, const glm::vec3* points, std::size_t count, glm::vec3* result) {
  if (view.signed16)
    gradientsOf(view, view.signed16, points, count, result);
  else if (view.unsigned16)
    gradientsOf(view, view.unsigned16, points, count, result);
  else
    gradientsOf(view, view.float32, points, count, result);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolux::volume::tracing {

namespace {

#define ISOLUX_KERNELS(space, target, name)                                                \
  if (wanted == (target)) {                                                                \
    static constexpr Kernels kernels{target, name, space::firstEntries, space::anyEntries, \
                                     space::gradients};                                    \
    return &kernels;                                                                       \
  }

const Kernels* compiledKernels(TracerTarget wanted) {
#if HWY_TARGETS & HWY_SSE4
  ISOLUX_KERNELS(N_SSE4, TracerTarget::sse4, "SSE4")
#endif
#if HWY_TARGETS & HWY_AVX2
  ISOLUX_KERNELS(N_AVX2, TracerTarget::avx2, "AVX2")
#endif
#if HWY_TARGETS & HWY_AVX3
  ISOLUX_KERNELS(N_AVX3, TracerTarget::avx512, "AVX-512")
#endif
#if HWY_TARGETS & HWY_NEON
  ISOLUX_KERNELS(N_NEON, TracerTarget::neon, "NEON")
#endif
  (void)wanted;
  return nullptr;
}
#undef ISOLUX_KERNELS

std::int64_t highwayTarget(TracerTarget target) {
  switch (target) {
    case TracerTarget::sse4:
      return HWY_SSE4;
    case TracerTarget::avx2:
      return HWY_AVX2;
    case TracerTarget::avx512:
      return HWY_AVX3;
    case TracerTarget::neon:
      return HWY_NEON;
    default:
      return 0;
  }
}

}  // namespace

const Kernels* simdKernels(TracerTarget target) {
  return (hwy::SupportedTargets() & highwayTarget(target)) != 0 ? compiledKernels(target) : nullptr;
}

}  // namespace isolux::volume::tracing
#endif
