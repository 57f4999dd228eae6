// Steps rays and schedules them. Included once per instruction set by simd_kernels-inl.h.
//
// 64 rays are traced at a time, in groups of one per lane that take turns: a group prefetches at the end of
// its turn what it loads in the next one, so that no step waits for memory. A lane whose ray has ended takes
// the next one (when an eighth of the lanes are idle). All lanes of a group step at once, each by its own box
// of 1, 4^3 or 16^3 cells. Lanes in a cell that may hold their isovalue are pending until half of the lanes
// are and their corners have been prefetched. Nothing is accumulated: every t is that of an integer plane.
#if defined(ISOLUX_VOLUME_TRACER_STEPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_TRACER_STEPS_INL_H
#undef ISOLUX_VOLUME_TRACER_STEPS_INL_H
#else
#define ISOLUX_VOLUME_TRACER_STEPS_INL_H
#endif

#include <cstring>

#include <hwy/cache_control.h>

#include "volume/tracer/cells-inl.h"
#include "volume/tracer/stock-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

constexpr std::size_t kGroups = 64 / kLanes;

template <class T, bool any, bool wide>
class Tracer {
 public:
  Tracer(const View& view, const T* voxels, const TraceRay* rays, std::size_t count)
      : view_(view), voxels_(voxels, view.dims), stock_(view, rays, count) {}

  // write(ray, t): t of the first entry, or +inf.
  template <class Write>
  HWY_INLINE void run(const Write& write) {
    const I i;
    for (Group& g : groups_) {
      for (VI& cell : g.cell.axes) cell = hn::Zero(i);
      g.t = hn::Zero(F());
      g.outside = noLane();
      g.active = g.fine = g.hits = g.pending = hn::RebindMask(i, noLane());
      refill(g, write);
      prefetch(g);
    }
    for (std::size_t busy = 1; busy != 0;) {
      busy = 0;
      load(groups_[0]);
      for (std::size_t k = 0; k < kGroups; ++k) {
        if (k + 1 < kGroups) load(groups_[k + 1]);
        if (groups_[k].busy == 0) continue;
        ++busy;
        step(groups_[k], write);
      }
    }
  }

 private:
  // The boxes that the lanes of a group are in.
  struct Boxes {
    VI size;
    MI below, skipped;  // it lies below the isovalue; on either side of it
  };
  // Where rays leave boxes: the planes along each axis, and t there and at the first of them.
  struct Exits {
    VI low[3], plane[3];  // low: of the box
    VF t[3], tOut;
  };
  // Writes the results of lanes whose rays have ended and gives them new ones.
  template <class Write>
  HWY_INLINE void refill(Group& g, const Write& write) {
    const F f;
    const I i;
    alignas(64) float ends[kLanes] = {};
    if (!any && !hn::AllFalse(i, g.hits)) hn::Store(roots(g), f, ends);
    const std::uint32_t idle = bitsOf(hn::Not(g.active)), hits = bitsOf(g.hits);
    forLanes(idle & g.busy, [&](std::size_t lane) {
      const auto ray = static_cast<std::size_t>(g.ray[lane]);
      if ((hits >> lane & 1) == 0)
        write(ray, kInfinity);
      else
        write(ray, any ? 0.0f : g.tBegin[lane] + ends[lane] * g.scale[lane]);
    });
    const MI start = stock_.give(g, idle, [&](std::size_t ray) { write(ray, kInfinity); });
    for (int axis = 0; axis < 3; ++axis)
      g.cell[axis] = hn::IfThenElse(start, hn::Load(i, g.start[axis]), g.cell[axis]);
    g.t = hn::IfThenElse(hn::RebindMask(f, start), hn::Zero(f), g.t);
    g.active = hn::Or(g.active, start);
    g.busy = bitsOf(g.active);
    g.fine = hn::AndNot(start, g.fine);
    g.outside = hn::AndNot(hn::RebindMask(f, start), g.outside);
    g.hits = hn::AndNot(g.hits, g.hits);
  }

  // Returns where the word of a lane's box is.
  HWY_INLINE const std::uint8_t* boxOf(const Group& g, std::size_t lane) const {
    const std::size_t offset = g.offset[lane];
    if constexpr (!wide) return view_.table + 2 * offset;
    return g.local[lane] < 0 ? view_.table + 4 * offset
                             : view_.table + view_.cellBytes + 128 * offset + 2 * g.local[lane];
  }

