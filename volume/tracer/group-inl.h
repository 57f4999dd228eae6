// Holds the rays of a group, one per SIMD lane, and the entries found. Included once per instruction set by
// simd_kernels-inl.h.
#if defined(ISOLUX_VOLUME_TRACER_GROUP_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_TRACER_GROUP_INL_H
#undef ISOLUX_VOLUME_TRACER_GROUP_INL_H
#else
#define ISOLUX_VOLUME_TRACER_GROUP_INL_H
#endif

#include "volume/simd/cells-inl.h"
#include "volume/tracer/kernels.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// First entries before they are located: at s in [low, high], outside at low, inside at high.
struct Found {
  alignas(64) float b0[kLanes], b1[kLanes], b2[kLanes], b3[kLanes];
  alignas(64) float low[kLanes], high[kLanes], atLow[kLanes], atHigh[kLanes];
  alignas(64) float tIn[kLanes], tOut[kLanes];
};

// What is computed of rays before they are traced, for `count` of them. A ray is scaled by a power of two so
// that the greatest component of its direction is in [1, 2), and begins in the volume. Direction components
// that are zero become 1e-30, so that plane distances are never 0/0. t of the caller = tBegin + t * scale.
template <std::size_t count>
struct PreparedRays {
  alignas(64) float origin[3][count] = {}, direction[3][count] = {}, inverse[3][count] = {};
  alignas(64) float tEnd[count] = {}, isovalue[count] = {}, scale[count] = {}, tBegin[count] = {};
  alignas(64) std::int32_t bin[count] = {}, start[3][count] = {}, ray[count] = {};
};

// Rays that step together.
struct Group : PreparedRays<kLanes> {
  // Where the words of the lanes' boxes are, in pairs of bytes from the table's begin. In wide tables: the
  // block, and the cell in it, or -1.
  alignas(64) std::uint32_t offset[kLanes] = {};
  alignas(64) std::int32_t local[kLanes] = {};
  alignas(64) std::int32_t word[kLanes] = {};
  CellLanes cell;
  VF t;
  MI active, fine, hits, pending;  // fine: at single cells, else at blocks; pending: at a cell to be tested
  MF outside;
  std::uint32_t busy = 0;  // lanes whose result is not yet written
  Found found = {};
};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
