// The isosurface tracer with one ray per SIMD lane, compiled for every instruction set and chosen at run
// time. Needs voxels and cell ranges of less than 2 GiB each (simdCanTrace()).
//
// A lane whose ray has ended takes the next one (when an eighth of the lanes are idle). All lanes step at
// once, each by its own box of 1, 4^3 or 16^3 cells; lanes that stand in a cell that may hold their isovalue
// wait until half of the lanes do. Nothing is accumulated: every t is that of an integer plane.
#include "volume/isosurface_tracer_kernels.h"

// These do not differ for this code, or have vectors without a size known here. Where none is left the scalar
// kernels serve.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume/isosurface_tracer_simd.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

#include <algorithm>
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128

namespace hn = hwy::HWY_NAMESPACE;

using F = hn::ScalableTag<float>;
using I = hn::ScalableTag<std::int32_t>;
using U = hn::ScalableTag<std::uint32_t>;
using VF = hn::Vec<F>;
using VI = hn::Vec<I>;
using MF = hn::Mask<F>;
using MI = hn::Mask<I>;
constexpr std::size_t kLanes = hn::MaxLanes(F());

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// The values at a cell's corners x and x + 1.
struct Edge {
  VF low, high;
};

// Four bytes at an offset of every lane. By scalar loads: gathers are no faster where they were measured, and
// two corners are loaded at once below, which gathers of floats are not.
HWY_INLINE VI loadWords(const std::uint8_t* base, VI offset) {
  alignas(64) std::int32_t at[kLanes], words[kLanes];
  hn::Store(offset, I(), at);
  for (std::size_t lane = 0; lane < kLanes; ++lane) std::memcpy(words + lane, base + at[lane], 4);
  return hn::Load(I(), words);
}

// The four edges along x of every lane's cell.
struct Corners {
  Edge e00, e10, e01, e11;
};

HWY_INLINE Edge edgeOf(const std::int16_t*, const std::int32_t* pairs) {
  const VI pair = hn::Load(I(), pairs);
  return {hn::ConvertTo(F(), hn::ShiftRight<16>(hn::ShiftLeft<16>(pair))),
          hn::ConvertTo(F(), hn::ShiftRight<16>(pair))};
}

HWY_INLINE Edge edgeOf(const std::uint16_t*, const std::int32_t* pairs) {
  const VI pair = hn::Load(I(), pairs);
  return {hn::ConvertTo(F(), hn::And(pair, hn::Set(I(), 0xffff))),
          hn::ConvertTo(F(), hn::BitCast(I(), hn::ShiftRight<16>(hn::BitCast(U(), pair))))};
}

HWY_INLINE Edge edgeOf(const float*, const std::int64_t* pairs) {
  const hn::Repartition<std::int64_t, F> l;
  const VF a = hn::BitCast(F(), hn::Load(l, pairs)), b = hn::BitCast(F(), hn::Load(l, pairs + kLanes / 2));
  return {hn::ConcatEven(F(), b, a), hn::ConcatOdd(F(), b, a)};
}

template <class T>
HWY_INLINE Corners loadCorners(const T* voxels, VI index, std::size_t row, std::size_t slice) {
  using Pair = std::conditional_t<std::is_same_v<T, float>, std::int64_t, std::int32_t>;
  alignas(64) std::int32_t at[kLanes];
  alignas(64) Pair pairs[4][kLanes];
  hn::Store(index, I(), at);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    const T* corner = voxels + at[lane];
    std::memcpy(&pairs[0][lane], corner, sizeof(Pair));
    std::memcpy(&pairs[1][lane], corner + row, sizeof(Pair));
    std::memcpy(&pairs[2][lane], corner + slice, sizeof(Pair));
    std::memcpy(&pairs[3][lane], corner + slice + row, sizeof(Pair));
  }
  return {edgeOf(voxels, pairs[0]), edgeOf(voxels, pairs[1]), edgeOf(voxels, pairs[2]),
          edgeOf(voxels, pairs[3])};
}

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

// A first entry that is known but for its place: in s in [low, high], outside at low, inside at high.
struct Found {
  alignas(64) float b0[kLanes], b1[kLanes], b2[kLanes], b3[kLanes];
  alignas(64) float low[kLanes], high[kLanes], atLow[kLanes], atHigh[kLanes];
  alignas(64) float tIn[kLanes], tOut[kLanes];
};

