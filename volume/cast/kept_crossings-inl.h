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

// Between which t rays are in the kept region.
struct KeptLanes {
  VF begin, end;
  MF holds(VF t) const { return hn::And(hn::Ge(t, begin), hn::Le(t, end)); }
};

inline KeptLanes keptOf(const CastView& view, const RayLanes& ray) {
  const F f;
  const VF zero = hn::Zero(f), never = hn::Set(f, kInfinity);
  KeptLanes kept{hn::Neg(never), never};
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

// Lanes whose surface is one of the bits of `surfaces`.
inline MF isOneOf(const CastView& view, int surfaces, VI surface) {
  MI any = hn::Ne(surface, surface);
  for (int k = 0; k < view.surfaces; ++k)
    if ((surfaces >> k & 1) != 0) any = hn::Or(any, hn::Eq(surface, hn::Set(I(), k)));
  return hn::RebindMask(F(), any);
}

// Where all surfaces are cut alike, rays begin and end with the kept region.
template <class Cells>
Crossings findAllCut(const CastView& view, const CrossingFinder<Cells>& finder, const RayLanes& ray, VF t,
                     VF tEnd, MF alive, MF carried, VI inside) {
  const F f;
  const KeptLanes kept = keptOf(view, ray);
  const MF later = hn::Gt(kept.begin, t);
  t = hn::IfThenElse(later, kept.begin, t);
  alive = hn::And(alive, hn::Le(t, kept.end));
  carried = hn::And(alive, hn::AndNot(later, carried));
  if (hn::AllFalse(f, alive)) return {hn::Lt(t, t), t, hn::Zero(I()), inside};
  Crossings crossing = finder.find(ray, t, hn::Min(tEnd, kept.end), alive, carried, inside);
  crossing.found =
      hn::And(crossing.found, hn::Le(crossing.t, kept.end));  // cells are looked through to their ends
  return crossing;
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
    const MI seenInts = hn::RebindMask(i, seen);
    all.found = hn::Or(all.found, seen);
    all.t = hn::IfThenElse(seen, crossing.t, all.t);
    all.surface = hn::IfThenElse(seenInts, crossing.surface, all.surface);
    all.inside = hn::IfThenElse(seenInts, crossing.inside, all.inside);
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
  if (view.faceCount == 0 || view.clipped == 0) return finder.find(ray, t, tEnd, alive, carried, inside);
  const int all = (1 << view.surfaces) - 1;
  if ((view.clipped & all) == all) return findAllCut(view, finder, ray, t, tEnd, alive, carried, inside);
  return findSomeCut(view, finder, ray, t, tEnd, alive, carried, inside);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
