// The finder of crossings for a field and its samples. Included once per instruction set by simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_CROSSING_FINDERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_CROSSING_FINDERS_INL_H
#undef ISOLUX_VOLUME_CAST_CROSSING_FINDERS_INL_H
#else
#define ISOLUX_VOLUME_CAST_CROSSING_FINDERS_INL_H
#endif

#include <variant>

#include "volume/cast/cubic_cells-inl.h"
#include "volume/cast/first_crossing-inl.h"
#include "volume/cast/trilinear_cells-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// Calls use(finder).
template <class Use>
HWY_INLINE void withFinder(const CastView& view, const Use& use) {
  std::visit(
      [&](const auto* samples) {
        if (view.cubic)
          use(CrossingFinder(view, CubicCells(view, samples)));
        else
          use(CrossingFinder(view, TrilinearCells(view, samples)));
      },
      view.samples);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