template <class T, bool any>
class Tracer {
 public:
  Tracer(const View& view, const T* voxels, const TraceRay* rays, std::size_t count)
      : view_(view), voxels_(voxels), rays_(rays), count_(count) {}

  // write(ray, t): t of the first entry, or +inf.
  template <class Write>
  void run(const Write& write);

 private:
  VF lerp(VF a, VF difference, VF t) const { return hn::MulAdd(t, difference, a); }
  Cubic cubicOf(VI cx, VI cy, VI cz, VF tIn, VF tOut, MF& known) const;
  // Entries in the cells of lanes `here`; updates `outside`.
  MF testCells(MF here, VI cx, VI cy, VI cz, VF t, VF tOut, MF& outside);
  MF findBrackets(const Cubic& f, MF here, VF tIn, VF tOut, VF& atLow);
  VF roots() const;
  template <class Write>
  bool nextRay(std::size_t lane, const Write& write);

  const View& view_;
  const T* voxels_;
  const TraceRay* rays_;
  std::size_t count_, next_ = 0;
  // The rays of the lanes (PreparedRay).
  alignas(64) float origin_[3][kLanes] = {}, direction_[3][kLanes] = {}, inverse_[3][kLanes] = {};
  alignas(64) float tEnd_[kLanes] = {}, isovalue_[kLanes] = {};
  alignas(64) std::int32_t bin_[kLanes] = {}, cell_[3][kLanes] = {};
  float scale_[kLanes] = {}, tBegin_[kLanes] = {};
  std::size_t ray_[kLanes] = {};
  bool busy_[kLanes] = {};  // a result is not yet written
  Found found_ = {};
};

template <class T, bool any>
HWY_INLINE Cubic Tracer<T, any>::cubicOf(VI cx, VI cy, VI cz, VF tIn, VF tOut, MF& known) const {
  const F f;
  const I i;
  const VI at =
      hn::Add(hn::Mul(hn::Add(hn::Mul(cz, hn::Set(i, view_.dims.y)), cy), hn::Set(i, view_.dims.x)), cx);
  const Corners corners =
      loadCorners(voxels_, at, static_cast<std::size_t>(view_.dims.x),
                  static_cast<std::size_t>(view_.dims.x) * static_cast<std::size_t>(view_.dims.y));
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
  const VF dx = hn::Load(f, direction_[0]), dy = hn::Load(f, direction_[1]), dz = hn::Load(f, direction_[2]);
  const VF fromX = hn::Sub(hn::Load(f, origin_[0]), hn::ConvertTo(f, cx));
  const VF fromY = hn::Sub(hn::Load(f, origin_[1]), hn::ConvertTo(f, cy));
  const VF fromZ = hn::Sub(hn::Load(f, origin_[2]), hn::ConvertTo(f, cz));
  const VF px = within(hn::MulAdd(tIn, dx, fromX)), qx = within(hn::MulAdd(tOut, dx, fromX));
  const VF py = within(hn::MulAdd(tIn, dy, fromY)), qy = within(hn::MulAdd(tOut, dy, fromY));
  const VF pz = within(hn::MulAdd(tIn, dz, fromZ)), qz = within(hn::MulAdd(tOut, dz, fromZ));
  // Bernstein coefficients are the polar form of the trilinear function at the stretch's two ends. The
  // isovalue is subtracted first: differences of like numbers are exact.
  const VF iso = hn::Load(f, isovalue_);
  const VF a00 = hn::Sub(e00.low, iso), a10 = hn::Sub(e10.low, iso), a01 = hn::Sub(e01.low, iso),
           a11 = hn::Sub(e11.low, iso);
  const VF x00 = hn::Sub(e00.high, e00.low), x10 = hn::Sub(e10.high, e10.low),
           x01 = hn::Sub(e01.high, e01.low), x11 = hn::Sub(e11.high, e11.low);
  const VF p00 = lerp(a00, x00, px), p10 = lerp(a10, x10, px), p01 = lerp(a01, x01, px),
           p11 = lerp(a11, x11, px);
  const VF q00 = lerp(a00, x00, qx), q10 = lerp(a10, x10, qx), q01 = lerp(a01, x01, qx),
           q11 = lerp(a11, x11, qx);
  const VF py0 = hn::Sub(p10, p00), py1 = hn::Sub(p11, p01), qy0 = hn::Sub(q10, q00), qy1 = hn::Sub(q11, q01);
  const VF pp = lerp(p00, py0, py), pq = lerp(p00, py0, qy), qp = lerp(q00, qy0, py), qq = lerp(q00, qy0, qy);
  const VF ppZ = hn::Sub(lerp(p01, py1, py), pp), pqZ = hn::Sub(lerp(p01, py1, qy), pq);
  const VF qpZ = hn::Sub(lerp(q01, qy1, py), qp), qqZ = hn::Sub(lerp(q01, qy1, qy), qq);
  const VF sign = hn::Set(f, view_.scale), third = hn::Set(f, view_.scale / 3.0f);
  return {hn::Mul(sign, lerp(pp, ppZ, pz)),
          hn::Mul(third, hn::Add(hn::Add(lerp(qp, qpZ, pz), lerp(pq, pqZ, pz)), lerp(pp, ppZ, qz))),
          hn::Mul(third, hn::Add(hn::Add(lerp(qq, qqZ, pz), lerp(qp, qpZ, qz)), lerp(pq, pqZ, qz))),
          hn::Mul(sign, lerp(qq, qqZ, qz))};
}

