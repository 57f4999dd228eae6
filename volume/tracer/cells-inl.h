// Tests cells, one per SIMD lane: the exact cubic along the segment of a ray through a cell. Included once
// per instruction set by simd_kernels-inl.h.
#if defined(ISOLUX_VOLUME_TRACER_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_TRACER_CELLS_INL_H
#undef ISOLUX_VOLUME_TRACER_CELLS_INL_H
#else
#define ISOLUX_VOLUME_TRACER_CELLS_INL_H
#endif

#include <type_traits>

#include <glm/common.hpp>

#include "volume/tracer/group-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// The field (inside: positive) along a segment through a cell, s in [0, 1].
struct Cubic : BernsteinCoefficients {
  HWY_INLINE VF operator()(VF s) const {
    const F f;
    const VF three = hn::Set(f, 3.0f);
    const VF u = hn::Sub(hn::Set(f, 1.0f), s), s2 = hn::Mul(s, s);
    VF sum = hn::MulAdd(u, b0, hn::Mul(s, hn::Mul(three, b1)));
    sum = hn::MulAdd(u, sum, hn::Mul(s2, hn::Mul(three, b2)));
    return hn::MulAdd(u, sum, hn::Mul(hn::Mul(s2, s), b3));
  }
};

// Returns the cubics in the cells of a group, between t and tOut.
HWY_INLINE Cubic cubicOf(const View& view, const Corners& corners, const Group& g, VF tOut) {
  const F f;
  const VF zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const auto within = [&](VF v) { return hn::Min(hn::Max(v, zero), one); };
  VF p[3], q[3];
  for (int axis = 0; axis < 3; ++axis) {
    const VF d = hn::Load(f, g.direction[axis]);
    const VF from = hn::Sub(hn::Load(f, g.origin[axis]), hn::ConvertTo(f, g.cell[axis]));
    p[axis] = within(hn::MulAdd(g.t, d, from));
    q[axis] = within(hn::MulAdd(tOut, d, from));
  }
  // The isovalue is subtracted first: differences of like numbers are exact.
  const VF iso = hn::Load(f, g.isovalue), scale = hn::Set(f, view.scale);
  return {bernsteinOf(corners, p, q, [&](VF v) { return hn::Mul(scale, hn::Sub(v, iso)); })};
}

// Brackets the first entry from a segment's beginning, or from where it has left the inside that it begins
// in.
template <bool any>
HWY_INLINE MF findBrackets(Group& g, const Cubic& f, MF here, VF tIn, VF tOut, VF& atLow) {
  const F d;
  const VF zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const VF c0 = hn::Sub(f.b1, f.b0), c1 = hn::Sub(f.b2, f.b1), c2 = hn::Sub(f.b3, f.b2);
  const VF h = hn::Sub(c1, c0), a = hn::Sub(hn::Sub(c2, c1), h);
  // NaN where there are no extrema: fails all comparisons.
  const VF root = hn::Sqrt(hn::NegMulAdd(a, c0, hn::Mul(h, h)));
  const MF bends = hn::Gt(h, zero);
  const VF q = hn::IfThenElse(bends, hn::Neg(hn::Add(h, root)), hn::Sub(root, h));
  const VF first = hn::Div(q, a), second = hn::Div(c0, q);
  const VF sMaximum = hn::IfThenElse(bends, first, second), sMinimum = hn::IfThenElse(bends, second, first);
  const VF atMinimum = f(sMinimum), atMaximum = f(sMaximum);
  const MF hasMinimum =
      hn::And(hn::And(hn::Gt(sMinimum, zero), hn::Lt(sMinimum, one)), hn::Lt(atMinimum, zero));
  const MF hasMaximum =
      hn::And(hn::And(hn::Gt(sMaximum, zero), hn::Lt(sMaximum, one)), hn::Gt(atMaximum, zero));
  const MF minimumFirst = hn::Lt(sMinimum, sMaximum);
  const MF toMaximum = hn::And(hasMaximum, hn::Or(hn::Lt(f.b0, zero), hn::And(hasMinimum, minimumFirst)));
  const MF fromMinimum = hn::And(hasMinimum, hn::Or(hn::Not(toMaximum), minimumFirst));
  const VF atHigh = hn::IfThenElse(toMaximum, atMaximum, f.b3);
  atLow = hn::IfThenElse(fromMinimum, atMinimum, f.b0);
  const MF found = hn::And(here, hn::And(hn::Lt(atLow, zero), hn::Gt(atHigh, zero)));
  if constexpr (!any) {
    hn::BlendedStore(f.b0, found, d, g.found.b0);
    hn::BlendedStore(f.b1, found, d, g.found.b1);
    hn::BlendedStore(f.b2, found, d, g.found.b2);
    hn::BlendedStore(f.b3, found, d, g.found.b3);
    hn::BlendedStore(hn::IfThenElseZero(fromMinimum, sMinimum), found, d, g.found.low);
    hn::BlendedStore(hn::IfThenElse(toMaximum, sMaximum, one), found, d, g.found.high);
    hn::BlendedStore(atLow, found, d, g.found.atLow);
    hn::BlendedStore(atHigh, found, d, g.found.atHigh);
    hn::BlendedStore(tIn, found, d, g.found.tIn);
    hn::BlendedStore(tOut, found, d, g.found.tOut);
  }
  return found;
}

