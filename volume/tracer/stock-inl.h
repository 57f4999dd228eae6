// Prepares rays, as many at once as there are lanes, and gives them to groups. Included once per instruction
// set by simd_kernels-inl.h.
#if defined(ISOLUX_VOLUME_TRACER_STOCK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_TRACER_STOCK_INL_H
#undef ISOLUX_VOLUME_TRACER_STOCK_INL_H
#else
#define ISOLUX_VOLUME_TRACER_STOCK_INL_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "volume/tracer/group-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// For all bytes, in byte i: how many of the bits below bit i are set.
constexpr std::array<std::uint64_t, 256> kRanks = [] {
  std::array<std::uint64_t, 256> ranks{};
  for (std::size_t bits = 0; bits < 256; ++bits) {
    std::uint64_t rank = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      ranks[bits] |= rank << (8 * i);
      rank += bits >> i & 1;
    }
  }
  return ranks;
}();

// Returns for every lane how many lanes before it are set.
HWY_INLINE VI ranksOf(std::uint32_t bits) {
  alignas(16) std::uint64_t ranks[2] = {kRanks[bits & 255], 0};
  const auto before = static_cast<std::uint64_t>(std::popcount(bits & 255));
  ranks[1] = kRanks[bits >> 8 & 255] + before * 0x0101010101010101u;
  alignas(16) std::uint8_t bytes[16];
  std::memcpy(bytes, ranks, 16);
  return hn::PromoteTo(I(), hn::Load(hn::Rebind<std::uint8_t, I>(), bytes));
}

// Returns the bins of isovalues.
HWY_INLINE VI binsOf(const ValueBins& bins, VF isovalues) {
  alignas(64) float values[kLanes];
  alignas(64) std::int32_t found[kLanes];
  hn::Store(isovalues, F(), values);
  for (std::size_t lane = 0; lane < kLanes; ++lane) found[lane] = bins(values[lane]);
  return hn::Load(I(), found);
}

class Stock {
 public:
  Stock(const View& view, const TraceRay* rays, std::size_t count)
      : view_(view), rays_(rays), count_(count) {}

  bool exhausted() const { return begin_ == end_ && next_ == count_; }

  // Gives the lanes in `idle` rays as far as there are any, and returns those that got one. Calls missed(ray)
  // for rays that meet nothing.
  template <class Missed>
  HWY_INLINE MI give(Group& g, std::uint32_t idle, const Missed& missed);

 private:
  static constexpr std::size_t kRays = 64;

  // TraceRay of each lane.
  struct Fields {
    VF origin[3], direction[3], isovalue, tMaximum;
    HWY_INLINE VF greatest() const {
      return hn::Max(hn::Max(hn::Abs(direction[0]), hn::Abs(direction[1])), hn::Abs(direction[2]));
    }
  };
  static HWY_INLINE Fields fieldsOf(const TraceRay* rays);
  HWY_INLINE bool allBeginWithin(const Fields& rays) const;
  HWY_INLINE VF last(int axis) const { return hn::Set(F(), static_cast<float>(view_.dims[axis] - 1)); }
  template <class Missed>
  HWY_INLINE void prepare(const Missed& missed);
  template <class Missed>
  HWY_NOINLINE void prepareOneByOne(const Missed& missed);
  template <class Missed>
  HWY_INLINE void scale(const Fields& rays, VF tBegin, std::size_t count, const Missed& missed);
  // Calls each(of the stock, of the group) for all arrays.
  template <class Each>
  HWY_INLINE void forEachArray(Group& g, const Each& each);

  const View& view_;
  const TraceRay* rays_;
  std::size_t count_, next_ = 0;
  std::size_t begin_ = 0, end_ = 0;  // of what is ready
  PreparedRays<kRays> ready_;
};