// The bracket of the first entry from a stretch's beginning, or from where it has left the inside that it
// begins in. Equal to the scalar findBracket().
template <class T, bool any>
HWY_INLINE MF Tracer<T, any>::findBrackets(const Cubic& f, MF here, VF tIn, VF tOut, VF& atLow) {
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
    hn::BlendedStore(f.b0, found, d, found_.b0);
    hn::BlendedStore(f.b1, found, d, found_.b1);
    hn::BlendedStore(f.b2, found, d, found_.b2);
    hn::BlendedStore(f.b3, found, d, found_.b3);
    hn::BlendedStore(hn::IfThenElseZero(fromMinimum, sMinimum), found, d, found_.low);
    hn::BlendedStore(hn::IfThenElse(toMaximum, sMaximum, one), found, d, found_.high);
    hn::BlendedStore(atLow, found, d, found_.atLow);
    hn::BlendedStore(atHigh, found, d, found_.atHigh);
    hn::BlendedStore(tIn, found, d, found_.tIn);
    hn::BlendedStore(tOut, found, d, found_.tOut);
  }
  return found;
}

template <class T, bool any>
HWY_INLINE MF Tracer<T, any>::testCells(MF here, VI cx, VI cy, VI cz, VF t, VF tOut, MF& outside) {
  const F d;
  const VF zero = hn::Zero(d);
  MF known = here;
  const Cubic f = cubicOf(cx, cy, cz, t, tOut, known);
  const MF gap = hn::AndNot(known, here);
  here = hn::And(here, known);
  // On the surface a stretch begins outside where f falls.
  const VF slope = hn::IfThenElse(hn::Eq(f.b1, zero), hn::IfThenElse(hn::Eq(f.b2, zero), f.b3, f.b2), f.b1);
  const MF beginsOutside = hn::Or(hn::Lt(f.b0, zero), hn::And(hn::Eq(f.b0, zero), hn::Lt(slope, zero)));
  const MF atOnce = hn::And(here, hn::AndNot(beginsOutside, outside));
  if constexpr (!any) {
    hn::BlendedStore(t, atOnce, d, found_.tIn);
    hn::BlendedStore(t, atOnce, d, found_.tOut);
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
  if (!hn::AllFalse(d, open)) entered = hn::Or(entered, findBrackets(f, open, t, tOut, atLow));
  const MF endsOutside =
      hn::Or(hn::Lt(f.b3, zero), hn::And(hn::Eq(f.b3, zero), hn::Or(hn::Lt(atLow, zero), beginsOutside)));
  outside = hn::Or(hn::And(here, endsOutside), hn::AndNot(hn::Or(here, gap), outside));
  return entered;
}

template <class T, bool any>
HWY_INLINE VF Tracer<T, any>::roots() const {
  const F d;
  const Cubic f{hn::Load(d, found_.b0), hn::Load(d, found_.b1), hn::Load(d, found_.b2),
                hn::Load(d, found_.b3)};
  VF low = hn::Load(d, found_.low), high = hn::Load(d, found_.high);
  VF atLow = hn::Load(d, found_.atLow), atHigh = hn::Load(d, found_.atHigh);
  const VF half = hn::Set(d, 0.5f), zero = hn::Zero(d);
  VF s = low;
  for (int step = 0; step < 8; ++step) {  // regula falsi, Illinois
    const VF next = hn::NegMulAdd(atLow, hn::Div(hn::Sub(high, low), hn::Sub(atHigh, atLow)), low);
    // Where both ends are 0 the root is found.
    s = hn::IfThenElse(hn::Eq(next, next), next, s);
    const VF value = f(s);
    const MF same = hn::Not(hn::Xor(hn::Gt(value, zero), hn::Gt(atHigh, zero)));
    low = hn::IfThenElse(same, low, high);
    atLow = hn::IfThenElse(same, hn::Mul(half, atLow), atHigh);
    high = s;
    atHigh = value;
  }
  const VF tIn = hn::Load(d, found_.tIn), tOut = hn::Load(d, found_.tOut);
  return hn::MulAdd(s, hn::Sub(tOut, tIn), tIn);
}

// The next ray that may meet something becomes that of the lane.
template <class T, bool any>
template <class Write>
HWY_INLINE bool Tracer<T, any>::nextRay(std::size_t lane, const Write& write) {
  PreparedRay ray;
  for (; next_ < count_; ++next_) {
    if (!prepare(view_, rays_[next_], ray)) {
      write(next_, kInfinity);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      origin_[axis][lane] = ray.origin[axis];
      direction_[axis][lane] = ray.direction[axis];
      inverse_[axis][lane] = ray.inverse[axis];
      cell_[axis][lane] = ray.cell[axis];
    }
    tEnd_[lane] = ray.tEnd;
    isovalue_[lane] = ray.isovalue;
    bin_[lane] = ray.bin;
    scale_[lane] = ray.scale;
    tBegin_[lane] = ray.tBegin;
    ray_[lane] = next_++;
    return true;
  }
  return false;
}

HWY_INLINE MI maskOf(const std::uint8_t* lanes) {
  alignas(64) std::int32_t wide[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane) wide[lane] = lanes[lane];
  return hn::Gt(hn::Load(I(), wide), hn::Zero(I()));
}

template <class T, bool any>
template <class Write>
HWY_INLINE void Tracer<T, any>::run(const Write& write) {
  const F f;
  const I i;
  const VI zero = hn::Zero(i), one = hn::Set(i, 1), three = hn::Set(i, 3), byte = hn::Set(i, 255);
  const VI blockRow = hn::Set(i, view_.blockDims.x),
           blockSlice = hn::Set(i, view_.blockDims.x * view_.blockDims.y);
  const VI toBlocks = hn::Set(i, -static_cast<std::int32_t>(view_.cellBytes));
  const VI lastX = hn::Set(i, view_.dims.x - 2), lastY = hn::Set(i, view_.dims.y - 2),
           lastZ = hn::Set(i, view_.dims.z - 2);
  const std::uint8_t* cells = view_.table + view_.cellBytes;
  const bool falling = view_.scale < 0.0f;

  VI cx = zero, cy = zero, cz = zero;
  VF t = hn::Zero(f);
  const MI none = hn::Gt(zero, one);
  MI alive = none, fine = none, hits = none;  // fine: at single cells, else at blocks
  MF outside = hn::RebindMask(f, none);
  for (;;) {
    const std::size_t living = hn::CountTrue(i, alive);
    if (living == 0 || (next_ < count_ && 8 * (kLanes - living) >= kLanes)) {
      alignas(64) float ends[kLanes];
      if (!any && !hn::AllFalse(i, hits)) hn::Store(roots(), f, ends);
      std::uint8_t livingBits[8] = {}, hitBits[8] = {};
      hn::StoreMaskBits(i, alive, livingBits);
      hn::StoreMaskBits(i, hits, hitBits);
      const auto bit = [](const std::uint8_t* bits, std::size_t lane) {
        return (bits[lane / 8] >> lane % 8 & 1) != 0;
      };
      std::uint8_t fresh[kLanes] = {};
      std::size_t started = 0;
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        if (bit(livingBits, lane)) continue;
        if (busy_[lane]) {
          if (!bit(hitBits, lane))
            write(ray_[lane], kInfinity);
          else
            write(ray_[lane], any ? 0.0f : tBegin_[lane] + ends[lane] * scale_[lane]);
        }
        busy_[lane] = nextRay(lane, write);
        fresh[lane] = busy_[lane] ? 1 : 0;
        started += fresh[lane];
      }
      if (living + started == 0) return;
      const MI start = maskOf(fresh);
      cx = hn::IfThenElse(start, hn::Load(i, cell_[0]), cx);
      cy = hn::IfThenElse(start, hn::Load(i, cell_[1]), cy);
      cz = hn::IfThenElse(start, hn::Load(i, cell_[2]), cz);
      t = hn::IfThenElse(hn::RebindMask(f, start), hn::Zero(f), t);
      alive = hn::Or(alive, start);
      fine = hn::AndNot(start, fine);
      outside = hn::AndNot(hn::RebindMask(f, start), outside);
      hits = none;
    }

    // What the box holds: its range of bins, and of a block that of the 16^3 around it.
    const VI block =
        hn::Add(hn::Add(hn::Mul(hn::ShiftRight<2>(cz), blockSlice), hn::Mul(hn::ShiftRight<2>(cy), blockRow)),
                hn::ShiftRight<2>(cx));
    const VI local =
        hn::Add(hn::Add(hn::ShiftLeft<5>(hn::And(cz, three)), hn::ShiftLeft<3>(hn::And(cy, three))),
                hn::Add(hn::And(cx, three), hn::And(cx, three)));
    const VI offset = hn::IfThenElse(fine, hn::Add(hn::ShiftLeft<7>(block), local),
                                     hn::Add(hn::ShiftLeft<2>(block), toBlocks));
    const VI word = loadWords(cells, offset);
    const VI bin = hn::Load(i, bin_);
    const VI least = hn::And(word, byte), most = hn::And(hn::ShiftRight<8>(word), byte);
    const VI leastAround = hn::And(hn::ShiftRight<16>(word), byte),
             mostAround = hn::BitCast(i, hn::ShiftRight<24>(hn::BitCast(U(), word)));
    const MI below = hn::Gt(least, bin);
    const MI skips = hn::Or(below, hn::Gt(bin, most));
    const MI skipsAround = hn::AndNot(fine, hn::Or(hn::Gt(leastAround, bin), hn::Gt(bin, mostAround)));
    const MI holds = hn::AndNot(skips, alive);
    const MI waits = hn::And(holds, fine);
    MI moves = hn::And(skips, alive);

    // Where the ray leaves the box.
    const VI size = hn::IfThenElse(fine, one, hn::IfThenElse(skipsAround, hn::Set(i, 16), hn::Set(i, 4)));
    const VI inBox = hn::Sub(size, one);
    const VI lowX = hn::AndNot(inBox, cx), lowY = hn::AndNot(inBox, cy), lowZ = hn::AndNot(inBox, cz);
    const VF dx = hn::Load(f, direction_[0]), dy = hn::Load(f, direction_[1]),
             dz = hn::Load(f, direction_[2]);
    const VF ox = hn::Load(f, origin_[0]), oy = hn::Load(f, origin_[1]), oz = hn::Load(f, origin_[2]);
    // -1 where the direction is negative.
    const VI backX = hn::ShiftRight<31>(hn::BitCast(i, dx)), backY = hn::ShiftRight<31>(hn::BitCast(i, dy)),
             backZ = hn::ShiftRight<31>(hn::BitCast(i, dz));
    const VI planeX = hn::Add(lowX, hn::AndNot(backX, size)), planeY = hn::Add(lowY, hn::AndNot(backY, size)),
             planeZ = hn::Add(lowZ, hn::AndNot(backZ, size));
    const VF exitX = hn::Mul(hn::Sub(hn::ConvertTo(f, planeX), ox), hn::Load(f, inverse_[0]));
    const VF exitY = hn::Mul(hn::Sub(hn::ConvertTo(f, planeY), oy), hn::Load(f, inverse_[1]));
    const VF exitZ = hn::Mul(hn::Sub(hn::ConvertTo(f, planeZ), oz), hn::Load(f, inverse_[2]));
    const VF tOut = hn::Min(hn::Min(exitX, exitY), exitZ);
    const VF tEnd = hn::Load(f, tEnd_);

    // Boxes that hold no isosurface lie on one side.
    const MF passed = hn::RebindMask(f, moves);
    const MF boxInside = hn::RebindMask(f, falling ? hn::AndNot(below, moves) : hn::And(below, moves));
    MF entered = hn::And(outside, boxInside);
    if constexpr (!any) {
      if (!hn::AllFalse(f, entered)) {
        hn::BlendedStore(t, entered, f, found_.tIn);
        hn::BlendedStore(t, entered, f, found_.tOut);
      }
    }
    outside = hn::Or(hn::AndNot(boxInside, passed), hn::AndNot(passed, outside));

    const std::size_t waiting = hn::CountTrue(i, waits);
    if (waiting > 0 && 2 * waiting >= living) {
      const MF here = hn::RebindMask(f, waits);
      entered = hn::Or(entered, testCells(here, cx, cy, cz, t, hn::Min(tOut, tEnd), outside));
      moves = hn::Or(moves, waits);
    }

    hits = hn::Or(hits, hn::RebindMask(i, entered));
    const MI ended = hn::And(moves, hn::RebindMask(i, hn::Or(entered, hn::Not(hn::Lt(tOut, tEnd)))));
    alive = hn::AndNot(ended, alive);
    moves = hn::AndNot(ended, moves);

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
    t = hn::IfThenElse(hn::RebindMask(f, moves), hn::Max(t, tOut), t);
    const VI changed = hn::Or(hn::Or(hn::Xor(newX, cx), hn::Xor(newY, cy)), hn::Xor(newZ, cz));
    fine = hn::AndNot(hn::Gt(changed, three), hn::Or(fine, holds));
    cx = newX;
    cy = newY;
    cz = newZ;
  }
}

