// The test of cells, one per SIMD lane: the exact cubic along the stretch of a ray through a cell. Included
// once per instruction set by simd_kernels-inl.h.
#if defined(ISOLUX_VOLUME_ISOSURFACE_TRACER_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_ISOSURFACE_TRACER_CELLS_INL_H
#undef ISOLUX_VOLUME_ISOSURFACE_TRACER_CELLS_INL_H
#else
#define ISOLUX_VOLUME_ISOSURFACE_TRACER_CELLS_INL_H
#endif

#include <bit>
#include <type_traits>

#include <glm/common.hpp>

#include "volume/tracer/corners-inl.h"
#include "volume/tracer/kernels.h"
#include "volume/tracer/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// The field (inside: positive) along a stretch through a cell, s in [0, 1], in Bernstein form.
struct Cubic {
  VF b0, b1, b2, b3;

  HWY_INLINE VF operator()(VF s) const {
    const F f;
    const VF three = hn::Set(f, 3.0f);
    const VF u = hn::Sub(hn::Set(f, 1.0f), s), s2 = hn::Mul(s, s);
    VF sum = hn::MulAdd(u, b0, hn::Mul(s, hn::Mul(three, b1)));
    sum = hn::MulAdd(u, sum, hn::Mul(s2, hn::Mul(three, b2)));
    return hn::MulAdd(u, sum, hn::Mul(hn::Mul(s2, s), b3));
  }
};

// Of the cells of lanes `known`, between their t and tOut; of floats, lanes with a missing corner become
// unknown.
template <class T>
HWY_INLINE Cubic cubicOf(const View& view, const T* voxels, const Group& g, VF tOut, MF& known) {
  const F f;
  const I i;
  const VI cx = g.cx, cy = g.cy, cz = g.cz;
  const VF tIn = g.t;
  const VI at =
      hn::Add(hn::Mul(hn::Add(hn::Mul(cz, hn::Set(i, view.dims.y)), cy), hn::Set(i, view.dims.x)), cx);
  // The other lanes read one place that is always the same, not memory that nobody needs.
  const VI needed = hn::IfThenElseZero(hn::RebindMask(i, known), at);
  const Corners corners =
      loadCorners(voxels, needed, static_cast<std::size_t>(view.dims.x),
                  static_cast<std::size_t>(view.dims.x) * static_cast<std::size_t>(view.dims.y));
  const Edge &e00 = corners.e00, &e10 = corners.e10, &e01 = corners.e01, &e11 = corners.e11;
  if constexpr (std::is_same_v<T, float>) {
    const VF sum = hn::Add(hn::Add(hn::Add(e00.low, e00.high), hn::Add(e10.low, e10.high)),
                           hn::Add(hn::Add(e01.low, e01.high), hn::Add(e11.low, e11.high)));
    known = hn::Not(hn::IsNaN(hn::Sub(sum, sum)));
    // Large but finite corners may overflow in the sum.
    if (!hn::AllTrue(f, known)) {
      known = hn::Not(hn::Or(hn::Or(hn::Or(hn::IsNaN(e00.low), hn::IsNaN(e00.high)),
                                    hn::Or(hn::IsNaN(e10.low), hn::IsNaN(e10.high))),
                             hn::Or(hn::Or(hn::IsNaN(e01.low), hn::IsNaN(e01.high)),
                                    hn::Or(hn::IsNaN(e11.low), hn::IsNaN(e11.high)))));
    }
  }
  const VF zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const auto within = [&](VF v) { return hn::Min(hn::Max(v, zero), one); };
  const VF dx = hn::Load(f, g.direction[0]), dy = hn::Load(f, g.direction[1]),
           dz = hn::Load(f, g.direction[2]);
  const VF fromX = hn::Sub(hn::Load(f, g.origin[0]), hn::ConvertTo(f, cx));
  const VF fromY = hn::Sub(hn::Load(f, g.origin[1]), hn::ConvertTo(f, cy));
  const VF fromZ = hn::Sub(hn::Load(f, g.origin[2]), hn::ConvertTo(f, cz));
  const VF p[3] = {within(hn::MulAdd(tIn, dx, fromX)), within(hn::MulAdd(tIn, dy, fromY)),
                   within(hn::MulAdd(tIn, dz, fromZ))};
  const VF q[3] = {within(hn::MulAdd(tOut, dx, fromX)), within(hn::MulAdd(tOut, dy, fromY)),
                   within(hn::MulAdd(tOut, dz, fromZ))};
  // The isovalue is subtracted first: differences of like numbers are exact.
  const VF iso = hn::Load(f, g.isovalue), scale = hn::Set(f, view.scale);
  const BernsteinCoefficients b =
      bernsteinOf(corners, p, q, [&](VF v) { return hn::Mul(scale, hn::Sub(v, iso)); });
  return {b.b0, b.b1, b.b2, b.b3};
}

// The bracket of the first entry from a stretch's beginning, or from where it has left the inside that it
// begins in. Equal to the scalar findBracket().
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

