// Finds the first crossing of each lane's ray with the isosurfaces, with the definitions of trace() and
// traceCubic() of resources/shaders/cast. Cells: trilinear_cells-inl.h or cubic_cells-inl.h. Included once
// per instruction set by simd_cast-inl.h.
//
// The lanes of a packet advance together. Lanes in a box that may hold a crossing are pending until half of
// the active ones are; then all their cells are tested at once. Crossings are solved together, too, when all
// lanes have ended.
#if defined(ISOLUX_VOLUME_CAST_FIRST_CROSSING_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_FIRST_CROSSING_INL_H
#undef ISOLUX_VOLUME_CAST_FIRST_CROSSING_INL_H
#else
#define ISOLUX_VOLUME_CAST_FIRST_CROSSING_INL_H
#endif

#include <algorithm>

#include "volume/cast/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// inside: a bit for each surface, the state behind the crossing; kUndecided where a touch before it was not
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

  // Finds the first crossing of each active lane. No crossing is reported directly behind missing voxels.
  HWY_NOINLINE Crossings find(const RaySegments& segments) const {
    const F f;
    const I i;
    Walk walk = start(segments);
    typename Cells::Samples samples;
    const int mostSteps = 8 * (view_.dims.x + view_.dims.y + view_.dims.z) + 64;
    for (int step = 0; step < mostSteps && !hn::AllFalse(f, walk.active); ++step) {
      loadMasks(walk);
      const Boxes box = boxesOf(segments.ray, walk);
      const MI active = hn::RebindMask(i, walk.active);
      const MI pending = cells_.mayCross(walk.cell, hn::And(active, box.full));
      MI moves = hn::AndNot(pending, active);
      if (view_.gaps) walk.known = hn::AndNot(hn::RebindMask(f, moves), walk.known);
      const std::size_t waiting = hn::CountTrue(i, pending);
      if (waiting > 0 && 2 * waiting >= hn::CountTrue(i, active)) {
        moves = active;
        testCells(segments.ray, pending, box.tOut, samples, walk);
      }
      advance(segments.ray, box, moves, walk);
    }
    Crossings out = solve(walk.candidates, walk.found, walk.inside);
    const MI undecided = hn::RebindMask(i, hn::And(walk.found, walk.undecided));
    out.inside = hn::Or(out.inside, hn::IfThenElseZero(undecided, hn::Set(i, kUndecided)));
    return out;
  }

  // Returns f - isovalue of each lane's surface at p, scaled; NaN beside missing voxels.
  HWY_NOINLINE VF valueMinus(const VF (&p)[3], VI surface, MF wanted) const {
    const F f;
    VF shift = hn::Set(f, view_.shifts[0]);
    for (int k = 1; k < view_.surfaces; ++k)
      shift = hn::IfThenElse(hn::RebindMask(f, hn::Eq(surface, hn::Set(I(), k))), hn::Set(f, view_.shifts[k]),
                             shift);
    return hn::Sub(cells_.valueAt(p, wanted), shift);
  }

 private:
  using Curve = typename Cells::Curve;
  // The cell with a crossing of each lane that has one: its curve on [tIn, tOut], the state at tIn, and a bit
  // for each surface that is crossed.
  struct Candidates {
    Curve b;
    VF tIn, tOut;
    VI inside, changed;
    MF first;
  };
  // Where lanes are, and what is known of them. inside is `known`, or not yet; first: t is still that of the
  // crossing that the ray continues from.
  struct Walk {
    CellLanes cell;
    VF t, tEnd;
    VI inside;
    MF active, known, first, found, undecided;
    Candidates candidates;
    VI block;  // whose mask these are the words of
    alignas(64) std::int32_t low[kLanes] = {}, high[kLanes] = {};
  };
  // The boxes that lanes are in, and where rays leave them.
  struct Boxes {
    MI full;  // a cell that may hold a crossing
    VI size, lowest[3];
    VF exit[3], tOut;
  };
  // Clips the segments to the volume.
  HWY_INLINE Walk start(const RaySegments& segments) const {
    const F f;
    const I i;
    const RayLanes& ray = segments.ray;
    const VF zero = hn::Zero(f);
    VF t = segments.t, tEnd = segments.tEnd;
    for (int axis = 0; axis < 3; ++axis) {
      const VF last = hn::Set(f, static_cast<float>(view_.dims[axis] - 1));
      const MF rises = hn::Gt(ray.direction[axis], zero);
      const VF nearPlane = hn::IfThenZeroElse(rises, last), farPlane = hn::IfThenElseZero(rises, last);
      t = hn::Max(t, hn::Mul(hn::Sub(nearPlane, ray.origin[axis]), ray.inverse[axis]));
      tEnd = hn::Min(tEnd, hn::Mul(hn::Sub(farPlane, ray.origin[axis]), ray.inverse[axis]));
    }
    Walk walk;
    walk.active = hn::And(segments.active, hn::Le(t, tEnd));
    walk.t = hn::IfThenElseZero(walk.active, t);
    walk.tEnd = tEnd;
    VF start[3];
    for (int axis = 0; axis < 3; ++axis)
      start[axis] = hn::MulAdd(walk.t, ray.direction[axis], ray.origin[axis]);
    walk.cell = cellsAt(view_, start);
    walk.inside = segments.inside;
    walk.known = walk.first = segments.continued;
    walk.found = walk.undecided = noLane();
    walk.candidates = {Curve::zero(), zero, zero, hn::Zero(i), hn::Zero(i), noLane()};
    walk.block = hn::Set(i, -1);
    return walk;
  }

  // Loads the masks of the blocks that lanes have entered; most are where they were.
  HWY_INLINE void loadMasks(Walk& walk) const {
    const I i;
    const CellLanes& cell = walk.cell;
    const VI block =
        hn::Add(hn::Mul(hn::Add(hn::Mul(hn::ShiftRight<3>(cell[2]), hn::Set(i, view_.blockDims.y)),
                                hn::ShiftRight<3>(cell[1])),
                        hn::Set(i, view_.blockDims.x)),
                hn::ShiftRight<3>(cell[0]));
    const MI entered = hn::And(hn::RebindMask(i, walk.active), hn::Ne(block, walk.block));
    if (hn::AllFalse(i, entered)) return;
    walk.block = hn::IfThenElse(entered, block, walk.block);
    alignas(64) std::int32_t at[kLanes];
    hn::Store(block, i, at);
    forLanes(bitsOf(entered), [&](std::size_t lane) {
      const std::uint64_t mask = view_.masks[at[lane]];
      walk.low[lane] = static_cast<std::int32_t>(static_cast<std::uint32_t>(mask));
      walk.high[lane] = static_cast<std::int32_t>(static_cast<std::uint32_t>(mask >> 32));
    });
  }

  HWY_INLINE Boxes boxesOf(const RayLanes& ray, const Walk& walk) const {
    const F f;
    const I i;
    const CellLanes& cell = walk.cell;
    const VI three = hn::Set(i, 3), one = hn::Set(i, 1), zero = hn::Zero(i);
    const VI low = hn::Load(i, walk.low), high = hn::Load(i, walk.high);
    const VI number = hn::Add(hn::ShiftLeft<4>(hn::And(hn::ShiftRight<1>(cell[2]), three)),
                              hn::Add(hn::ShiftLeft<2>(hn::And(hn::ShiftRight<1>(cell[1]), three)),
                                      hn::And(hn::ShiftRight<1>(cell[0]), three)));
    const VI word = hn::IfThenElse(hn::Gt(number, hn::Set(i, 31)), high, low);
    const VI bit = hn::And(
        hn::BitCast(i, hn::Shr(hn::BitCast(U(), word), hn::BitCast(U(), hn::And(number, hn::Set(i, 31))))),
        one);
    const MI emptyBlock = hn::Eq(hn::Or(low, high), zero);
    // Eight boxes, 2 x 2 x 2 of them, lie in one word.
    const VI eight = hn::Shl(hn::Set(i, 0x00330033), hn::And(number, hn::Set(i, 10)));
    const MI emptyEight = hn::Eq(hn::And(word, eight), zero);
    Boxes box;
    box.full = hn::Ne(bit, zero);
    box.size = hn::IfThenElse(
        box.full, one,
        hn::IfThenElse(emptyBlock, hn::Set(i, 8), hn::IfThenElse(emptyEight, hn::Set(i, 4), hn::Set(i, 2))));
    const VI inBox = hn::Sub(box.size, one);
    for (int axis = 0; axis < 3; ++axis) {
      const MI rises = hn::RebindMask(i, hn::Gt(ray.direction[axis], hn::Zero(f)));
      box.lowest[axis] = hn::AndNot(inBox, cell[axis]);
      const VI plane = hn::Add(box.lowest[axis], hn::IfThenElseZero(rises, box.size));
      box.exit[axis] = hn::Mul(hn::Sub(hn::ConvertTo(f, plane), ray.origin[axis]), ray.inverse[axis]);
    }
    box.tOut = hn::Max(walk.t, hn::Min(hn::Min(box.exit[0], box.exit[1]), box.exit[2]));
    return box;
  }

  // Lanes whose cell holds a crossing are active no more.
  HWY_INLINE void testCells(const RayLanes& ray, MI pending, VF tOut, typename Cells::Samples& samples,
                            Walk& walk) const {
    const F f;
    const I i;
    const CellLanes cell = walk.cell;
    Curve b;
    MF here = hn::RebindMask(f, pending);
    const MF gap = hn::And(here, cells_.along(ray, cell, walk.t, tOut, pending, samples, b));
    here = hn::AndNot(gap, here);
    const MF entered = hn::AndNot(walk.known, here);
    walk.known = hn::Or(hn::AndNot(gap, walk.known), here);
    CellSegments at{walk.t, tOut, hn::IfThenElse(hn::RebindMask(i, entered), sidesOf(b.start()), walk.inside),
                    hn::Zero(i)};
    at.changed = changesIn(b, at.inside, here, walk.first, walk.undecided);
    if (!view_.shown.empty()) leaveOutHidden(ray, cell, here, entered, walk.first, at);
    walk.inside = at.inside;
    const MI crossedInts = hn::Ne(at.changed, hn::Zero(i));
    if (hn::AllFalse(i, crossedInts)) return;
    const MF crossed = hn::RebindMask(f, crossedInts);
    Candidates& met = walk.candidates;
    met.b = Curve::select(crossed, b, met.b);
    met.tIn = hn::IfThenElse(crossed, at.tIn, met.tIn);
    met.tOut = hn::IfThenElse(crossed, at.tOut, met.tOut);
    met.inside = hn::IfThenElse(crossedInts, at.inside, met.inside);
    met.changed = hn::IfThenElse(crossedInts, at.changed, met.changed);
    met.first = hn::Or(met.first, hn::And(crossed, walk.first));
    walk.found = hn::Or(walk.found, crossed);
    walk.active = hn::AndNot(crossed, walk.active);
  }

  // Moves lanes to the cells behind their boxes.
  HWY_INLINE void advance(const RayLanes& ray, const Boxes& box, MI moves, Walk& walk) const {
    const F f;
    const I i;
    const VI one = hn::Set(i, 1);
    const MF movesFloat = hn::RebindMask(f, moves);
    walk.first = hn::AndNot(movesFloat, walk.first);
    const MF onX = hn::And(hn::Le(box.exit[0], box.exit[1]), hn::Le(box.exit[0], box.exit[2]));
    const MF onY = hn::AndNot(onX, hn::Le(box.exit[1], box.exit[2]));
    const MF leaves[3] = {onX, onY, hn::Not(hn::Or(onX, onY))};
    MI ended = hn::RebindMask(i, hn::Ge(box.tOut, walk.tEnd));
    for (int axis = 0; axis < 3; ++axis) {
      const VI lowest = box.lowest[axis], lastCell = hn::Set(i, view_.dims[axis] - 2);
      const VI highest = hn::Min(hn::Add(lowest, hn::Sub(box.size, one)), lastCell);
      const VI at = hn::ConvertTo(i, hn::MulAdd(box.tOut, ray.direction[axis], ray.origin[axis]));
      const VI within = hn::Min(hn::Max(at, lowest), highest);
      const MI rises = hn::RebindMask(i, hn::Gt(ray.direction[axis], hn::Zero(f)));
      const VI next = hn::IfThenElse(rises, hn::Add(lowest, box.size), hn::Sub(lowest, one));
      const VI now = hn::IfThenElse(hn::RebindMask(i, leaves[axis]), next, within);
      ended = hn::Or(ended, hn::Or(hn::Gt(hn::Zero(i), now), hn::Gt(now, lastCell)));
      walk.cell[axis] = hn::IfThenElse(moves, now, walk.cell[axis]);
    }
    walk.active = hn::AndNot(hn::RebindMask(f, hn::And(moves, ended)), walk.active);
    walk.t = hn::IfThenElse(movesFloat, box.tOut, walk.t);
  }

  HWY_INLINE VI sidesOf(VF value) const {
    VI bits = hn::Zero(I());
    for (int k = 0; k < view_.surfaces; ++k) {
      const MF inside = hn::Ge(value, hn::Set(F(), view_.shifts[k]));
      bits = hn::Or(bits, hn::IfThenElseZero(hn::RebindMask(I(), inside), hn::Set(I(), 1 << k)));
    }
    return bits;
  }

  static HWY_INLINE MF isInside(VI inside, int surface) {
    return hn::RebindMask(F(), hn::Ne(hn::And(inside, hn::Set(I(), 1 << surface)), hn::Zero(I())));
  }
  // The crossing that a ray continues from lies at its first cell's entry, on one side or the other by
  // rounding.
  static HWY_INLINE Curve entered(const Curve& b, MF inside, MF first) {
    const VF start = b.start();
    const VF side =
        hn::IfThenElse(inside, hn::Max(start, hn::Zero(F())), hn::Min(start, hn::Set(F(), -1e-30f)));
    return b.startingAt(hn::IfThenElse(first, side, start));
  }
  // Returns a bit for each surface that is crossed along the curve, of lanes in `here`.
  HWY_INLINE VI changesIn(const Curve& b, VI inside, MF here, MF first, MF& undecided) const {
    VI changed = hn::Zero(I());
    for (int k = 0; k < view_.surfaces; ++k) {
      const MF side = isInside(inside, k);
      const MF crossed = leavesSide(entered(b.minus(view_.shifts[k]), side, first), side, here, undecided);
      changed = hn::Or(changed, hn::IfThenElseZero(hn::RebindMask(I(), crossed), hn::Set(I(), 1 << k)));
    }
    return changed;
  }

  // The segments of lanes through their cells, and what they come to.
  struct CellSegments {
    VF tIn, tOut;
    VI inside, changed;
  };
  // Handles lanes in cells with hidden voxels, one by one: finds their sides and the nearest visible
  // crossing, which is where the segment begins and ends then.
  HWY_NOINLINE void leaveOutHidden(const RayLanes& ray, const CellLanes& cell, MF here, MF entered, MF first,
                                   CellSegments& segments) const {
    const F f;
    const I i;
    alignas(64) std::int32_t cells[3][kLanes], inside[kLanes], changed[kLanes];
    alignas(64) float tIn[kLanes], tOut[kLanes], origin[3][kLanes], direction[3][kLanes];
    for (int axis = 0; axis < 3; ++axis) {
      hn::Store(cell[axis], i, cells[axis]);
      hn::Store(ray.origin[axis], f, origin[axis]);
      hn::Store(ray.direction[axis], f, direction[axis]);
    }
    hn::Store(segments.tIn, f, tIn);
    hn::Store(segments.tOut, f, tOut);
    hn::Store(segments.inside, i, inside);
    hn::Store(segments.changed, i, changed);
    const std::uint32_t enteredLanes = bitsOf(hn::RebindMask(i, entered)),
                        firstLanes = bitsOf(hn::RebindMask(i, first));
    bool any = false;
    forLanes(bitsOf(hn::RebindMask(i, here)), [&](std::size_t lane) {
      const glm::ivec3 at(cells[0][lane], cells[1][lane], cells[2][lane]);
      if (std::none_of(view_.shown.begin(), view_.shown.end(),
                       [&](const ShownCells& shown) { return shown.hides(at); }))
        return;
      any = true;
      const auto local = [&](float t) { return inCell(at, origin, direction, lane, t); };
      const casting::VisibleCrossing seen =
          casting::visibleCrossing(view_, at, local(tIn[lane]), local(tOut[lane]), inside[lane],
                                   (enteredLanes >> lane & 1) != 0, (firstLanes >> lane & 1) != 0);
      inside[lane] = seen.inside;
      changed[lane] = seen.changed;
      if (seen.changed != 0)
        tIn[lane] = tOut[lane] = tIn[lane] + static_cast<float>(seen.s) * (tOut[lane] - tIn[lane]);
    });
    if (any) segments = {hn::Load(f, tIn), hn::Load(f, tOut), hn::Load(i, inside), hn::Load(i, changed)};
  }

  HWY_INLINE Crossings solve(const Candidates& met, MF found, VI inside) const {
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

  const CastView& view_;
  const Cells cells_;
};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