template <class Each>
HWY_INLINE void Stock::forEachArray(Group& g, const Each& each) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    each(ready_.origin[axis], g.origin[axis]);
    each(ready_.direction[axis], g.direction[axis]);
    each(ready_.inverse[axis], g.inverse[axis]);
    each(ready_.start[axis], g.start[axis]);
  }
  each(ready_.tEnd, g.tEnd);
  each(ready_.isovalue, g.isovalue);
  each(ready_.scale, g.scale);
  each(ready_.tBegin, g.tBegin);
  each(ready_.bin, g.bin);
  each(ready_.ray, g.ray);
}

template <class Missed>
HWY_INLINE MI Stock::give(Group& g, std::uint32_t idle, const Missed& missed) {
  const I i;
  const auto wanted = static_cast<std::size_t>(std::popcount(idle));
  if (end_ - begin_ < wanted && next_ < count_) {
    forEachArray(g, [&](auto& array, auto&) {  // fewer than there are lanes
      const hn::ScalableTag<std::decay_t<decltype(array[0])>> d;
      hn::Store(hn::LoadU(d, array + begin_), d, array);
    });
    end_ -= begin_;
    begin_ = 0;
    while (next_ < count_ && end_ + kLanes <= kRays - kLanes) prepare(missed);
  }
  const std::size_t given = std::min(wanted, end_ - begin_);
  const VI rank = ranksOf(idle);
  alignas(64) std::int32_t lanes[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane] = static_cast<std::int32_t>(idle >> lane & 1);
  const MI taking = hn::And(hn::Gt(hn::Load(i, lanes), hn::Zero(i)),
                            hn::Gt(hn::Set(i, static_cast<std::int32_t>(given)), rank));
  if constexpr (kLanes < 8) {  // one ray at a time is quicker
    std::size_t next = begin_;
    forLanes(bitsOf(taking), [&](std::size_t lane) {
      forEachArray(g, [&](const auto& array, auto& lanesOfGroup) { lanesOfGroup[lane] = array[next]; });
      ++next;
    });
  } else {
    const VI within = hn::And(rank, hn::Set(i, static_cast<std::int32_t>(kLanes - 1)));
    forEachArray(g, [&](const auto& array, auto& lanesOfGroup) {
      const hn::ScalableTag<std::decay_t<decltype(array[0])>> d;
      hn::BlendedStore(hn::TableLookupLanes(hn::LoadU(d, array + begin_), hn::IndicesFromVec(d, within)),
                       hn::RebindMask(d, taking), d, lanesOfGroup);
    });
  }
  begin_ += given;
  return taking;
}

HWY_INLINE Stock::Fields Stock::fieldsOf(const TraceRay* rays) {
  static_assert(sizeof(TraceRay) == 8 * sizeof(float));
  const VI stride = hn::ShiftLeft<3>(hn::Iota(I(), 0));
  const auto field = [&](int at) {
    return hn::GatherIndex(F(), &rays->origin.x, hn::Add(stride, hn::Set(I(), at)));
  };
  return {{field(0), field(1), field(2)}, {field(3), field(4), field(5)}, field(6), field(7)};
}

HWY_INLINE bool Stock::allBeginWithin(const Fields& rays) const {
  const F f;
  const VF zero = hn::Zero(f);
  // x - x is 0 for finite numbers.
  VF sum = hn::Sub(rays.isovalue, rays.isovalue);
  MF within = hn::And(hn::Gt(rays.greatest(), zero), hn::Gt(rays.tMaximum, zero));
  for (int axis = 0; axis < 3; ++axis) {
    const VF origin = rays.origin[axis], d = rays.direction[axis];
    sum = hn::Add(sum, hn::Add(hn::Sub(d, d), hn::Sub(origin, origin)));
    within = hn::And(within, hn::And(hn::Ge(origin, zero), hn::Le(origin, last(axis))));
  }
  return hn::AllTrue(f, hn::And(within, hn::Eq(sum, zero)));
}

