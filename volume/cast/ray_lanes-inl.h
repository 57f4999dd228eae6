// Holds rays in voxel space and the cells that they are in, one per SIMD lane. Included once per instruction
// set by simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_RAY_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_RAY_LANES_INL_H
#undef ISOLUX_VOLUME_CAST_RAY_LANES_INL_H
#else
#define ISOLUX_VOLUME_CAST_RAY_LANES_INL_H
#endif

#include "volume/cast/cast_kernels.h"
#include "volume/simd/cells-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

using casting::CastView;

// Zero direction components are replaced by 1e-30 so that plane distances are never 0/0.
struct RayLanes {
  VF origin[3], direction[3], inverse[3];
};

// The segments [t, tEnd] of the rays of active lanes. For lanes in `continued`, t is itself a crossing and
// `inside` is the state behind it, a bit for each surface; for others it is evaluated from the field.
struct RaySegments {
  RayLanes ray;
  VF t, tEnd;
  MF active, continued;
  VI inside;
};

HWY_INLINE RayLanes rayLanes(const CastView& view, const VF (&origin)[3], const VF (&direction)[3]) {
  const F f;
  const VF creep = hn::Set(f, 1e-30f);
  RayLanes ray;
  for (int axis = 0; axis < 3; ++axis) {
    const VF last = hn::Set(f, static_cast<float>(view.dims[axis] - 1));
    const VF inward = hn::IfThenElse(hn::Ge(origin[axis], last), hn::Neg(creep), creep);
    ray.origin[axis] = origin[axis];
    ray.direction[axis] = hn::IfThenElse(hn::Lt(hn::Abs(direction[axis]), creep), inward, direction[axis]);
    ray.inverse[axis] = hn::Div(hn::Set(f, 1.0f), ray.direction[axis]);
  }
  return ray;
}

// Returns the cells of points in the volume.
HWY_INLINE CellLanes cellsAt(const CastView& view, const VF (&p)[3]) {
  CellLanes cell;
  for (int axis = 0; axis < 3; ++axis) {
    const VF last = hn::Set(F(), static_cast<float>(view.dims[axis] - 2));
    cell[axis] = hn::ConvertTo(I(), hn::Min(hn::Max(p[axis], hn::Zero(F())), last));
  }
  return cell;
}

// Returns where rays are in their cells at t, along an axis: [0, 1].
HWY_INLINE VF inCell(const RayLanes& ray, int axis, const CellLanes& cell, VF t) {
  const F f;
  const VF p = hn::Sub(hn::MulAdd(t, ray.direction[axis], ray.origin[axis]), hn::ConvertTo(f, cell[axis]));
  return hn::Min(hn::Max(p, hn::Zero(f)), hn::Set(f, 1.0f));
}

// Returns the lanes on the other side of f = 0 than `inside`; f = 0 is inside.
HWY_INLINE MF changesSide(VF f, MF inside) {
  return hn::Xor(hn::Lt(f, hn::Zero(F())), hn::Not(inside));
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