  // Copies what the boxes of the lanes hold, which prefetch() has asked for.
  HWY_INLINE void load(Group& g) const {
    for (std::size_t lane = 0; lane < kLanes; ++lane) std::memcpy(g.word + lane, boxOf(g, lane), 4);
  }

  // Finds the words of the boxes that the lanes are in, and prefetches them.
  HWY_INLINE void prefetch(Group& g) const {
    const I i;
    const VI three = hn::Set(i, 3);
    const VI block =
        hn::Add(hn::Mul(hn::Add(hn::Mul(hn::ShiftRight<2>(g.cell[2]), hn::Set(i, view_.blockDims.y)),
                                hn::ShiftRight<2>(g.cell[1])),
                        hn::Set(i, view_.blockDims.x)),
                hn::ShiftRight<2>(g.cell[0]));
    const VI local = hn::Add(
        hn::Add(hn::ShiftLeft<4>(hn::And(g.cell[2], three)), hn::ShiftLeft<2>(hn::And(g.cell[1], three))),
        hn::And(g.cell[0], three));
    VI offset;
    if constexpr (wide) {
      offset = block;
      hn::Store(hn::IfThenElse(g.fine, local, hn::Set(i, -1)), i, g.local);
    } else {
      // Sums modulo 2^32, so signed vectors give unsigned offsets.
      const VI toCells =
          hn::Set(i, static_cast<std::int32_t>(static_cast<std::uint32_t>(view_.cellBytes / 2)));
      offset = hn::IfThenElse(g.fine, hn::Add(hn::Add(hn::ShiftLeft<6>(block), local), toCells),
                              hn::ShiftLeft<1>(block));
    }
    hn::Store(hn::BitCast(U(), offset), U(), g.offset);
    for (std::size_t lane = 0; lane < kLanes; ++lane) hwy::Prefetch(boxOf(g, lane));
  }

  template <class Write>
  HWY_INLINE void step(Group& g, const Write& write) {
    const F f;
    const I i;
    const Boxes box = boxesOf(g);
    const MI holding = hn::AndNot(box.skipped, g.active), pending = hn::And(holding, g.fine);
    if (const MI entered = hn::AndNot(g.pending, pending); !hn::AllFalse(i, entered))
      voxels_.prefetch(g.cell, entered);

    MI moves = hn::And(box.skipped, g.active);
    const Exits exit = exitsOf(g, box.size);
    MF hit = passBoxes(g, box.below, moves);
    const VF tEnd = hn::Load(f, g.tEnd);
    // Lanes that have become pending in this turn have only now asked for their corners.
    const std::size_t waiting = hn::CountTrue(i, g.pending);
    g.pending = pending;
    if (waiting > 0 && 8 * waiting >= 3 * hn::CountTrue(i, g.active)) {
      const MF here = hn::RebindMask(f, pending);
      hit = hn::Or(hit, testCells<any>(view_, voxels_, g, here, hn::Min(exit.tOut, tEnd)));
      moves = hn::Or(moves, pending);
      g.pending = hn::AndNot(pending, pending);
    }

    g.hits = hn::Or(g.hits, hn::RebindMask(i, hit));
    const MI ended = hn::And(moves, hn::RebindMask(i, hn::Or(hit, hn::Not(hn::Lt(exit.tOut, tEnd)))));
    g.active = hn::AndNot(ended, g.active);
    advance(g, box.size, exit, hn::AndNot(ended, moves), holding);
    const std::size_t active = hn::CountTrue(i, g.active);
    if (active == 0 || (!stock_.exhausted() && 8 * (kLanes - active) >= kLanes)) refill(g, write);
    prefetch(g);
  }