template <class Missed>
HWY_INLINE void Stock::prepare(const Missed& missed) {
  if (count_ - next_ >= kLanes) {
    const Fields rays = fieldsOf(rays_ + next_);
    if (allBeginWithin(rays)) {
      scale(rays, hn::Zero(F()), kLanes, missed);
      return;
    }
  }
  prepareOneByOne(missed);
}

template <class Missed>
HWY_NOINLINE void Stock::prepareOneByOne(const Missed& missed) {
  const std::size_t count = std::min(kLanes, count_ - next_);
  TraceRay moved[kLanes];
  alignas(64) float begins[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    moved[lane] = lane < count ? rays_[next_ + lane] : TraceRay{};
    begins[lane] = enterVolume(view_, moved[lane]);
  }
  scale(fieldsOf(moved), hn::Load(F(), begins), count, missed);
}

template <class Missed>
HWY_INLINE void Stock::scale(const Fields& rays, VF tBegin, std::size_t count, const Missed& missed) {
  const F f;
  const I i;
  const VF zero = hn::Zero(f);
  // 2^-e, exact but for directions so long or short that float has no such power.
  const VI exponent = hn::BitCast(i, hn::ShiftRight<23>(hn::BitCast(U(), rays.greatest())));
  const VI inverseExponent =
      hn::IfThenElse(hn::Gt(exponent, hn::Set(i, 252)), hn::Set(i, 1), hn::Sub(hn::Set(i, 254), exponent));
  const VF shrink = hn::BitCast(f, hn::ShiftLeft<23>(inverseExponent));
  const VF one = hn::Set(f, 1.0f), creep = hn::Set(f, 1e-30f);
  VF tEnd = hn::Div(hn::Sub(rays.tMaximum, tBegin), shrink);
  VF along[3], inverse[3];
  for (int axis = 0; axis < 3; ++axis) {
    const VF origin = rays.origin[axis], scaled = hn::Mul(rays.direction[axis], shrink);
    const VF creeping = hn::IfThenElse(hn::Ge(origin, last(axis)), hn::Neg(creep), creep);
    along[axis] = hn::IfThenElse(hn::Lt(hn::Abs(scaled), creep), creeping, scaled);
    inverse[axis] = hn::Div(one, along[axis]);
    const VF border = hn::IfThenElseZero(hn::Gt(along[axis], zero), last(axis));
    const VF leaves = hn::Mul(hn::Sub(border, origin), inverse[axis]);
    tEnd = hn::IfThenElse(hn::Lt(leaves, tEnd), leaves, tEnd);
  }
  const MF meets = hn::Gt(tEnd, zero);
  const bool all = hn::AllTrue(f, meets);
  const auto keep = [&](auto values, auto* array) {
    const hn::ScalableTag<std::decay_t<decltype(*array)>> d;
    all ? hn::StoreU(values, d, array + end_)
        : static_cast<void>(hn::CompressBlendedStore(values, hn::RebindMask(d, meets), d, array + end_));
  };
  for (int axis = 0; axis < 3; ++axis) {
    keep(rays.origin[axis], ready_.origin[axis]);
    keep(along[axis], ready_.direction[axis]);
    keep(inverse[axis], ready_.inverse[axis]);
    keep(hn::Min(hn::ConvertTo(i, rays.origin[axis]), hn::Set(i, view_.dims[axis] - 2)), ready_.start[axis]);
  }
  keep(tEnd, ready_.tEnd);
  keep(rays.isovalue, ready_.isovalue);
  keep(shrink, ready_.scale);
  keep(tBegin, ready_.tBegin);
  keep(binsOf(view_.ranges->bins(), rays.isovalue), ready_.bin);
  keep(hn::Add(hn::Iota(i, 0), hn::Set(i, static_cast<std::int32_t>(next_))), ready_.ray);
  const std::uint32_t missing = ~bitsOf(hn::RebindMask(i, meets)) & ((1u << count) - 1);
  forLanes(missing, [&](std::size_t lane) { missed(next_ + lane); });
  end_ += all ? kLanes : hn::CountTrue(f, meets);
  next_ += count;
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
