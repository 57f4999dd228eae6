// Steps and scheduling of rays. Included once per instruction set by simd_kernels-inl.h.
//
// 64 rays are on their way, in groups of one per lane that take turns: what a group will read at its next
// turn is asked of memory when its turn ends, so that no step waits for memory. A lane whose ray has ended
// takes the next one (when an eighth of the lanes are idle). All lanes of a group step at once, each by its
// own box of 1, 4^3 or 16^3 cells; lanes that stand in a cell that may hold their isovalue wait until half of
// the lanes do and their corners have been asked for. Nothing is accumulated: every t is that of an integer
// plane.
#if defined(ISOLUX_VOLUME_ISOSURFACE_TRACER_STEPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_ISOSURFACE_TRACER_STEPS_INL_H
#undef ISOLUX_VOLUME_ISOSURFACE_TRACER_STEPS_INL_H
#else
#define ISOLUX_VOLUME_ISOSURFACE_TRACER_STEPS_INL_H
#endif

#include <bit>
#include <cstring>

#include <hwy/cache_control.h>

#include "volume/tracer/cells-inl.h"
#include "volume/tracer/kernels.h"
#include "volume/tracer/lanes-inl.h"
#include "volume/tracer/stock-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

constexpr std::size_t kGroups = 64 / kLanes;

template <class T, bool any>
class Tracer {
 public:
  Tracer(const View& view, const T* voxels, const TraceRay* rays, std::size_t count)
      : view_(view), voxels_(voxels), stock_(view, rays, count) {}

  // write(ray, t): t of the first entry, or +inf.
  template <class Write>
  void run(const Write& write);

 private:
  template <class Write>
  void refill(Group& g, const Write& write);
  void fetch(Group& g) const;
  void aim(Group& g) const;
  template <class Write>
  void step(Group& g, const Write& write);

  const View& view_;
  const T* voxels_;
  Stock stock_;
  Group groups_[kGroups];
};

// Writes the results of lanes whose rays have ended and gives them new ones.
template <class T, bool any>
template <class Write>
HWY_INLINE void Tracer<T, any>::refill(Group& g, const Write& write) {
  const F f;
  const I i;
  alignas(64) float ends[kLanes];
  if (!any && !hn::AllFalse(i, g.hits)) hn::Store(roots(g), f, ends);
  const std::uint32_t idle = bitsOf(hn::Not(g.alive)), hits = bitsOf(g.hits);
  for (std::uint32_t bits = idle & g.busy; bits != 0; bits &= bits - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
    const auto ray = static_cast<std::size_t>(g.ray[lane]);
    if ((hits >> lane & 1) == 0)
      write(ray, kInfinity);
    else
      write(ray, any ? 0.0f : g.tBegin[lane] + ends[lane] * g.scale[lane]);
  }
  const MI start = stock_.give(g, idle, [&](std::size_t ray) { write(ray, kInfinity); });
  g.cx = hn::IfThenElse(start, hn::Load(i, g.start[0]), g.cx);
  g.cy = hn::IfThenElse(start, hn::Load(i, g.start[1]), g.cy);
  g.cz = hn::IfThenElse(start, hn::Load(i, g.start[2]), g.cz);
  g.t = hn::IfThenElse(hn::RebindMask(f, start), hn::Zero(f), g.t);
  g.alive = hn::Or(g.alive, start);
  g.busy = bitsOf(g.alive);
  g.fine = hn::AndNot(start, g.fine);
  g.outside = hn::AndNot(hn::RebindMask(f, start), g.outside);
  g.hits = hn::AndNot(g.hits, g.hits);
}

// Copies what the boxes of the lanes hold, where aim() asked for it.
template <class T, bool any>
HWY_INLINE void Tracer<T, any>::fetch(Group& g) const {
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    std::memcpy(g.word + lane, view_.table + 2 * static_cast<std::size_t>(g.offset[lane]), 4);
}

