// The first crossings that cuts leave: those of surfaces that are cut count only where rays are in the kept
// region (volume/clip). What resources/shaders/cast/clip.glsl does. Included once per instruction set by
// simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_KEPT_CROSSINGS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_KEPT_CROSSINGS_INL_H
#undef ISOLUX_VOLUME_CAST_KEPT_CROSSINGS_INL_H
#else
#define ISOLUX_VOLUME_CAST_KEPT_CROSSINGS_INL_H
#endif

#include "volume/cast/crossing_finders-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

struct StretchLanes {
  VF begin, end;
};

// The intervals in which rays are in the kept region: between the faces, and in no removed box.
struct KeptLanes {
  StretchLanes between;
  StretchLanes gone[ClipRegion::kMostRemoved];  // begin >= end where a ray is not in the box
  std::size_t boxes = 0;

  MF holds(VF t) const {
    MF held = hn::And(hn::Ge(t, between.begin), hn::Le(t, between.end));
    for (std::size_t i = 0; i < boxes; ++i) held = hn::AndNot(isIn(gone[i], t), held);
    return held;
  }
  // What is left of the first stretch that ends behind t; begin > end where there is none.
  StretchLanes behind(VF t) const {
    const F f;
    StretchLanes stretch{hn::Max(t, between.begin), between.end};
    MF moved = hn::Eq(t, t);
    for (std::size_t pass = 0; pass < boxes && !hn::AllFalse(f, moved); ++pass) {
      moved = hn::Lt(t, t);
      for (std::size_t i = 0; i < boxes; ++i) {
        const MF within = isIn(gone[i], stretch.begin);
        stretch.begin = hn::IfThenElse(within, gone[i].end, stretch.begin);
        moved = hn::Or(moved, within);
      }
    }
    for (std::size_t i = 0; i < boxes; ++i) {
      const MF later = hn::And(hn::Gt(gone[i].begin, stretch.begin), hn::Lt(gone[i].begin, gone[i].end));
      stretch.end = hn::IfThenElse(later, hn::Min(stretch.end, gone[i].begin), stretch.end);
    }
    return stretch;
  }

 private:
  static MF isIn(const StretchLanes& box, VF t) { return hn::And(hn::Ge(t, box.begin), hn::Lt(t, box.end)); }
};

inline StretchLanes betweenFaces(const CastView& view, const RayLanes& ray) {
  const F f;
  const VF zero = hn::Zero(f), never = hn::Set(f, kInfinity);
  StretchLanes kept{hn::Neg(never), never};
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
inline StretchLanes stretchIn(const CastView::Removed& box, const VF (&at)[3], const VF (&per)[3]) {
  const F f;
  const VF zero = hn::Zero(f), never = hn::Set(f, kInfinity);
  StretchLanes within{hn::Neg(never), never};
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
  for (std::size_t i = 0; i < kept.boxes; ++i) kept.gone[i] = stretchIn(view.removed[i], at, per);
  return kept;
}

// Lanes whose surface is one of the bits of `surfaces`.
inline MF isOneOf(const CastView& view, int surfaces, VI surface) {
  MI any = hn::Ne(surface, surface);
  for (int k = 0; k < view.surfaces; ++k)
    if ((surfaces >> k & 1) != 0) any = hn::Or(any, hn::Eq(surface, hn::Set(I(), k)));
  return hn::RebindMask(F(), any);
}

// Puts the crossings of lanes `seen` into `all`.
inline void take(MF seen, const Crossings& crossing, Crossings& all) {
  const MI seenInts = hn::RebindMask(I(), seen);
  all.found = hn::Or(all.found, seen);
  all.t = hn::IfThenElse(seen, crossing.t, all.t);
  all.surface = hn::IfThenElse(seenInts, crossing.surface, all.surface);
  all.inside = hn::IfThenElse(seenInts, crossing.inside, all.inside);
}

// Where all surfaces are cut alike, rays begin and end with each stretch of the kept region.
template <class Cells>
Crossings findAllCut(const CastView& view, const CrossingFinder<Cells>& finder, const RayLanes& ray, VF t,
                     VF tEnd, MF alive, MF carried, VI inside) {
  const F f;
  const KeptLanes kept = keptOf(view, ray);
  Crossings all{hn::Lt(t, t), t, hn::Zero(I()), inside};
  for (;;) {
    const StretchLanes stretch = kept.behind(t);
    const MF later = hn::Gt(stretch.begin, t);
    t = stretch.begin;
    alive = hn::And(alive, hn::And(hn::Le(t, stretch.end), hn::Le(t, tEnd)));
    carried = hn::And(alive, hn::AndNot(later, carried));
    if (hn::AllFalse(f, alive)) return all;
    Crossings crossing = finder.find(ray, t, hn::Min(tEnd, stretch.end), alive, carried, inside);
    crossing.found =
        hn::And(crossing.found, hn::Le(crossing.t, stretch.end));  // cells are looked through to their ends
    if (kept.boxes == 0) return crossing;
    take(crossing.found, crossing, all);
    alive = hn::And(hn::AndNot(crossing.found, alive), hn::Lt(stretch.end, kept.between.end));
    t = stretch.end;
    carried = hn::Lt(t, t);
  }
}

// Where some are not, crossings of cut surfaces outside the region are passed over, and sides carried on.
template <class Cells>
Crossings findSomeCut(const CastView& view, const CrossingFinder<Cells>& finder, const RayLanes& ray, VF t,
                      VF tEnd, MF alive, MF carried, VI inside) {
  const F f;
  const I i;
  const KeptLanes kept = keptOf(view, ray);
  Crossings all{hn::Lt(t, t), t, hn::Zero(i), inside};
  constexpr int most = 4096;  // crossings passed over
  for (int passed = 0; passed < most && !hn::AllFalse(f, alive); ++passed) {
    const Crossings crossing = finder.find(ray, t, tEnd, alive, carried, inside);
    const MF seen = hn::And(crossing.found, hn::Or(hn::Not(isOneOf(view, view.clipped, crossing.surface)),
                                                   kept.holds(crossing.t)));
    take(seen, crossing, all);
    alive = hn::AndNot(seen, crossing.found);
    t = hn::IfThenElse(alive, crossing.t, t);
    inside = hn::IfThenElse(hn::RebindMask(i, alive), hn::And(crossing.inside, hn::Set(i, 15)), inside);
    carried = alive;
  }
  return all;
}

// As CrossingFinder::find().
template <class Cells>
HWY_NOINLINE Crossings findKept(const CastView& view, const CrossingFinder<Cells>& finder,
                                const RayLanes& ray, VF t, VF tEnd, MF alive, MF carried, VI inside) {
  if (view.faceCount + view.removedCount == 0 || view.clipped == 0)
    return finder.find(ray, t, tEnd, alive, carried, inside);
  const int all = (1 << view.surfaces) - 1;
  if ((view.clipped & all) == all) return findAllCut(view, finder, ray, t, tEnd, alive, carried, inside);
  return findSomeCut(view, finder, ray, t, tEnd, alive, carried, inside);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
