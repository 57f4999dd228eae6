// Finds the first crossings in clipped volumes: those of clipped surfaces count only where rays are in the
// kept region (volume/clip). As resources/shaders/cast/clip.glsl. Included once per instruction set by
// simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_KEPT_CROSSINGS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_KEPT_CROSSINGS_INL_H
#undef ISOLUX_VOLUME_CAST_KEPT_CROSSINGS_INL_H
#else
#define ISOLUX_VOLUME_CAST_KEPT_CROSSINGS_INL_H
#endif

#include <variant>

#include "volume/cast/cubic_cells-inl.h"
#include "volume/cast/first_crossing-inl.h"
#include "volume/cast/trilinear_cells-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// Calls use(finder) with the finder of crossings for the view's field and samples.
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

struct IntervalLanes {
  VF begin, end;
};

// The intervals in which rays are in the kept region: between the faces, and in no removed box.
struct KeptLanes {
  IntervalLanes between;
  IntervalLanes gone[ClipRegion::kMostRemoved];  // begin >= end where a ray is not in the box
  std::size_t boxes = 0;

  MF holds(VF t) const {
    MF held = hn::And(hn::Ge(t, between.begin), hn::Le(t, between.end));
    for (std::size_t i = 0; i < boxes; ++i) held = hn::AndNot(isIn(gone[i], t), held);
    return held;
  }
  // Returns the rest of the first interval that ends behind t; begin > end where there is none.
  IntervalLanes behind(VF t) const {
    const F f;
    IntervalLanes interval{hn::Max(t, between.begin), between.end};
    MF moved = hn::Eq(t, t);
    for (std::size_t pass = 0; pass < boxes && !hn::AllFalse(f, moved); ++pass) {
      moved = hn::Lt(t, t);
      for (std::size_t i = 0; i < boxes; ++i) {
        const MF within = isIn(gone[i], interval.begin);
        interval.begin = hn::IfThenElse(within, gone[i].end, interval.begin);
        moved = hn::Or(moved, within);
      }
    }
    for (std::size_t i = 0; i < boxes; ++i) {
      const MF later = hn::And(hn::Gt(gone[i].begin, interval.begin), hn::Lt(gone[i].begin, gone[i].end));
      interval.end = hn::IfThenElse(later, hn::Min(interval.end, gone[i].begin), interval.end);
    }
    return interval;
  }

 private:
  static MF isIn(const IntervalLanes& box, VF t) { return hn::And(hn::Ge(t, box.begin), hn::Lt(t, box.end)); }
};

inline IntervalLanes betweenFaces(const CastView& view, const RayLanes& ray) {
  const F f;
  const VF zero = hn::Zero(f), never = hn::Set(f, kInfinity);
  IntervalLanes kept{hn::Neg(never), never};
  for (std::size_t i = 0; i < view.faceCount; ++i) {
    VF at = hn::Set(f, view.faces[i].w), per = zero;
    for (int axis = 0; axis < 3; ++axis) {
      const VF normal = hn::Set(f, view.faces[i][axis]);
      at = hn::MulAdd(normal, ray.origin[axis], at);
      per = hn::MulAdd(normal, ray.direction[axis], per);
    }
    const VF t = hn::Neg(hn::Div(at, per));
    const MF leaves = hn::Gt(per, zero), enters = hn::Lt(per, zero);
    const MF beside = hn::AndNot(hn::Or(leaves, enters), hn::Gt(at, zero));
    kept.end = hn::IfThenElse(leaves, hn::Min(kept.end, t), kept.end);
    kept.end = hn::IfThenElse(beside, hn::Neg(never), kept.end);
    kept.begin = hn::IfThenElse(enters, hn::Max(kept.begin, t), kept.begin);
  }
  return kept;
}

// `at`, `per`: origin and direction along the box's axes.
inline IntervalLanes intervalIn(const CastView::Removed& box, const VF (&at)[3], const VF (&per)[3]) {
  const F f;
  const VF zero = hn::Zero(f), never = hn::Set(f, kInfinity);
  IntervalLanes within{hn::Neg(never), never};
  for (int axis = 0; axis < 3; ++axis) {
    const VF low = hn::Set(f, box.low[axis]), high = hn::Set(f, box.high[axis]);
    const VF toLow = hn::Div(hn::Sub(low, at[axis]), per[axis]),
             toHigh = hn::Div(hn::Sub(high, at[axis]), per[axis]);
    const MF rises = hn::Gt(per[axis], zero), moves = hn::Or(rises, hn::Lt(per[axis], zero));
    const MF beside = hn::AndNot(moves, hn::Or(hn::Lt(at[axis], low), hn::Ge(at[axis], high)));
    const VF enters = hn::IfThenElse(rises, toLow, toHigh), leaves = hn::IfThenElse(rises, toHigh, toLow);
    within.begin = hn::IfThenElse(moves, hn::Max(within.begin, enters), within.begin);
    within.end = hn::IfThenElse(moves, hn::Min(within.end, leaves), within.end);
    within.end = hn::IfThenElse(beside, hn::Neg(never), within.end);
  }
  return within;
}

