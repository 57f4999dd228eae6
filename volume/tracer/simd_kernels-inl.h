// The isosurface tracer with one ray per SIMD lane, for one instruction set. Included by a source that CMake
// makes for each set (isolux_simd_sources() in cmake/IsoluxTargets.cmake); simdKernels() chooses among them
// at run time. Indices of voxels, and offsets of pairs of bytes in the table, have 32 bits (TracerReach).
//
// Groups of rays take turns (steps-inl.h), cells are tested by cells-inl.h.
#include "volume/tracer/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume/tracer/simd_kernels-inl.h"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include "volume/tracer/gradients-inl.h"
#include "volume/tracer/steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

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

extern const Kernels kKernels;
const Kernels kKernels{kSimdSet, firstEntries, anyEntries, gradients};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();