  // The word of a box holds its range of bins, and that of a block the range of the 16^3 around it, too.
  HWY_INLINE Boxes boxesOf(const Group& g) const {
    const I i;
    const VI byte = hn::Set(i, 255), word = hn::Load(i, g.word), bin = hn::Load(i, g.bin);
    const VI least = hn::And(word, byte), most = hn::And(hn::ShiftRight<8>(word), byte);
    const VI leastAround = hn::And(hn::ShiftRight<16>(word), byte),
             mostAround = hn::BitCast(i, hn::ShiftRight<24>(hn::BitCast(U(), word)));
    Boxes box;
    box.below = hn::Gt(least, bin);
    box.skipped = hn::Or(box.below, hn::Gt(bin, most));
    const MI skipsAround = hn::AndNot(g.fine, hn::Or(hn::Gt(leastAround, bin), hn::Gt(bin, mostAround)));
    box.size =
        hn::IfThenElse(g.fine, hn::Set(i, 1), hn::IfThenElse(skipsAround, hn::Set(i, 16), hn::Set(i, 4)));
    return box;
  }

  HWY_INLINE Exits exitsOf(const Group& g, VI size) const {
    const F f;
    const I i;
    const VI inBox = hn::Sub(size, hn::Set(i, 1));
    Exits exit;
    for (int axis = 0; axis < 3; ++axis) {
      const VI back = hn::ShiftRight<31>(hn::BitCast(i, hn::Load(f, g.direction[axis])));
      exit.low[axis] = hn::AndNot(inBox, g.cell[axis]);
      exit.plane[axis] = hn::Add(exit.low[axis], hn::AndNot(back, size));
      const VF away = hn::Sub(hn::ConvertTo(f, exit.plane[axis]), hn::Load(f, g.origin[axis]));
      exit.t[axis] = hn::Mul(away, hn::Load(f, g.inverse[axis]));
    }
    exit.tOut = hn::Min(hn::Min(exit.t[0], exit.t[1]), exit.t[2]);
    return exit;
  }

  // Boxes that hold no isosurface lie on one side. Returns the lanes that come into the inside with one.
  HWY_INLINE MF passBoxes(Group& g, MI below, MI moves) const {
    const F f;
    const bool falling = view_.scale < 0.0f;
    const MF passed = hn::RebindMask(f, moves);
    const MF inside = hn::RebindMask(f, falling ? hn::AndNot(below, moves) : hn::And(below, moves));
    const MF hit = hn::And(g.outside, inside);
    if constexpr (!any) {
      if (!hn::AllFalse(f, hit)) {
        hn::BlendedStore(g.t, hit, f, g.found.tIn);
        hn::BlendedStore(g.t, hit, f, g.found.tOut);
      }
    }
    g.outside = hn::Or(hn::AndNot(inside, passed), hn::AndNot(passed, g.outside));
    return hit;
  }

  // Moves lanes to the cells behind their boxes. holding: lanes whose box may hold the isovalue.
  HWY_INLINE void advance(Group& g, VI size, const Exits& exit, MI moves, MI holding) const {
    const F f;
    const I i;
    const VI inBox = hn::Sub(size, hn::Set(i, 1));
    VI changed = hn::Zero(i);
    for (int axis = 0; axis < 3; ++axis) {
      const VF d = hn::Load(f, g.direction[axis]);
      const VI back = hn::ShiftRight<31>(hn::BitCast(i, d));  // -1 where the direction is negative
      const VI highest = hn::Min(hn::Add(exit.low[axis], inBox), hn::Set(i, view_.dims[axis] - 2));
      const VF at = hn::MulAdd(exit.tOut, d, hn::Load(f, g.origin[axis]));
      const VI within = hn::Min(hn::Max(hn::ConvertTo(i, at), exit.low[axis]), highest);
      const MI leaves = hn::RebindMask(i, hn::Le(exit.t[axis], exit.tOut));
      const VI next = hn::IfThenElse(leaves, hn::Add(exit.plane[axis], back), within);
      const VI now = hn::IfThenElse(moves, next, g.cell[axis]);
      changed = hn::Or(changed, hn::Xor(now, g.cell[axis]));
      g.cell[axis] = now;
    }
    g.t = hn::IfThenElse(hn::RebindMask(f, moves), hn::Max(g.t, exit.tOut), g.t);
    g.fine = hn::AndNot(hn::Gt(changed, hn::Set(i, 3)), hn::Or(g.fine, holding));
  }

  const View& view_;
  const VoxelLanes<T, wide> voxels_;
  Stock stock_;
  Group groups_[kGroups];
};

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