template <bool any, class Write>
HWY_INLINE void traceAll(const View& view, const TraceRay* rays, std::size_t count, const Write& write) {
  if (view.signed16)
    Tracer<std::int16_t, any>(view, view.signed16, rays, count).run(write);
  else if (view.unsigned16)
    Tracer<std::uint16_t, any>(view, view.unsigned16, rays, count).run(write);
  else
    Tracer<float, any>(view, view.float32, rays, count).run(write);
}

void firstEntries(const View& view, const TraceRay* rays, std::size_t count, float* t) {
  traceAll<false>(view, rays, count, [t](std::size_t ray, float found) { t[ray] = found; });
}

void anyEntries(const View& view, const TraceRay* rays, std::size_t count, std::uint8_t* hit) {
  traceAll<true>(view, rays, count,
                 [hit](std::size_t ray, float found) { hit[ray] = found < kInfinity ? 1 : 0; });
}

// Gradients: one point at a time, four samples of a row at once.
using F4 = hn::FixedTag<float, 4>;
using V4 = hn::Vec<F4>;

HWY_INLINE V4 loadRow(const float* row) {
  return hn::LoadU(F4(), row);
}

template <class T>
HWY_INLINE V4 loadRow(const T* row) {
  return hn::ConvertTo(F4(),
                       hn::PromoteTo(hn::FixedTag<std::int32_t, 4>(), hn::LoadU(hn::FixedTag<T, 4>(), row)));
}