inline KeptLanes keptOf(const CastView& view, const RayLanes& ray) {
  KeptLanes kept{betweenFaces(view, ray), {}, view.removedCount};
  if (kept.boxes == 0) return kept;
  const F f;
  VF at[3], per[3];
  for (int axis = 0; axis < 3; ++axis) {
    at[axis] = per[axis] = hn::Zero(f);
    for (int i = 0; i < 3; ++i) {
      const VF part = hn::Set(f, view.axes[i][axis]);
      at[axis] = hn::MulAdd(part, ray.origin[i], at[axis]);
      per[axis] = hn::MulAdd(part, ray.direction[i], per[axis]);
    }
  }
  for (std::size_t i = 0; i < kept.boxes; ++i) kept.gone[i] = intervalIn(view.removed[i], at, per);
  return kept;
}

// Returns the lanes whose surface is one of the bits of `surfaces`.
inline MF isOneOf(const CastView& view, int surfaces, VI surface) {
  MI any = hn::Ne(surface, surface);
  for (int k = 0; k < view.surfaces; ++k)
    if ((surfaces >> k & 1) != 0) any = hn::Or(any, hn::Eq(surface, hn::Set(I(), k)));
  return hn::RebindMask(F(), any);
}

// Puts the crossings of lanes in `visible` into `all`.
inline void take(MF visible, const Crossings& crossing, Crossings& all) {
  const MI ints = hn::RebindMask(I(), visible);
  all.found = hn::Or(all.found, visible);
  all.t = hn::IfThenElse(visible, crossing.t, all.t);
  all.surface = hn::IfThenElse(ints, crossing.surface, all.surface);
  all.inside = hn::IfThenElse(ints, crossing.inside, all.inside);
}

// Where all surfaces are clipped alike, rays begin and end with each interval of the kept region.
template <class Cells>
Crossings findAllCut(const CastView& view, const CrossingFinder<Cells>& finder, RaySegments rays) {
  const F f;
  const KeptLanes kept = keptOf(view, rays.ray);
  const VF tEnd = rays.tEnd;
  Crossings all{noLane(), rays.t, hn::Zero(I()), rays.inside};
  for (;;) {
    const IntervalLanes interval = kept.behind(rays.t);
    const MF later = hn::Gt(interval.begin, rays.t);
    rays.t = interval.begin;
    rays.tEnd = hn::Min(tEnd, interval.end);
    rays.active = hn::And(rays.active, hn::And(hn::Le(rays.t, interval.end), hn::Le(rays.t, tEnd)));
    rays.continued = hn::And(rays.active, hn::AndNot(later, rays.continued));
    if (hn::AllFalse(f, rays.active)) return all;
    Crossings crossing = finder.find(rays);
    // Cells are searched to their ends.
    crossing.found = hn::And(crossing.found, hn::Le(crossing.t, interval.end));
    if (kept.boxes == 0) return crossing;
    take(crossing.found, crossing, all);
    rays.active = hn::And(hn::AndNot(crossing.found, rays.active), hn::Lt(interval.end, kept.between.end));
    rays.t = interval.end;
    rays.continued = noLane();
  }
}

// Where some are not, crossings of clipped surfaces outside the region are passed over, and their state is
// propagated.
template <class Cells>
Crossings findSomeCut(const CastView& view, const CrossingFinder<Cells>& finder, RaySegments rays) {
  const F f;
  const I i;
  const KeptLanes kept = keptOf(view, rays.ray);
  Crossings all{noLane(), rays.t, hn::Zero(i), rays.inside};
  constexpr int most = 4096;  // crossings passed over
  for (int passed = 0; passed < most && !hn::AllFalse(f, rays.active); ++passed) {
    const Crossings crossing = finder.find(rays);
    const MF visible = hn::And(crossing.found, hn::Or(hn::Not(isOneOf(view, view.clipped, crossing.surface)),
                                                      kept.holds(crossing.t)));
    take(visible, crossing, all);
    rays.active = rays.continued = hn::AndNot(visible, crossing.found);
    rays.t = hn::IfThenElse(rays.active, crossing.t, rays.t);
    rays.inside =
        hn::IfThenElse(hn::RebindMask(i, rays.active), hn::And(crossing.inside, hn::Set(i, 15)), rays.inside);
  }
  return all;
}

// As CrossingFinder::find().
template <class Cells>
HWY_NOINLINE Crossings findKept(const CastView& view, const CrossingFinder<Cells>& finder,
                                const RaySegments& rays) {
  if (view.faceCount + view.removedCount == 0 || view.clipped == 0) return finder.find(rays);
  const int all = (1 << view.surfaces) - 1;
  return (view.clipped & all) == all ? findAllCut(view, finder, rays) : findSomeCut(view, finder, rays);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