// Lanes in cells of which something is hidden, one by one. before: those that came from outside.
HWY_NOINLINE void passHidden(const View& view, Group& g, MF here, VF tOut, MF before, MF& entered,
                             MF& outside) {
  const F f;
  const I i;
  alignas(64) std::int32_t cells[3][kLanes], entries[kLanes], outsides[kLanes];
  alignas(64) float tIns[kLanes], tOuts[kLanes];
  hn::Store(g.cx, i, cells[0]);
  hn::Store(g.cy, i, cells[1]);
  hn::Store(g.cz, i, cells[2]);
  hn::Store(g.t, f, tIns);
  hn::Store(tOut, f, tOuts);
  hn::Store(hn::VecFromMask(i, hn::RebindMask(i, entered)), i, entries);
  hn::Store(hn::VecFromMask(i, hn::RebindMask(i, outside)), i, outsides);
  const std::uint32_t cameFromOutside = bitsOf(hn::RebindMask(i, before));
  for (std::uint32_t bits = bitsOf(hn::RebindMask(i, here)); bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
    const glm::ivec3 cell(cells[0][lane], cells[1][lane], cells[2][lane]);
    if (!view.shown->hides(cell)) continue;
    const auto local = [&](float t) {
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = static_cast<double>(g.origin[axis][lane]) +
                  static_cast<double>(t) * static_cast<double>(g.direction[axis][lane]) - cell[axis];
      return glm::clamp(p, 0.0, 1.0);
    };
    bool isOutside = (cameFromOutside >> lane & 1) != 0;
    const double s = entryIntoShown(view, cell, local(tIns[lane]), local(tOuts[lane]), isOutside);
    entries[lane] = s >= 0.0 ? -1 : 0;
    outsides[lane] = isOutside ? -1 : 0;
    if (s >= 0.0)
      g.found.tIn[lane] = g.found.tOut[lane] =
          tIns[lane] + static_cast<float>(s) * (tOuts[lane] - tIns[lane]);
  }
  entered = hn::RebindMask(f, hn::Ne(hn::Load(i, entries), hn::Zero(i)));
  outside = hn::RebindMask(f, hn::Ne(hn::Load(i, outsides), hn::Zero(i)));
}

// Entries in the cells of lanes `here`; updates `outside`.
template <class T, bool any>
HWY_INLINE MF testCells(const View& view, const T* voxels, Group& g, MF here, VF tOut, MF& outside) {
  const VF t = g.t;
  const F d;
  const VF zero = hn::Zero(d);
  MF known = here;
  const MF before = outside;
  const Cubic f = cubicOf(view, voxels, g, tOut, known);
  const MF gap = hn::AndNot(known, here);
  here = hn::And(here, known);
  // On the surface a stretch begins outside where f falls.
  const VF slope = hn::IfThenElse(hn::Eq(f.b1, zero), hn::IfThenElse(hn::Eq(f.b2, zero), f.b3, f.b2), f.b1);
  const MF beginsOutside = hn::Or(hn::Lt(f.b0, zero), hn::And(hn::Eq(f.b0, zero), hn::Lt(slope, zero)));
  const MF atOnce = hn::And(here, hn::AndNot(beginsOutside, outside));
  if constexpr (!any) {
    hn::BlendedStore(t, atOnce, d, g.found.tIn);
    hn::BlendedStore(t, atOnce, d, g.found.tOut);
  }
  const VF least = hn::Min(hn::Min(f.b1, f.b2), f.b3), greatest = hn::Max(hn::Max(f.b1, f.b2), f.b3);
  MF entered = atOnce;
  MF open = hn::And(hn::AndNot(atOnce, here), hn::Or(hn::And(beginsOutside, hn::Gt(greatest, zero)),
                                                     hn::AndNot(beginsOutside, hn::Lt(least, zero))));
  if constexpr (any) {
    const MF sure = hn::And(open, hn::And(hn::Lt(f.b0, zero), hn::Gt(f.b3, zero)));
    entered = hn::Or(entered, sure);
    open = hn::AndNot(sure, open);
  }
  VF atLow = f.b0;
  if (!hn::AllFalse(d, open)) entered = hn::Or(entered, findBrackets<any>(g, f, open, t, tOut, atLow));
  const MF endsOutside =
      hn::Or(hn::Lt(f.b3, zero), hn::And(hn::Eq(f.b3, zero), hn::Or(hn::Lt(atLow, zero), beginsOutside)));
  outside = hn::Or(hn::And(here, endsOutside), hn::AndNot(hn::Or(here, gap), outside));
  if (view.shown) passHidden(view, g, here, tOut, before, entered, outside);
  return entered;
}

// t of the first entries of lanes that have one.
HWY_INLINE VF roots(const Group& g) {
  const F d;
  const Cubic f{hn::Load(d, g.found.b0), hn::Load(d, g.found.b1), hn::Load(d, g.found.b2),
                hn::Load(d, g.found.b3)};
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
