// The isosurface tracer with one ray per SIMD lane, for one instruction set. Included by a source that CMake
// makes for each set (isolux_simd_sources() in cmake/IsoluxTargets.cmake); kernelsOf() chooses among them at
// run time.
//
// Groups of rays take turns (steps-inl.h), cells are tested by cells-inl.h.
#include "volume/tracer/kernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume/tracer/simd_kernels-inl.h"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#if HWY_TARGET != HWY_SCALAR  // whose vectors have one lane
#include "volume/simd/derivatives_at-inl.h"
#endif
#include "volume/tracer/steps-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// write(ray, t)
template <bool any, class Write>
HWY_INLINE void traceAll(const View& view, const TraceRay* rays, std::size_t count, const Write& write) {
  view.withVoxels([&](const auto* voxels) {
    using T = std::decay_t<decltype(*voxels)>;
    if (view.wide)
      Tracer<T, any, true>(view, voxels, rays, count).run(write);
    else
      Tracer<T, any, false>(view, voxels, rays, count).run(write);
  });
}

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
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
#if HWY_TARGET == HWY_SCALAR
  std::transform(points, points + count, result, [&](glm::vec3 p) { return borderGradient(view, p); });
#else
  view.withVoxels([&](const auto* voxels) {
    const DerivativesAt samples(voxels, view.dims);
    for (std::size_t n = 0; n < count; ++n) {
      const Located at = locate(view.dims, points[n]);
      const glm::vec3 g =
          samples.isWithin(at.cell) ? samples.template spline<false>(at).gradient : glm::vec3(kNaN);
      result[n] = std::isnan(g.x + g.y + g.z) ? borderGradient(view, points[n]) : g;
    }
  });
#endif
}

extern const Kernels kKernels;
const Kernels kKernels{kSimdSet, firstEntries, anyEntries, gradients};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();
