// The first crossing of each lane's ray with the isosurfaces: what trace() and
// traceCubic() of resources/shaders/cast do, with the same definitions. Cells: trilinear_cells-inl.h or
// cubic_cells-inl.h. Included once per instruction set by simd_cast-inl.h.
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

#include <algorithm>
#include <bit>
#include <cstring>

#include <glm/common.hpp>

#include "volume/cast/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// inside: a bit for each surface, the side behind the crossing; kUndecided where a touch before it was not
// decided.
constexpr int kUndecided = 16;
struct Crossings {
  MF found;
  VF t;
  VI surface, inside;
};

template <class Cells>
class CrossingFinder {
 public:
  CrossingFinder(const CastView& view, const Cells& cells) : view_(view), cells_(cells) {}

  // Of lanes `alive`, in [t, tEnd]. Lanes `carried` have just crossed surfaces at t, and `inside` is the side
  // behind; the sides of others are those of the field. Behind missing voxels nothing is known: no surface
  // there.
  HWY_NOINLINE Crossings find(const RayLanes& ray, VF t, VF tEnd, MF alive, MF carried, VI inside) const;

  // f - isovalue of each lane's surface at p, scaled; NaN beside missing voxels.
  HWY_NOINLINE VF valueMinus(const VF (&p)[3], VI surface, MF wanted) const;

 private:
  using Curve = typename Cells::Curve;
  // A cell that holds a crossing, for each lane that has met one.
  struct Met {
    Curve b;
    VF tIn, tOut;
    VI inside, changed;
    MF first;
  };
  struct Masks {
    VI block;
    alignas(64) std::int32_t low[kLanes], high[kLanes];
  };
  HWY_INLINE void lookUp(Masks& masks, const CellLanes& cell, MI alive) const;
  HWY_INLINE VI sidesOf(VF value) const;
  static HWY_INLINE MF isInside(VI inside, int surface) {
    return hn::RebindMask(F(), hn::Ne(hn::And(inside, hn::Set(I(), 1 << surface)), hn::Zero(I())));
  }
  // The crossing that a ray comes from lies at its first cell's entry, on one side or the other by rounding.
  static HWY_INLINE Curve entered(const Curve& b, MF inside, MF first) {
    const VF start = b.start();
    const VF side =
        hn::IfThenElse(inside, hn::Max(start, hn::Zero(F())), hn::Min(start, hn::Set(F(), -1e-30f)));
    return b.startingAt(hn::IfThenElse(first, side, start));
  }
  HWY_INLINE VI changesIn(const Curve& b, VI inside, MF here, MF first, MF& doubted) const;
  // What a lane's stretch through a cell comes to.
  struct Stretches {
    VF tIn, tOut;
    VI inside, changed;
  };
  HWY_NOINLINE void leaveOutHidden(const RayLanes& ray, const CellLanes& cell, MF here, MF fresh, MF first,
                                   Stretches& stretches) const;
  HWY_INLINE Crossings solve(const Met& met, MF found, VI inside) const;

  const CastView& view_;
  const Cells cells_;
};