// Weights of four samples round fraction t, and of the derivative (volume/reconstruct.h).
HWY_INLINE void splineWeights(float t, float w[4], float d[4]) {
  const float s = 1.0f - t;
  constexpr float sixth = 1.0f / 6.0f;
  w[0] = s * s * s * sixth;
  w[1] = (4.0f + t * t * (3.0f * t - 6.0f)) * sixth;
  w[2] = (4.0f + s * s * (3.0f * s - 6.0f)) * sixth;
  w[3] = t * t * t * sixth;
  d[0] = -0.5f * s * s;
  d[1] = t * (1.5f * t - 2.0f);
  d[2] = -s * (1.5f * s - 2.0f);
  d[3] = 0.5f * t * t;
}

template <class T>
HWY_INLINE void gradientsOf(const View& view, const T* voxels, const glm::vec3* points, std::size_t count,
                            glm::vec3* result) {
  const F4 f;
  const std::size_t row = static_cast<std::size_t>(view.dims.x),
                    slice = row * static_cast<std::size_t>(view.dims.y);
  const glm::vec3 last(view.dims - 2);
  const auto scalar = scalarKernels().gradients;
  for (std::size_t n = 0; n < count; ++n) {
    const glm::vec3 p = points[n];
    // All 64 samples in the volume.
    if (!(p.x >= 1.0f && p.y >= 1.0f && p.z >= 1.0f && p.x < last.x && p.y < last.y && p.z < last.z)) {
      scalar(view, &p, 1, result + n);
      continue;
    }
    const int x = static_cast<int>(p.x), y = static_cast<int>(p.y), z = static_cast<int>(p.z);
    alignas(16) float wx[4], dx[4], wy[4], dy[4], wz[4], dz[4];
    splineWeights(p.x - static_cast<float>(x), wx, dx);
    splineWeights(p.y - static_cast<float>(y), wy, dy);
    splineWeights(p.z - static_cast<float>(z), wz, dz);
    const T* corner = voxels + static_cast<std::size_t>(z - 1) * slice +
                      static_cast<std::size_t>(y - 1) * row + static_cast<std::size_t>(x - 1);
    // Sums over y and z, with the derivative along neither, y and z.
    V4 alongX = hn::Zero(f), alongY = alongX, alongZ = alongX;
    for (int k = 0; k < 4; ++k, corner += slice) {
      V4 s = hn::Mul(hn::Set(f, wy[0]), loadRow(corner)), sy = hn::Mul(hn::Set(f, dy[0]), loadRow(corner));
      for (std::size_t j = 1; j < 4; ++j) {
        const V4 samples = loadRow(corner + j * row);
        s = hn::MulAdd(hn::Set(f, wy[j]), samples, s);
        sy = hn::MulAdd(hn::Set(f, dy[j]), samples, sy);
      }
      alongX = hn::MulAdd(hn::Set(f, wz[k]), s, alongX);
      alongY = hn::MulAdd(hn::Set(f, wz[k]), sy, alongY);
      alongZ = hn::MulAdd(hn::Set(f, dz[k]), s, alongZ);
    }
    const V4 weights = hn::Load(f, wx);
    const float gx = hn::GetLane(hn::SumOfLanes(f, hn::Mul(hn::Load(f, dx), alongX)));
    const float gy = hn::GetLane(hn::SumOfLanes(f, hn::Mul(weights, alongY)));
    const float gz = hn::GetLane(hn::SumOfLanes(f, hn::Mul(weights, alongZ)));
    result[n] = {gx, gy, gz};
    if (std::is_same_v<T, float> && std::isnan(gx + gy + gz)) scalar(view, &p, 1, result + n);
  }
}

