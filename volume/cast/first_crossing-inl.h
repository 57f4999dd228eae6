// The first crossing of each lane's ray with the isosurfaces: what trace() of
// resources/shaders/cast/trace.glsl does, with the same definitions. Included once per instruction set by
// simd_cast.cpp.
//
// The lanes of a packet go on their ways together. Those that stand in a box that may hold a crossing wait
// until half of the living do; then all their cells are tested at once. Crossings are solved together, too,
// when all lanes have ended.
#if defined(ISOLUX_VOLUME_CAST_FIRST_CROSSING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_FIRST_CROSSING_INL_H
#undef ISOLUX_VOLUME_CAST_FIRST_CROSSING_INL_H
#else
#define ISOLUX_VOLUME_CAST_FIRST_CROSSING_INL_H
#endif

#include <bit>
#include <cstring>
#include <limits>
#include <type_traits>

#include "volume/cast/cast_kernels.h"
#include "volume/tracer/corners-inl.h"
#include "volume/tracer/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

using casting::CastView;

// Axes a ray does not move along it creeps along, so that no plane is at 0 / 0.
struct RayLanes {
  VF origin[3], direction[3], inverse[3];
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

// The cubic in Bernstein form on [0, 1].
struct Bernstein {
  VF b0, b1, b2, b3;