// The masks of the blocks that the lanes stand in; most stand where they stood.
template <class Cells>
HWY_INLINE void CrossingFinder<Cells>::lookUp(Masks& masks, const CellLanes& cell, MI alive) const {
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

template <class Cells>
HWY_INLINE VI CrossingFinder<Cells>::sidesOf(VF value) const {
  VI bits = hn::Zero(I());
  for (int k = 0; k < view_.surfaces; ++k) {
    const MF inside = hn::Ge(value, hn::Set(F(), view_.shifts[k]));
    bits = hn::Or(bits, hn::IfThenElseZero(hn::RebindMask(I(), inside), hn::Set(I(), 1 << k)));
  }
  return bits;
}

// Of lanes `here`, a bit for each surface that is crossed along the curve.
template <class Cells>
HWY_INLINE VI CrossingFinder<Cells>::changesIn(const Curve& b, VI inside, MF here, MF first,
                                               MF& doubted) const {
  VI changed = hn::Zero(I());
  for (int k = 0; k < view_.surfaces; ++k) {
    const MF side = isInside(inside, k);
    const MF crossed = leavesSide(entered(b.minus(view_.shifts[k]), side, first), side, here, doubted);
    changed = hn::Or(changed, hn::IfThenElseZero(hn::RebindMask(I(), crossed), hn::Set(I(), 1 << k)));
  }
  return changed;
}

// Lanes in cells of which something is hidden, one by one: their sides, and the nearest crossing that is
// seen, which is where the stretch begins and ends then.
template <class Cells>
HWY_NOINLINE void CrossingFinder<Cells>::leaveOutHidden(const RayLanes& ray, const CellLanes& cell, MF here,
                                                        MF fresh, MF first, Stretches& stretches) const {
  const F f;
  const I i;
  alignas(64) std::int32_t cells[3][kLanes], inside[kLanes], changed[kLanes];
  alignas(64) float tIn[kLanes], tOut[kLanes], origin[3][kLanes], direction[3][kLanes];
  const VI* const places[3] = {&cell.x, &cell.y, &cell.z};
  for (int axis = 0; axis < 3; ++axis) {
    hn::Store(*places[axis], i, cells[axis]);
    hn::Store(ray.origin[axis], f, origin[axis]);
    hn::Store(ray.direction[axis], f, direction[axis]);
  }
  hn::Store(stretches.tIn, f, tIn);
  hn::Store(stretches.tOut, f, tOut);
  hn::Store(stretches.inside, i, inside);
  hn::Store(stretches.changed, i, changed);
  const std::uint32_t freshLanes = bitsOf(hn::RebindMask(i, fresh)),
                      firstLanes = bitsOf(hn::RebindMask(i, first));
  bool any = false;
  for (std::uint32_t bits = bitsOf(hn::RebindMask(i, here)); bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
    const glm::ivec3 at(cells[0][lane], cells[1][lane], cells[2][lane]);
    if (std::none_of(view_.shown.begin(), view_.shown.end(),
                     [&](const ShownCells& shown) { return shown.hides(at); }))
      continue;
    any = true;
    const auto local = [&](float t) {
      glm::dvec3 p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = static_cast<double>(origin[axis][lane]) +
                  static_cast<double>(t) * static_cast<double>(direction[axis][lane]) - at[axis];
      return glm::clamp(p, 0.0, 1.0);
    };
    const casting::SeenCrossing seen =
        casting::seenCrossing(view_, at, local(tIn[lane]), local(tOut[lane]), inside[lane],
                              (freshLanes >> lane & 1) != 0, (firstLanes >> lane & 1) != 0);
    inside[lane] = seen.inside;
    changed[lane] = seen.changed;
    if (seen.changed != 0)
      tIn[lane] = tOut[lane] = tIn[lane] + static_cast<float>(seen.s) * (tOut[lane] - tIn[lane]);
  }
  if (!any) return;
  stretches = {hn::Load(f, tIn), hn::Load(f, tOut), hn::Load(i, inside), hn::Load(i, changed)};
}

template <class Cells>
HWY_INLINE Crossings CrossingFinder<Cells>::solve(const Met& met, MF found, VI inside) const {
  const F f;
  const I i;
  Crossings out{found, met.tIn, hn::Zero(i), inside};
  if (hn::AllFalse(f, found)) return out;
  VF least = hn::Set(f, 2.0f);
  for (int k = 0; k < view_.surfaces; ++k) {
    const MF crossed = hn::And(found, isInside(met.changed, k));
    if (hn::AllFalse(f, crossed)) continue;
    const MF side = isInside(met.inside, k);
    const VF s = firstRoot(entered(met.b.minus(view_.shifts[k]), side, met.first), side, crossed);
    const MF nearer = hn::And(crossed, hn::Lt(s, least));
    least = hn::IfThenElse(nearer, s, least);
    out.surface = hn::IfThenElse(hn::RebindMask(i, nearer), hn::Set(i, k), out.surface);
  }
  out.t = hn::MulAdd(least, hn::Sub(met.tOut, met.tIn), met.tIn);
  const VI bit = hn::Shl(hn::Set(i, 1), out.surface);
  out.inside = hn::IfThenElse(hn::RebindMask(i, found), hn::Xor(met.inside, bit), inside);
  return out;
}

template <class Cells>
Crossings CrossingFinder<Cells>::find(const RayLanes& ray, VF t, VF tEnd, MF alive, MF carried,
                                      VI inside) const {
  const F f;
  const I i;
  const MF never = noLane();
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
  CellLanes cell = cellsAt(view_, start);
  Masks masks{hn::Set(i, -1), {}, {}};
  MF known = carried, first = carried, found = never, doubted = never;
  const VF none = hn::Zero(f);
  Met met{Curve::zero(), none, none, hn::Zero(i), hn::Zero(i), never};
  typename Cells::Samples samples;
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
    const MI fullBox = hn::Ne(bit, hn::Zero(i)), emptyBlock = hn::Eq(hn::Or(low, high), hn::Zero(i));
    // Eight boxes, 2 x 2 x 2 of them, lie in one word.
    const VI eight = hn::Shl(hn::Set(i, 0x00330033), hn::And(box, hn::Set(i, 10)));
    const MI emptyEight = hn::Eq(hn::And(word, eight), hn::Zero(i));
    const VI size = hn::IfThenElse(
        fullBox, one,
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

    const MI waits = cells_.mayCross(cell, hn::And(living, fullBox));
    MI moves = hn::AndNot(waits, living);
    if (view_.gaps) known = hn::AndNot(hn::RebindMask(f, moves), known);
    const std::size_t waiting = hn::CountTrue(i, waits);
    if (waiting > 0 && 2 * waiting >= hn::CountTrue(i, living)) {
      moves = living;
      Curve b;
      MF here = hn::RebindMask(f, waits);
      const MF gap = hn::And(here, cells_.along(ray, cell, t, tOut, waits, samples, b));
      here = hn::AndNot(gap, here);
      const MF fresh = hn::AndNot(known, here);
      inside = hn::IfThenElse(hn::RebindMask(i, fresh), sidesOf(b.start()), inside);
      known = hn::Or(hn::AndNot(gap, known), here);
      VI changed = changesIn(b, inside, here, first, doubted);
      VF tBegin = t, tEnds = tOut;
      if (!view_.shown.empty()) {
        Stretches stretches{t, tOut, inside, changed};
        leaveOutHidden(ray, cell, here, fresh, first, stretches);
        tBegin = stretches.tIn;
        tEnds = stretches.tOut;
        inside = stretches.inside;
        changed = stretches.changed;
      }
      const MI crossedInts = hn::Ne(changed, hn::Zero(i));
      if (!hn::AllFalse(i, crossedInts)) {
        const MF crossed = hn::RebindMask(f, crossedInts);
        met.b = Curve::select(crossed, b, met.b);
        met.tIn = hn::IfThenElse(crossed, tBegin, met.tIn);
        met.tOut = hn::IfThenElse(crossed, tEnds, met.tOut);
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
  Crossings out = solve(met, found, inside);
  const MI undecided = hn::RebindMask(i, hn::And(found, doubted));
  out.inside = hn::Or(out.inside, hn::IfThenElseZero(undecided, hn::Set(i, kUndecided)));
  return out;
}

template <class Cells>
VF CrossingFinder<Cells>::valueMinus(const VF (&p)[3], VI surface, MF wanted) const {
  const F f;
  VF shift = hn::Set(f, view_.shifts[0]);
  for (int k = 1; k < view_.surfaces; ++k)
    shift = hn::IfThenElse(hn::RebindMask(f, hn::Eq(surface, hn::Set(I(), k))), hn::Set(f, view_.shifts[k]),
                           shift);
  return hn::Sub(cells_.valueAt(p, wanted), shift);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