// Where the words of the boxes are that the lanes stand in; asks memory for them.
template <class T, bool any>
HWY_INLINE void Tracer<T, any>::aim(Group& g) const {
  const I i;
  const VI three = hn::Set(i, 3);
  const VI blockRow = hn::Set(i, view_.blockDims.x),
           blockSlice = hn::Set(i, view_.blockDims.x * view_.blockDims.y);
  // Sums modulo 2^32, so signed vectors give unsigned offsets.
  const VI toCells = hn::Set(i, static_cast<std::int32_t>(static_cast<std::uint32_t>(view_.cellBytes / 2)));
  const VI block = hn::Add(
      hn::Add(hn::Mul(hn::ShiftRight<2>(g.cz), blockSlice), hn::Mul(hn::ShiftRight<2>(g.cy), blockRow)),
      hn::ShiftRight<2>(g.cx));
  const VI local =
      hn::Add(hn::Add(hn::ShiftLeft<4>(hn::And(g.cz, three)), hn::ShiftLeft<2>(hn::And(g.cy, three))),
              hn::And(g.cx, three));
  const VI pairs = hn::IfThenElse(g.fine, hn::Add(hn::Add(hn::ShiftLeft<6>(block), local), toCells),
                                  hn::ShiftLeft<1>(block));
  hn::Store(hn::BitCast(U(), pairs), U(), g.offset);
  for (std::size_t lane = 0; lane < kLanes; ++lane)
    hwy::Prefetch(view_.table + 2 * static_cast<std::size_t>(g.offset[lane]));
}