  // De Casteljau: no cancellation, and inside the hull of the coefficients.
  HWY_INLINE VF operator()(VF s) const {
    const VF q0 = mix(b0, b1, s), q1 = mix(b1, b2, s), q2 = mix(b2, b3, s);
    return mix(mix(q0, q1, s), mix(q1, q2, s), s);
  }
  HWY_INLINE Bernstein minus(float shift) const {
    const VF v = hn::Set(F(), shift);
    return {hn::Sub(b0, v), hn::Sub(b1, v), hn::Sub(b2, v), hn::Sub(b3, v)};
  }
  static HWY_INLINE VF mix(VF a, VF b, VF s) { return hn::MulAdd(s, hn::Sub(b, a), a); }
};

// Lanes on the other side of f = 0 than `inside` says; f = 0 is inside.
HWY_INLINE MF changesSide(VF f, MF inside) {
  return hn::Xor(hn::Lt(f, hn::Zero(F())), hn::Not(inside));
}

// Where between 0, its extrema and 1 a cubic first lies on the other side, and the stop before.
struct Change {
  MF found;
  VF before, at;
};

HWY_INLINE Change firstChange(const Bernstein& b, MF inside) {
  const F f;
  const VF zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const VF c0 = hn::Sub(b.b1, b.b0), d1 = hn::Sub(b.b2, b.b1), d2 = hn::Sub(b.b3, b.b2);
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
  // A crossing at the stretch's very entry.
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

// inside: a bit for each surface, the side behind the crossing.
struct Crossings {
  MF found;
  VF t;
  VI surface, inside;
};

template <class T>
class CrossingFinder {
 public:
  CrossingFinder(const CastView& view, const T* voxels)
      : view_(view),
        voxels_(voxels),
        row_(static_cast<std::size_t>(view.dims.x)),
        slice_(row_ * static_cast<std::size_t>(view.dims.y)),
        wide_(slice_ * static_cast<std::size_t>(view.dims.z) > std::numeric_limits<std::uint32_t>::max()) {}

  // Of lanes `alive`, in [t, tEnd]. Lanes `carried` have just crossed surfaces at t, and `inside` is the side
  // behind; the sides of others are those of the field. Behind missing voxels nothing is known: no surface
  // there.
  Crossings find(const RayLanes& ray, VF t, VF tEnd, MF alive, MF carried, VI inside) const;

  // f - isovalue of each lane's surface at p, scaled; NaN beside missing voxels.
  VF valueMinus(const VF (&p)[3], VI surface, MF wanted) const;

 private:
  struct Cells {
    VI x, y, z;
  };
  // A cell that holds a crossing, for each lane that has met one.
  struct Met {
    Bernstein b;
    VF tIn, tOut;
    VI inside, changed;
    MF first;
  };
  struct Masks {
    VI block;
    alignas(64) std::int32_t low[kLanes], high[kLanes];
  };
  HWY_INLINE Cells cellsAt(const VF (&p)[3]) const;
  HWY_INLINE void lookUp(Masks& masks, const Cells& cell, MI alive) const;
  HWY_INLINE Corners cornersOf(const Cells& cell, MI wanted) const;
  HWY_INLINE MF missing(const Corners& c) const;
  HWY_INLINE Bernstein fieldAlong(const RayLanes& ray, const Cells& cell, const Corners& c, VF tIn,
                                  VF tOut) const;
  HWY_INLINE VI sidesOf(VF value) const;
  static HWY_INLINE MF isInside(VI inside, int surface) {
    return hn::RebindMask(F(), hn::Ne(hn::And(inside, hn::Set(I(), 1 << surface)), hn::Zero(I())));
  }
  // The crossing that a ray comes from lies at its first cell's entry, on one side or the other by rounding.
  static HWY_INLINE Bernstein entered(Bernstein b, MF inside, MF first) {
    const VF side =
        hn::IfThenElse(inside, hn::Max(b.b0, hn::Zero(F())), hn::Min(b.b0, hn::Set(F(), -1e-30f)));
    b.b0 = hn::IfThenElse(first, side, b.b0);
    return b;
  }
  HWY_INLINE VI changesIn(const Bernstein& b, VI inside, MF here, MF first) const;
  HWY_INLINE Crossings solve(const Met& met, MF found, VI inside) const;

  const CastView& view_;
  const T* voxels_;
  std::size_t row_, slice_;
  bool wide_;  // voxels have no 32-bit numbers
};

template <class T>
HWY_INLINE auto CrossingFinder<T>::cellsAt(const VF (&p)[3]) const -> Cells {
  const auto along = [&](VF v, int axis) {
    const VF last = hn::Set(F(), static_cast<float>(view_.dims[axis] - 2));
    return hn::ConvertTo(I(), hn::Min(hn::Max(v, hn::Zero(F())), last));
  };
  return {along(p[0], 0), along(p[1], 1), along(p[2], 2)};
}

// The masks of the blocks that the lanes stand in; most stand where they stood.
template <class T>
HWY_INLINE void CrossingFinder<T>::lookUp(Masks& masks, const Cells& cell, MI alive) const {
  const I i;
  const VI block = hn::Add(hn::Mul(hn::Add(hn::Mul(hn::ShiftRight<3>(cell.z), hn::Set(i, view_.blockDims.y)),
                                           hn::ShiftRight<3>(cell.y)),
                                   hn::Set(i, view_.blockDims.x)),
                           hn::ShiftRight<3>(cell.x));
  const MI fresh = hn::And(alive, hn::Ne(block, masks.block));
  if (hn::AllFalse(i, fresh)) return;
  masks.block = hn::IfThenElse(fresh, block, masks.block);
  alignas(64) std::int32_t at[kLanes];
  hn::Store(block, i, at);
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(i, fresh, bytes);
  std::uint64_t bits;
  std::memcpy(&bits, bytes, 8);
  for (; bits != 0; bits &= bits - 1) {
    const int lane = std::countr_zero(bits);
    const std::uint64_t mask = view_.masks[at[lane]];
    masks.low[lane] = static_cast<std::int32_t>(static_cast<std::uint32_t>(mask));
    masks.high[lane] = static_cast<std::int32_t>(static_cast<std::uint32_t>(mask >> 32));
  }
}

// Other lanes read one place that is always the same.
template <class T>
HWY_INLINE Corners CrossingFinder<T>::cornersOf(const Cells& cell, MI wanted) const {
  const I i;
  if (!wide_) {
    const VI at =
        hn::Add(hn::Mul(hn::Add(hn::Mul(cell.z, hn::Set(i, view_.dims.y)), cell.y), hn::Set(i, view_.dims.x)),
                cell.x);
    return loadCorners(voxels_, hn::IfThenElseZero(wanted, at), row_, slice_);
  }
  alignas(64) std::int32_t x[kLanes], y[kLanes], z[kLanes];
  hn::Store(hn::IfThenElseZero(wanted, cell.x), i, x);
  hn::Store(hn::IfThenElseZero(wanted, cell.y), i, y);
  hn::Store(hn::IfThenElseZero(wanted, cell.z), i, z);
  std::size_t at[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    at[lane] = static_cast<std::size_t>(z[lane]) * slice_ + static_cast<std::size_t>(y[lane]) * row_ +
               static_cast<std::size_t>(x[lane]);
  return loadCorners(voxels_, at, row_, slice_);
}

template <class T>
HWY_INLINE MF CrossingFinder<T>::missing(const Corners& c) const {
  const F f;
  if constexpr (std::is_same_v<T, float>) {
    const auto either = [](const Edge& a, const Edge& b) {
      return hn::Or(hn::Or(hn::IsNaN(a.low), hn::IsNaN(a.high)), hn::Or(hn::IsNaN(b.low), hn::IsNaN(b.high)));
    };
    return hn::Or(either(c.e00, c.e10), either(c.e01, c.e11));
  }
  return hn::Lt(hn::Zero(f), hn::Zero(f));
}

// Bernstein coefficients are the polar form of the trilinear function at the stretch's two ends. Offset and
// isovalue are subtracted first: differences of like numbers are exact.
template <class T>
HWY_INLINE Bernstein CrossingFinder<T>::fieldAlong(const RayLanes& ray, const Cells& cell, const Corners& c,
                                                   VF tIn, VF tOut) const {
  const F f;
  const VF zero = hn::Zero(f), one = hn::Set(f, 1.0f);
  const auto at = [&](int axis, VI low, VF t) {
    const VF p = hn::Sub(hn::MulAdd(t, ray.direction[axis], ray.origin[axis]), hn::ConvertTo(f, low));
    return hn::Min(hn::Max(p, zero), one);
  };
  const VF px = at(0, cell.x, tIn), py = at(1, cell.y, tIn), pz = at(2, cell.z, tIn);
  const VF qx = at(0, cell.x, tOut), qy = at(1, cell.y, tOut), qz = at(2, cell.z, tOut);
  const VF offset = hn::Set(f, view_.offset), isovalue = hn::Set(f, view_.isovalue);
  const auto less = [&](VF v) {
    if constexpr (std::is_same_v<T, float>) v = hn::Sub(v, offset);
    return hn::Sub(v, isovalue);
  };
  const auto lerp = [](VF a, VF difference, VF s) { return hn::MulAdd(s, difference, a); };
  const VF a00 = less(c.e00.low), a10 = less(c.e10.low), a01 = less(c.e01.low), a11 = less(c.e11.low);
  const VF x00 = hn::Sub(c.e00.high, c.e00.low), x10 = hn::Sub(c.e10.high, c.e10.low),
           x01 = hn::Sub(c.e01.high, c.e01.low), x11 = hn::Sub(c.e11.high, c.e11.low);
  const VF p00 = lerp(a00, x00, px), p10 = lerp(a10, x10, px), p01 = lerp(a01, x01, px),
           p11 = lerp(a11, x11, px);
  const VF q00 = lerp(a00, x00, qx), q10 = lerp(a10, x10, qx), q01 = lerp(a01, x01, qx),
           q11 = lerp(a11, x11, qx);
  const VF py0 = hn::Sub(p10, p00), py1 = hn::Sub(p11, p01), qy0 = hn::Sub(q10, q00), qy1 = hn::Sub(q11, q01);
  const VF pp = lerp(p00, py0, py), pq = lerp(p00, py0, qy), qp = lerp(q00, qy0, py), qq = lerp(q00, qy0, qy);
  const VF ppZ = hn::Sub(lerp(p01, py1, py), pp), pqZ = hn::Sub(lerp(p01, py1, qy), pq);
  const VF qpZ = hn::Sub(lerp(q01, qy1, py), qp), qqZ = hn::Sub(lerp(q01, qy1, qy), qq);
  const VF scale = hn::Set(f, view_.scale), third = hn::Set(f, view_.scale / 3.0f);
  return {hn::Mul(scale, lerp(pp, ppZ, pz)),
          hn::Mul(third, hn::Add(hn::Add(lerp(qp, qpZ, pz), lerp(pq, pqZ, pz)), lerp(pp, ppZ, qz))),
          hn::Mul(third, hn::Add(hn::Add(lerp(qq, qqZ, pz), lerp(qp, qpZ, qz)), lerp(pq, pqZ, qz))),
          hn::Mul(scale, lerp(qq, qqZ, qz))};
}

template <class T>
HWY_INLINE VI CrossingFinder<T>::sidesOf(VF value) const {
  VI bits = hn::Zero(I());
  for (int k = 0; k < view_.surfaces; ++k) {
    const MF inside = hn::Ge(value, hn::Set(F(), view_.shifts[k]));
    bits = hn::Or(bits, hn::IfThenElseZero(hn::RebindMask(I(), inside), hn::Set(I(), 1 << k)));
  }
  return bits;
}

// Of lanes `here`, a bit for each surface that is crossed along the cubic.
template <class T>
HWY_INLINE VI CrossingFinder<T>::changesIn(const Bernstein& b, VI inside, MF here, MF first) const {
  const F f;
  VI changed = hn::Zero(I());
  for (int k = 0; k < view_.surfaces; ++k) {
    const MF side = isInside(inside, k);
    const Bernstein own = entered(b.minus(view_.shifts[k]), side, first);
    const MF atEnds = hn::Or(changesSide(own.b0, side), changesSide(own.b3, side));
    const MF between = hn::Or(changesSide(own.b1, side), changesSide(own.b2, side));
    MF crossed = hn::And(here, atEnds);
    const MF open = hn::And(here, hn::AndNot(atEnds, between));  // convex hull: no other lane has a crossing
    if (!hn::AllFalse(f, open)) crossed = hn::Or(crossed, hn::And(open, firstChange(own, side).found));
    changed = hn::Or(changed, hn::IfThenElseZero(hn::RebindMask(I(), crossed), hn::Set(I(), 1 << k)));
  }
  return changed;
}

template <class T>
HWY_INLINE Crossings CrossingFinder<T>::solve(const Met& met, MF found, VI inside) const {
  const F f;
  const I i;
  Crossings out{found, met.tIn, hn::Zero(i), inside};
  if (hn::AllFalse(f, found)) return out;
  VF least = hn::Set(f, 2.0f);
  for (int k = 0; k < view_.surfaces; ++k) {
    const MF crossed = hn::And(found, isInside(met.changed, k));
    if (hn::AllFalse(f, crossed)) continue;
    const MF side = isInside(met.inside, k);
    const Bernstein own = entered(met.b.minus(view_.shifts[k]), side, met.first);
    const VF s = rootIn(own, firstChange(own, side), crossed);
    const MF nearer = hn::And(crossed, hn::Lt(s, least));
    least = hn::IfThenElse(nearer, s, least);
    out.surface = hn::IfThenElse(hn::RebindMask(i, nearer), hn::Set(i, k), out.surface);
  }
  out.t = Bernstein::mix(met.tIn, met.tOut, least);
  const VI bit = hn::Shl(hn::Set(i, 1), out.surface);
  out.inside = hn::IfThenElse(hn::RebindMask(i, found), hn::Xor(met.inside, bit), inside);
  return out;
}

template <class T>
Crossings CrossingFinder<T>::find(const RayLanes& ray, VF t, VF tEnd, MF alive, MF carried, VI inside) const {
  const F f;
  const I i;
  const MF never = hn::Lt(hn::Zero(f), hn::Zero(f));
  MI forward[3];
  for (int axis = 0; axis < 3; ++axis) {
    const VF last = hn::Set(f, static_cast<float>(view_.dims[axis] - 1));
    const MF rises = hn::Gt(ray.direction[axis], hn::Zero(f));
    const VF nearPlane = hn::IfThenZeroElse(rises, last), farPlane = hn::IfThenElseZero(rises, last);
    t = hn::Max(t, hn::Mul(hn::Sub(nearPlane, ray.origin[axis]), ray.inverse[axis]));
    tEnd = hn::Min(tEnd, hn::Mul(hn::Sub(farPlane, ray.origin[axis]), ray.inverse[axis]));
    forward[axis] = hn::RebindMask(i, rises);
  }
  alive = hn::And(alive, hn::Le(t, tEnd));
  t = hn::IfThenElseZero(alive, t);
  const VF start[3] = {hn::MulAdd(t, ray.direction[0], ray.origin[0]),
                       hn::MulAdd(t, ray.direction[1], ray.origin[1]),
                       hn::MulAdd(t, ray.direction[2], ray.origin[2])};
  Cells cell = cellsAt(start);
  Masks masks{hn::Set(i, -1), {}, {}};
  MF known = carried, first = carried, found = never;
  const VF none = hn::Zero(f);
  Met met{{none, none, none, none}, none, none, hn::Zero(i), hn::Zero(i), never};
  const VI three = hn::Set(i, 3), one = hn::Set(i, 1);

  const int mostSteps = 8 * (view_.dims.x + view_.dims.y + view_.dims.z) + 64;
  for (int step = 0; step < mostSteps && !hn::AllFalse(f, alive); ++step) {
    const MI living = hn::RebindMask(i, alive);
    lookUp(masks, cell, living);
    const VI low = hn::Load(i, masks.low), high = hn::Load(i, masks.high);
    const VI box = hn::Add(hn::ShiftLeft<4>(hn::And(hn::ShiftRight<1>(cell.z), three)),
                           hn::Add(hn::ShiftLeft<2>(hn::And(hn::ShiftRight<1>(cell.y), three)),
                                   hn::And(hn::ShiftRight<1>(cell.x), three)));
    const VI word = hn::IfThenElse(hn::Gt(box, hn::Set(i, 31)), high, low);
    const VI bit = hn::And(
        hn::BitCast(i, hn::Shr(hn::BitCast(U(), word), hn::BitCast(U(), hn::And(box, hn::Set(i, 31))))), one);
    const MI full = hn::Ne(bit, hn::Zero(i)), emptyBlock = hn::Eq(hn::Or(low, high), hn::Zero(i));
    // Eight boxes, 2 x 2 x 2 of them, lie in one word.
    const VI eight = hn::Shl(hn::Set(i, 0x00330033), hn::And(box, hn::Set(i, 10)));
    const MI emptyEight = hn::Eq(hn::And(word, eight), hn::Zero(i));
    const VI size = hn::IfThenElse(
        full, one,
        hn::IfThenElse(emptyBlock, hn::Set(i, 8), hn::IfThenElse(emptyEight, hn::Set(i, 4), hn::Set(i, 2))));

    // Where the ray leaves the box.
    const VI inBox = hn::Sub(size, one);
    const VI lowest[3] = {hn::AndNot(inBox, cell.x), hn::AndNot(inBox, cell.y), hn::AndNot(inBox, cell.z)};
    VF exit[3];
    for (int axis = 0; axis < 3; ++axis) {
      const VI plane = hn::Add(lowest[axis], hn::IfThenElseZero(forward[axis], size));
      exit[axis] = hn::Mul(hn::Sub(hn::ConvertTo(f, plane), ray.origin[axis]), ray.inverse[axis]);
    }
    const VF tOut = hn::Max(t, hn::Min(hn::Min(exit[0], exit[1]), exit[2]));

    const MI waits = hn::And(living, full);
    MI moves = hn::AndNot(full, living);
    if (view_.gaps) known = hn::AndNot(hn::RebindMask(f, moves), known);
    const std::size_t waiting = hn::CountTrue(i, waits);
    if (waiting > 0 && 2 * waiting >= hn::CountTrue(i, living)) {
      moves = living;
      const Corners corners = cornersOf(cell, waits);
      MF here = hn::RebindMask(f, waits);
      const MF gap = hn::And(here, missing(corners));
      here = hn::AndNot(gap, here);
      const Bernstein b = fieldAlong(ray, cell, corners, t, tOut);
      inside = hn::IfThenElse(hn::RebindMask(i, hn::AndNot(known, here)), sidesOf(b.b0), inside);
      known = hn::Or(hn::AndNot(gap, known), here);
      const VI changed = changesIn(b, inside, here, first);
      const MI crossedInts = hn::Ne(changed, hn::Zero(i));
      if (!hn::AllFalse(i, crossedInts)) {
        const MF crossed = hn::RebindMask(f, crossedInts);
        met.b = {hn::IfThenElse(crossed, b.b0, met.b.b0), hn::IfThenElse(crossed, b.b1, met.b.b1),
                 hn::IfThenElse(crossed, b.b2, met.b.b2), hn::IfThenElse(crossed, b.b3, met.b.b3)};
        met.tIn = hn::IfThenElse(crossed, t, met.tIn);
        met.tOut = hn::IfThenElse(crossed, tOut, met.tOut);
        met.inside = hn::IfThenElse(crossedInts, inside, met.inside);
        met.changed = hn::IfThenElse(crossedInts, changed, met.changed);
        met.first = hn::Or(met.first, hn::And(crossed, first));
        found = hn::Or(found, crossed);
        alive = hn::AndNot(crossed, alive);
      }
    }
    const MF movesFloat = hn::RebindMask(f, moves);
    first = hn::AndNot(movesFloat, first);
    alive = hn::AndNot(hn::And(movesFloat, hn::Ge(tOut, tEnd)), alive);

    // The cell behind the box.
    const MF onX = hn::And(hn::Le(exit[0], exit[1]), hn::Le(exit[0], exit[2]));
    const MF onY = hn::AndNot(onX, hn::Le(exit[1], exit[2]));
    const MF leaves[3] = {onX, onY, hn::Not(hn::Or(onX, onY))};
    VI* const cells[3] = {&cell.x, &cell.y, &cell.z};
    MI beyond = hn::RebindMask(i, never);
    for (int axis = 0; axis < 3; ++axis) {
      const VI lastCell = hn::Set(i, view_.dims[axis] - 2);
      const VI highest = hn::Min(hn::Add(lowest[axis], inBox), lastCell);
      const VI at = hn::ConvertTo(i, hn::MulAdd(tOut, ray.direction[axis], ray.origin[axis]));
      const VI within = hn::Min(hn::Max(at, lowest[axis]), highest);
      const VI next = hn::IfThenElse(forward[axis], hn::Add(lowest[axis], size), hn::Sub(lowest[axis], one));
      const VI now = hn::IfThenElse(hn::RebindMask(i, leaves[axis]), next, within);
      beyond = hn::Or(beyond, hn::Or(hn::Gt(hn::Zero(i), now), hn::Gt(now, lastCell)));
      *cells[axis] = hn::IfThenElse(moves, now, *cells[axis]);
    }
    alive = hn::AndNot(hn::RebindMask(f, hn::And(moves, beyond)), alive);
    t = hn::IfThenElse(movesFloat, tOut, t);
  }
  return solve(met, found, inside);
}

template <class T>
VF CrossingFinder<T>::valueMinus(const VF (&p)[3], VI surface, MF wanted) const {
  const F f;
  const Cells cell = cellsAt(p);
  const Corners c = cornersOf(cell, hn::RebindMask(I(), wanted));
  const RayLanes at{{p[0], p[1], p[2]}, {hn::Zero(f), hn::Zero(f), hn::Zero(f)}, {}};
  VF shift = hn::Set(f, view_.shifts[0]);
  for (int k = 1; k < view_.surfaces; ++k)
    shift = hn::IfThenElse(hn::RebindMask(f, hn::Eq(surface, hn::Set(I(), k))), hn::Set(f, view_.shifts[k]),
                           shift);
  return hn::Sub(fieldAlong(at, cell, c, hn::Zero(f), hn::Zero(f)).b0, shift);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