// Handles lanes in cells with hidden voxels, one by one. before: lanes that came from outside.
HWY_NOINLINE void passHidden(const View& view, Group& g, MF here, VF tOut, MF before, MF& entered,
                             MF& outside) {
  const F f;
  const I i;
  alignas(64) std::int32_t cells[3][kLanes], entries[kLanes], outsides[kLanes];
  alignas(64) float tIns[kLanes], tOuts[kLanes];
  for (int axis = 0; axis < 3; ++axis) hn::Store(g.cell[axis], i, cells[axis]);
  hn::Store(g.t, f, tIns);
  hn::Store(tOut, f, tOuts);
  hn::Store(hn::VecFromMask(i, hn::RebindMask(i, entered)), i, entries);
  hn::Store(hn::VecFromMask(i, hn::RebindMask(i, outside)), i, outsides);
  const std::uint32_t cameFromOutside = bitsOf(hn::RebindMask(i, before));
  forLanes(bitsOf(hn::RebindMask(i, here)), [&](std::size_t lane) {
    const glm::ivec3 cell(cells[0][lane], cells[1][lane], cells[2][lane]);
    if (!view.shown->hides(cell)) return;
    const auto local = [&](float t) { return inCell(cell, g.origin, g.direction, lane, t); };
    bool isOutside = (cameFromOutside >> lane & 1) != 0;
    const double s = entryIntoShown(view, cell, local(tIns[lane]), local(tOuts[lane]), isOutside);
    entries[lane] = s >= 0.0 ? -1 : 0;
    outsides[lane] = isOutside ? -1 : 0;
    if (s >= 0.0)
      g.found.tIn[lane] = g.found.tOut[lane] =
          tIns[lane] + static_cast<float>(s) * (tOuts[lane] - tIns[lane]);
  });
  entered = hn::RebindMask(f, hn::Ne(hn::Load(i, entries), hn::Zero(i)));
  outside = hn::RebindMask(f, hn::Ne(hn::Load(i, outsides), hn::Zero(i)));
}

// Returns the lanes of `here` whose cells are entered, and updates g.outside.
template <bool any, class T, bool wide>
HWY_INLINE MF testCells(const View& view, const VoxelLanes<T, wide>& voxels, Group& g, MF here, VF tOut) {
  const VF t = g.t;
  const F d;
  const VF zero = hn::Zero(d);
  const MF outside = g.outside;
  const Corners corners = voxels.corners(g.cell, hn::RebindMask(I(), here));
  const Cubic f = cubicOf(view, corners, g, tOut);
  MF gap = noLane();
  if constexpr (std::is_same_v<T, float>) {
    gap = hn::And(here, missing(corners));
    here = hn::AndNot(gap, here);
  }
  // On the surface a segment begins outside where f falls.
  const VF slope = hn::IfThenElse(hn::Eq(f.b1, zero), hn::IfThenElse(hn::Eq(f.b2, zero), f.b3, f.b2), f.b1);
  const MF beginsOutside = hn::Or(hn::Lt(f.b0, zero), hn::And(hn::Eq(f.b0, zero), hn::Lt(slope, zero)));
  const MF atOnce = hn::And(here, hn::AndNot(beginsOutside, outside));
  if constexpr (!any) {
    hn::BlendedStore(t, atOnce, d, g.found.tIn);
    hn::BlendedStore(t, atOnce, d, g.found.tOut);
  }
  const VF least = hn::Min(hn::Min(f.b1, f.b2), f.b3), greatest = hn::Max(hn::Max(f.b1, f.b2), f.b3);
  MF entered = atOnce;
  MF unresolved = hn::And(hn::AndNot(atOnce, here), hn::Or(hn::And(beginsOutside, hn::Gt(greatest, zero)),
                                                           hn::AndNot(beginsOutside, hn::Lt(least, zero))));
  if constexpr (any) {
    const MF sure = hn::And(unresolved, hn::And(hn::Lt(f.b0, zero), hn::Gt(f.b3, zero)));
    entered = hn::Or(entered, sure);
    unresolved = hn::AndNot(sure, unresolved);
  }
  VF atLow = f.b0;
  if (!hn::AllFalse(d, unresolved))
    entered = hn::Or(entered, findBrackets<any>(g, f, unresolved, t, tOut, atLow));
  const MF endsOutside =
      hn::Or(hn::Lt(f.b3, zero), hn::And(hn::Eq(f.b3, zero), hn::Or(hn::Lt(atLow, zero), beginsOutside)));
  g.outside = hn::Or(hn::And(here, endsOutside), hn::AndNot(hn::Or(here, gap), outside));
  if (view.shown) passHidden(view, g, here, tOut, outside, entered, g.outside);
  return entered;
}

// Returns t of the first entries of lanes that have one.
HWY_INLINE VF roots(const Group& g) {
  const F d;
  const Cubic f{
      {hn::Load(d, g.found.b0), hn::Load(d, g.found.b1), hn::Load(d, g.found.b2), hn::Load(d, g.found.b3)}};
  VF low = hn::Load(d, g.found.low), high = hn::Load(d, g.found.high);
  VF atLow = hn::Load(d, g.found.atLow), atHigh = hn::Load(d, g.found.atHigh);
  const VF half = hn::Set(d, 0.5f), zero = hn::Zero(d);
  VF s = low;
  for (int step = 0; step < 8; ++step) {  // regula falsi, Illinois
    const VF next = hn::Sub(low, hn::Div(hn::Mul(atLow, hn::Sub(high, low)), hn::Sub(atHigh, atLow)));
    // Where both ends are 0 the root is found.
    s = hn::IfThenElse(hn::Eq(next, next), next, s);
    const VF value = f(s);
    const MF same = hn::Not(hn::Xor(hn::Gt(value, zero), hn::Gt(atHigh, zero)));
    low = hn::IfThenElse(same, low, high);
    atLow = hn::IfThenElse(same, hn::Mul(half, atLow), atHigh);
    high = s;
    atHigh = value;
  }
  const VF tIn = hn::Load(d, g.found.tIn), tOut = hn::Load(d, g.found.tOut);
  return hn::MulAdd(s, hn::Sub(tOut, tIn), tIn);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