template <class T, bool any>
template <class Write>
HWY_INLINE void Tracer<T, any>::step(Group& g, const Write& write) {
  const F f;
  const I i;
  const VI one = hn::Set(i, 1), three = hn::Set(i, 3), byte = hn::Set(i, 255);
  const VI lastX = hn::Set(i, view_.dims.x - 2), lastY = hn::Set(i, view_.dims.y - 2),
           lastZ = hn::Set(i, view_.dims.z - 2);
  const bool falling = view_.scale < 0.0f;
  const VI cx = g.cx, cy = g.cy, cz = g.cz;
  const MI fine = g.fine, alive = g.alive;

  // What the box holds: its range of bins, and of a block that of the 16^3 around it.
  const VI word = hn::Load(i, g.word);
  const VI bin = hn::Load(i, g.bin);
  const VI least = hn::And(word, byte), most = hn::And(hn::ShiftRight<8>(word), byte);
  const VI leastAround = hn::And(hn::ShiftRight<16>(word), byte),
           mostAround = hn::BitCast(i, hn::ShiftRight<24>(hn::BitCast(U(), word)));
  const MI below = hn::Gt(least, bin);
  const MI skips = hn::Or(below, hn::Gt(bin, most));
  const MI skipsAround = hn::AndNot(fine, hn::Or(hn::Gt(leastAround, bin), hn::Gt(bin, mostAround)));
  const MI holds = hn::AndNot(skips, alive);
  const MI waits = hn::And(holds, fine);
  MI moves = hn::And(skips, alive);

  // Corners of the cells of lanes that begin to wait.
  const MI fresh = hn::AndNot(g.waits, waits);
  if (!hn::AllFalse(i, fresh)) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(i, fresh, bytes);
    std::uint64_t bits;
    std::memcpy(&bits, bytes, 8);
    alignas(64) std::uint32_t index[kLanes];
    const VI at =
        hn::Add(hn::Mul(hn::Add(hn::Mul(cz, hn::Set(i, view_.dims.y)), cy), hn::Set(i, view_.dims.x)), cx);
    hn::Store(hn::BitCast(U(), at), U(), index);
    const std::size_t row = static_cast<std::size_t>(view_.dims.x);
    const std::size_t slice = row * static_cast<std::size_t>(view_.dims.y);
    for (; bits != 0; bits &= bits - 1) {
      const T* corner = voxels_ + index[std::countr_zero(bits)];
      hwy::Prefetch(corner);
      hwy::Prefetch(corner + row);
      hwy::Prefetch(corner + slice);
      hwy::Prefetch(corner + slice + row);
    }
  }

  // Where the ray leaves the box.
  const VI size = hn::IfThenElse(fine, one, hn::IfThenElse(skipsAround, hn::Set(i, 16), hn::Set(i, 4)));
  const VI inBox = hn::Sub(size, one);
  const VI lowX = hn::AndNot(inBox, cx), lowY = hn::AndNot(inBox, cy), lowZ = hn::AndNot(inBox, cz);
  const VF dx = hn::Load(f, g.direction[0]), dy = hn::Load(f, g.direction[1]),
           dz = hn::Load(f, g.direction[2]);
  const VF ox = hn::Load(f, g.origin[0]), oy = hn::Load(f, g.origin[1]), oz = hn::Load(f, g.origin[2]);
  // -1 where the direction is negative.
  const VI backX = hn::ShiftRight<31>(hn::BitCast(i, dx)), backY = hn::ShiftRight<31>(hn::BitCast(i, dy)),
           backZ = hn::ShiftRight<31>(hn::BitCast(i, dz));
  const VI planeX = hn::Add(lowX, hn::AndNot(backX, size)), planeY = hn::Add(lowY, hn::AndNot(backY, size)),
           planeZ = hn::Add(lowZ, hn::AndNot(backZ, size));
  const VF exitX = hn::Mul(hn::Sub(hn::ConvertTo(f, planeX), ox), hn::Load(f, g.inverse[0]));
  const VF exitY = hn::Mul(hn::Sub(hn::ConvertTo(f, planeY), oy), hn::Load(f, g.inverse[1]));
  const VF exitZ = hn::Mul(hn::Sub(hn::ConvertTo(f, planeZ), oz), hn::Load(f, g.inverse[2]));
  const VF tOut = hn::Min(hn::Min(exitX, exitY), exitZ);
  const VF tEnd = hn::Load(f, g.tEnd);

  // Boxes that hold no isosurface lie on one side.
  MF outside = g.outside;
  const MF passed = hn::RebindMask(f, moves);
  const MF boxInside = hn::RebindMask(f, falling ? hn::AndNot(below, moves) : hn::And(below, moves));
  MF entered = hn::And(outside, boxInside);
  if constexpr (!any) {
    if (!hn::AllFalse(f, entered)) {
      hn::BlendedStore(g.t, entered, f, g.found.tIn);
      hn::BlendedStore(g.t, entered, f, g.found.tOut);
    }
  }
  outside = hn::Or(hn::AndNot(boxInside, passed), hn::AndNot(passed, outside));

  // Lanes that have begun to wait in this turn have only now asked for their corners.
  const std::size_t waiting = hn::CountTrue(i, g.waits);
  g.waits = waits;
  if (waiting > 0 && 8 * waiting >= 3 * hn::CountTrue(i, alive)) {
    const MF here = hn::RebindMask(f, waits);
    entered = hn::Or(entered, testCells<T, any>(view_, voxels_, g, here, hn::Min(tOut, tEnd), outside));
    moves = hn::Or(moves, waits);
    g.waits = hn::AndNot(waits, waits);
  }

  g.hits = hn::Or(g.hits, hn::RebindMask(i, entered));
  const MI ended = hn::And(moves, hn::RebindMask(i, hn::Or(entered, hn::Not(hn::Lt(tOut, tEnd)))));
  g.alive = hn::AndNot(ended, alive);
  moves = hn::AndNot(ended, moves);
  g.outside = outside;

  // The cell behind the box.
  const auto behind = [&](VI cell, VI low, VI plane, VI back, VF exit, VF o, VF d, VI last) {
    const VI highest = hn::Min(hn::Add(low, inBox), last);
    const VI at = hn::Min(hn::Max(hn::ConvertTo(i, hn::MulAdd(tOut, d, o)), low), highest);
    const MI leaves = hn::RebindMask(i, hn::Le(exit, tOut));
    return hn::IfThenElse(moves, hn::IfThenElse(leaves, hn::Add(plane, back), at), cell);
  };
  const VI newX = behind(cx, lowX, planeX, backX, exitX, ox, dx, lastX);
  const VI newY = behind(cy, lowY, planeY, backY, exitY, oy, dy, lastY);
  const VI newZ = behind(cz, lowZ, planeZ, backZ, exitZ, oz, dz, lastZ);
  g.t = hn::IfThenElse(hn::RebindMask(f, moves), hn::Max(g.t, tOut), g.t);
  const VI changed = hn::Or(hn::Or(hn::Xor(newX, cx), hn::Xor(newY, cy)), hn::Xor(newZ, cz));
  g.fine = hn::AndNot(hn::Gt(changed, three), hn::Or(fine, holds));
  g.cx = newX;
  g.cy = newY;
  g.cz = newZ;
  const std::size_t living = hn::CountTrue(i, g.alive);
  if (living == 0 || (!stock_.exhausted() && 8 * (kLanes - living) >= kLanes)) refill(g, write);
  aim(g);
}

template <class T, bool any>
template <class Write>
HWY_INLINE void Tracer<T, any>::run(const Write& write) {
  const I i;
  for (Group& g : groups_) {
    g.cx = g.cy = g.cz = hn::Zero(i);
    g.t = hn::Zero(F());
    const MI none = hn::Gt(g.cx, g.cx);
    g.alive = g.fine = g.hits = g.waits = none;
    g.outside = hn::RebindMask(F(), none);
    refill(g, write);
    aim(g);
  }
  for (std::size_t busy = 1; busy != 0;) {
    busy = 0;
    fetch(groups_[0]);
    for (std::size_t k = 0; k < kGroups; ++k) {
      if (k + 1 < kGroups) fetch(groups_[k + 1]);
      if (groups_[k].busy == 0) continue;
      ++busy;
      step(groups_[k], write);
    }
  }
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