void gradients(const View& view, const glm::vec3* points, std::size_t count, glm::vec3* result) {
  if (view.signed16)
    gradientsOf(view, view.signed16, points, count, result);
  else if (view.unsigned16)
    gradientsOf(view, view.unsigned16, points, count, result);
  else
    gradientsOf(view, view.float32, points, count, result);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolux::volume::tracing {

namespace {

#define ISOLUX_KERNELS(space, target, name)                                                \
  if (wanted == (target)) {                                                                \
    static constexpr Kernels kernels{target, name, space::firstEntries, space::anyEntries, \
                                     space::gradients};                                    \
    return &kernels;                                                                       \
  }

const Kernels* compiledKernels(TracerTarget wanted) {
#if HWY_TARGETS & HWY_SSE4
  ISOLUX_KERNELS(N_SSE4, TracerTarget::sse4, "SSE4")
#endif
#if HWY_TARGETS & HWY_AVX2
  ISOLUX_KERNELS(N_AVX2, TracerTarget::avx2, "AVX2")
#endif
#if HWY_TARGETS & HWY_AVX3
  ISOLUX_KERNELS(N_AVX3, TracerTarget::avx512, "AVX-512")
#endif
#if HWY_TARGETS & HWY_NEON
  ISOLUX_KERNELS(N_NEON, TracerTarget::neon, "NEON")
#endif
  (void)wanted;
  return nullptr;
}
#undef ISOLUX_KERNELS

std::int64_t highwayTarget(TracerTarget target) {
  switch (target) {
    case TracerTarget::sse4:
      return HWY_SSE4;
    case TracerTarget::avx2:
      return HWY_AVX2;
    case TracerTarget::avx512:
      return HWY_AVX3;
    case TracerTarget::neon:
      return HWY_NEON;
    default:
      return 0;
  }
}

}  // namespace

const Kernels* simdKernels(TracerTarget target) {
  return (hwy::SupportedTargets() & highwayTarget(target)) != 0 ? compiledKernels(target) : nullptr;
}

}  // namespace isolux::volume::tracing
#endif
