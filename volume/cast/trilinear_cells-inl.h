// Forms the cubic of a trilinear cell along each lane's ray, tests whether it crosses the isovalue, and finds
// where; as resources/shaders/cast/trace.glsl. Included once per instruction set by simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_TRILINEAR_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_TRILINEAR_CELLS_INL_H
#undef ISOLUX_VOLUME_CAST_TRILINEAR_CELLS_INL_H
#else
#define ISOLUX_VOLUME_CAST_TRILINEAR_CELLS_INL_H
#endif

#include <cstdint>
#include <limits>
#include <type_traits>

#include "volume/cast/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// The cubic in Bernstein form on [0, 1].
struct Bernstein : BernsteinCoefficients {
  // De Casteljau: no cancellation, and inside the hull of the coefficients.
  HWY_INLINE VF operator()(VF s) const {
    const Between between(s);
    const VF q0 = between(b0, b1), q1 = between(b1, b2), q2 = between(b2, b3);
    return between(between(q0, q1), between(q1, q2));
  }
  HWY_INLINE VF start() const { return b0; }
  HWY_INLINE Bernstein minus(float shift) const {
    const VF v = hn::Set(F(), shift);
    return {{hn::Sub(b0, v), hn::Sub(b1, v), hn::Sub(b2, v), hn::Sub(b3, v)}};
  }
  HWY_INLINE Bernstein startingAt(VF value) const { return {{value, b1, b2, b3}}; }
  static HWY_INLINE Bernstein zero() {
    const VF none = hn::Zero(F());
    return {{none, none, none, none}};
  }
  static HWY_INLINE Bernstein select(MF first, const Bernstein& a, const Bernstein& b) {
    return {{hn::IfThenElse(first, a.b0, b.b0), hn::IfThenElse(first, a.b1, b.b1),
             hn::IfThenElse(first, a.b2, b.b2), hn::IfThenElse(first, a.b3, b.b3)}};
  }
};

// Of 0, the extrema and 1, the first where a cubic lies on the other side, and the one before.
struct Change {
  MF found;
  VF before, at;
};

HWY_INLINE Change firstChange(const Bernstein& b, MF inside) {
  const F f;
  const VF zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  // Squares of differences beside what stands for no value would be 0.
  const VF largest = hn::Max(hn::Max(hn::Abs(b.b0), hn::Abs(b.b1)), hn::Max(hn::Abs(b.b2), hn::Abs(b.b3)));
  const VF unit = hn::Div(one, hn::Max(largest, hn::Set(f, 1e-37f)));
  const VF c0 = hn::Mul(unit, hn::Sub(b.b1, b.b0)), d1 = hn::Mul(unit, hn::Sub(b.b2, b.b1)),
           d2 = hn::Mul(unit, hn::Sub(b.b3, b.b2));
  const VF c1 = hn::Sub(d1, c0), c2 = hn::Sub(hn::Sub(d2, d1), c1);
  const VF discriminant = hn::NegMulAdd(c2, c0, hn::Mul(c1, c1));
  // Citardauq's form: the stable one of the two for each root.
  const VF q = hn::Neg(hn::Add(c1, hn::CopySign(hn::Sqrt(hn::Max(discriminant, zero)), c1)));
  const VF r0 = hn::IfThenElse(hn::Ne(c2, zero), hn::Div(q, c2), one);
  const VF r1 = hn::IfThenElse(hn::Ne(q, zero), hn::Div(c0, q), one);
  const MF bends = hn::Gt(discriminant, zero);
  const auto within = [&](VF s) { return hn::IfThenElse(bends, hn::Min(hn::Max(s, zero), one), one); };
  const VF first = within(hn::Min(r0, r1)), second = within(hn::Max(r0, r1));
  const MF at0 = changesSide(b.b0, inside), atFirst = changesSide(b(first), inside),
           atSecond = changesSide(b(second), inside), at1 = changesSide(b.b3, inside);
  Change change;
  change.found = hn::Or(hn::Or(at0, atFirst), hn::Or(atSecond, at1));
  change.at =
      hn::IfThenElse(at0, zero, hn::IfThenElse(atFirst, first, hn::IfThenElse(atSecond, second, one)));
  change.before = hn::IfThenElse(hn::Or(at0, atFirst), zero, hn::IfThenElse(atSecond, first, second));
  return change;
}

// The root in a change, over which the cubic is monotone: regula falsi, Illinois variant.
HWY_INLINE VF rootIn(const Bernstein& b, const Change& change, MF wanted) {
  const F f;
  const VF half = hn::Set(f, 0.5f), zero = hn::Zero(f), close = hn::Set(f, 1e-6f);
  VF s0 = change.before, s1 = change.at, f0 = b(s0), f1 = b(s1);
  const MF noChange = hn::Not(hn::Xor(hn::Lt(f0, zero), hn::Lt(f1, zero)));
  // A crossing at the segment's very entry.
  const VF nearer = hn::IfThenElse(hn::Le(hn::Abs(f0), hn::Abs(f1)), s0, s1);
  MF open = hn::AndNot(noChange, wanted);
  VF s = hn::IfThenElse(noChange, nearer, s0);
  MF lastHigh = hn::Lt(zero, zero), lastLow = lastHigh;  // which end was replaced before
  for (int i = 0; i < 12 && !hn::AllFalse(f, open); ++i) {
    const VF step = hn::Div(hn::Mul(f1, hn::Sub(s1, s0)), hn::Sub(f1, f0));
    s = hn::IfThenElse(open, hn::Min(hn::Max(hn::Sub(s1, step), s0), s1), s);
    const VF value = b(s);
    open = hn::AndNot(hn::Or(hn::Eq(value, zero), hn::Lt(hn::Sub(s1, s0), close)), open);
    const MF high = hn::Not(hn::Xor(hn::Lt(value, zero), hn::Lt(f1, zero)));
    const VF kept0 = hn::IfThenElse(lastHigh, hn::Mul(half, f0), f0);
    const VF kept1 = hn::IfThenElse(lastLow, hn::Mul(half, f1), f1);
    s1 = hn::IfThenElse(high, s, s1);
    s0 = hn::IfThenElse(high, s0, s);
    f1 = hn::IfThenElse(high, value, kept1);
    f0 = hn::IfThenElse(high, kept0, value);
    lastHigh = high;
    lastLow = hn::Not(high);
  }
  return s;
}

// Returns the lanes of `here` whose curve leaves its side. The cubic's extrema leave none undecided.
HWY_INLINE MF leavesSide(const Bernstein& b, MF inside, MF here, MF&) {
  const F f;
  const MF atEnds = hn::Or(changesSide(b.b0, inside), changesSide(b.b3, inside));
  const MF between = hn::Or(changesSide(b.b1, inside), changesSide(b.b2, inside));
  const MF leaves = hn::And(here, atEnds);
  const MF unresolved =
      hn::And(here, hn::AndNot(atEnds, between));  // convex hull: no other lane has a crossing
  if (hn::AllFalse(f, unresolved)) return leaves;
  return hn::Or(leaves, hn::And(unresolved, firstChange(b, inside).found));
}

// Returns where those curves leave it first.
HWY_INLINE VF firstRoot(const Bernstein& b, MF inside, MF wanted) {
  return rootIn(b, firstChange(b, inside), wanted);
}

template <class T>
class TrilinearCells {
 public:
  using Curve = Bernstein;
  struct Samples {};  // nothing of a cell is kept

  TrilinearCells(const CastView& view, const T* voxels)
      : view_(view),
        voxels_(voxels, view.dims),
        wideVoxels_(voxels, view.dims),
        wide_(Extent3{view.dims}.count() > std::numeric_limits<std::uint32_t>::max()) {}

  // Of lanes in boxes that can hold a crossing, returns those whose cell can.
  HWY_INLINE MI mayCross(const CellLanes&, MI wanted) const { return wanted; }

  // Forms the field less the first isovalue, scaled, along each ray in [tIn, tOut] of its cell. Returns lanes
  // whose cell has a missing corner.
  HWY_INLINE MF along(const RayLanes& ray, const CellLanes& cell, VF tIn, VF tOut, MI wanted, Samples&,
                      Bernstein& b) const {
    const Corners corners = cornersOf(cell, wanted);
    b = fieldAlong(ray, cell, corners, tIn, tOut);
    if constexpr (std::is_same_v<T, float>) return missing(corners);
    return noLane();
  }

  // The same at points; NaN beside missing voxels.
  HWY_INLINE VF valueAt(const VF (&p)[3], MF wanted) const {
    const VF zero = hn::Zero(F());
    const CellLanes cell = cellsAt(view_, p);
    const RayLanes at{{p[0], p[1], p[2]}, {zero, zero, zero}, {}};
    return fieldAlong(at, cell, cornersOf(cell, hn::RebindMask(I(), wanted)), zero, zero).b0;
  }

 private:
  HWY_INLINE Corners cornersOf(const CellLanes& cell, MI wanted) const {
    return wide_ ? wideVoxels_.corners(cell, wanted) : voxels_.corners(cell, wanted);
  }
  HWY_INLINE Bernstein fieldAlong(const RayLanes& ray, const CellLanes& cell, const Corners& c, VF tIn,
                                  VF tOut) const;

  const CastView& view_;
  const VoxelLanes<T, false> voxels_;
  const VoxelLanes<T, true> wideVoxels_;
  bool wide_;
};

// Offset and isovalue are subtracted first: differences of like numbers are exact.
template <class T>
HWY_INLINE Bernstein TrilinearCells<T>::fieldAlong(const RayLanes& ray, const CellLanes& cell,
                                                   const Corners& c, VF tIn, VF tOut) const {
  const F f;
  VF p[3], q[3];
  for (int axis = 0; axis < 3; ++axis) {
    p[axis] = inCell(ray, axis, cell, tIn);
    q[axis] = inCell(ray, axis, cell, tOut);
  }
  const VF offset = hn::Set(f, view_.offset), isovalue = hn::Set(f, view_.isovalue),
           scale = hn::Set(f, view_.scale);
  return {bernsteinOf(c, p, q, [&](VF v) {
    if constexpr (std::is_same_v<T, float>) v = hn::Sub(v, offset);
    return hn::Mul(scale, hn::Sub(v, isovalue));
  })};
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
