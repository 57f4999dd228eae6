// Rays made ready, as many at once as there are lanes: prepare() of kernels.h in vectors, in the same
// arithmetic, so that every ray is the same bit for bit. Included once per instruction set by
// simd_kernels-inl.h.
#if defined(ISOLUX_VOLUME_TRACER_STOCK_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_TRACER_STOCK_INL_H
#undef ISOLUX_VOLUME_TRACER_STOCK_INL_H
#else
#define ISOLUX_VOLUME_TRACER_STOCK_INL_H
#endif

#include <array>
#include <bit>
#include <cstring>

#include "volume/tracer/kernels.h"
#include "volume/tracer/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// How many of the lower bits are set, in byte i of bit i, for all bytes.
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

// Of every lane: how many lanes before it are set.
HWY_INLINE VI ranksOf(std::uint32_t bits) {
  alignas(16) std::uint64_t ranks[2] = {kRanks[bits & 255], 0};
  const auto before = static_cast<std::uint64_t>(std::popcount(bits & 255));
  ranks[1] = kRanks[bits >> 8 & 255] + before * 0x0101010101010101u;
  alignas(16) std::uint8_t bytes[16];
  std::memcpy(bytes, ranks, 16);
  return hn::PromoteTo(I(), hn::Load(hn::Rebind<std::uint8_t, I>(), bytes));
}

// The bins of isovalues: the expression of ValueBins, in double precision.
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

  // Gives the lanes of `idle` rays as far as there are any; those that have got one. missed(ray): of rays
  // that meet nothing.
  template <class Missed>
  HWY_INLINE MI give(Group& g, std::uint32_t idle, const Missed& missed);

 private:
  static constexpr std::size_t kRays = 64;

  template <class Missed>
  HWY_INLINE void fill(const Missed& missed);
  template <class Missed>
  HWY_INLINE void prepareVector(const Missed& missed);
  template <class Missed>
  void prepareScalar(std::size_t count, const Missed& missed);
  // Calls each(of the stock, of the group) for all arrays.
  template <class Each>
  HWY_INLINE void forEachArray(Group& g, const Each& each);

  const View& view_;
  const TraceRay* rays_;
  std::size_t count_, next_ = 0;
  std::size_t begin_ = 0, end_ = 0;  // of what is ready
  struct Ready {
    alignas(64) float origin[3][kRays], direction[3][kRays], inverse[3][kRays];
    alignas(64) float tEnd[kRays], isovalue[kRays], scale[kRays], tBegin[kRays];
    alignas(64) std::int32_t bin[kRays], start[3][kRays], ray[kRays];
  } ready_;
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
    while (next_ < count_ && end_ + kLanes <= kRays - kLanes) prepareVector(missed);
  }
  const std::size_t given = std::min(wanted, end_ - begin_);
  const VI rank = ranksOf(idle);
  alignas(64) std::int32_t lanes[kLanes];
  for (std::size_t lane = 0; lane < kLanes; ++lane) lanes[lane] = static_cast<std::int32_t>(idle >> lane & 1);
  const MI taking = hn::And(hn::Gt(hn::Load(i, lanes), hn::Zero(i)),
                            hn::Gt(hn::Set(i, static_cast<std::int32_t>(given)), rank));
  if constexpr (kLanes < 8) {  // one ray at a time is quicker
    std::uint32_t lanesLeft = idle;
    for (std::size_t k = begin_; k < begin_ + given; ++k, lanesLeft &= lanesLeft - 1) {
      const int lane = std::countr_zero(lanesLeft);
      forEachArray(g, [&](const auto& array, auto& lanesOfGroup) { lanesOfGroup[lane] = array[k]; });
    }
  } else {
    const VI within = hn::And(rank, hn::Set(i, static_cast<std::int32_t>(kLanes - 1)));
    const auto places = hn::IndicesFromVec(i, within);
    const auto placesOfFloats = hn::IndicesFromVec(F(), within);
    forEachArray(g, [&](const auto& array, auto& lanesOfGroup) {
      if constexpr (std::is_same_v<std::decay_t<decltype(array[0])>, float>)
        hn::BlendedStore(hn::TableLookupLanes(hn::LoadU(F(), array + begin_), placesOfFloats),
                         hn::RebindMask(F(), taking), F(), lanesOfGroup);
      else
        hn::BlendedStore(hn::TableLookupLanes(hn::LoadU(i, array + begin_), places), taking, i, lanesOfGroup);
    });
  }
  begin_ += given;
  return taking;
}

template <class Missed>
void Stock::prepareScalar(std::size_t count, const Missed& missed) {
  for (std::size_t k = 0; k < count; ++k, ++next_) {
    PreparedRay ray;
    if (!prepare(view_, rays_[next_], ray)) {
      missed(next_);
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      ready_.origin[axis][end_] = ray.origin[axis];
      ready_.direction[axis][end_] = ray.direction[axis];
      ready_.inverse[axis][end_] = ray.inverse[axis];
      ready_.start[axis][end_] = ray.cell[axis];
    }
    ready_.tEnd[end_] = ray.tEnd;
    ready_.isovalue[end_] = ray.isovalue;
    ready_.scale[end_] = ray.scale;
    ready_.tBegin[end_] = ray.tBegin;
    ready_.bin[end_] = ray.bin;
    ready_.ray[end_] = static_cast<std::int32_t>(next_);
    ++end_;
  }
}

template <class Missed>
HWY_INLINE void Stock::prepareVector(const Missed& missed) {
  static_assert(sizeof(TraceRay) == 8 * sizeof(float));
  const F f;
  const I i;
  const std::size_t count = std::min(kLanes, count_ - next_);
  if (count < kLanes) {
    prepareScalar(count, missed);
    return;
  }
  const float* const base = &rays_[next_].origin.x;
  const VI stride = hn::ShiftLeft<3>(hn::Iota(i, 0));
  const auto field = [&](int at) { return hn::GatherIndex(f, base, hn::Add(stride, hn::Set(i, at))); };
  const VF zero = hn::Zero(f);
  const VF origin[3] = {field(0), field(1), field(2)}, d[3] = {field(3), field(4), field(5)};
  const VF isovalue = field(6), tMaximum = field(7);
  VF last[3];
  for (int axis = 0; axis < 3; ++axis) last[axis] = hn::Set(f, static_cast<float>(view_.dims[axis] - 1));
  const VF greatest = hn::Max(hn::Max(hn::Abs(d[0]), hn::Abs(d[1])), hn::Abs(d[2]));
  VF sum = hn::Sub(isovalue, isovalue);
  MF within = hn::Eq(zero, zero);
  for (int axis = 0; axis < 3; ++axis) {
    sum = hn::Add(sum, hn::Add(hn::Sub(d[axis], d[axis]), hn::Sub(origin[axis], origin[axis])));
    within = hn::And(within, hn::And(hn::Ge(origin[axis], zero), hn::Le(origin[axis], last[axis])));
  }
  // Those that begin outside want double precision; those that are no rays are sorted out there, too.
  const MF good =
      hn::And(hn::And(within, hn::Eq(sum, zero)), hn::And(hn::Gt(greatest, zero), hn::Gt(tMaximum, zero)));
  if (!hn::AllTrue(f, good)) {
    prepareScalar(kLanes, missed);
    return;
  }
  const VI exponent = hn::BitCast(i, hn::ShiftRight<23>(hn::BitCast(U(), greatest)));
  const VI inverseExponent =
      hn::IfThenElse(hn::Gt(exponent, hn::Set(i, 252)), hn::Set(i, 1), hn::Sub(hn::Set(i, 254), exponent));
  const VF shrink = hn::BitCast(f, hn::ShiftLeft<23>(inverseExponent));
  const VF one = hn::Set(f, 1.0f), creep = hn::Set(f, kCreep);
  VF tEnd = hn::Div(tMaximum, shrink);
  VF along[3], inverse[3];
  for (int axis = 0; axis < 3; ++axis) {
    const VF scaled = hn::Mul(d[axis], shrink);
    const VF creeping = hn::IfThenElse(hn::Ge(origin[axis], last[axis]), hn::Neg(creep), creep);
    along[axis] = hn::IfThenElse(hn::Lt(hn::Abs(scaled), creep), creeping, scaled);
    inverse[axis] = hn::Div(one, along[axis]);
    const VF border = hn::IfThenElseZero(hn::Gt(along[axis], zero), last[axis]);
    const VF leaves = hn::Mul(hn::Sub(border, origin[axis]), inverse[axis]);
    tEnd = hn::IfThenElse(hn::Lt(leaves, tEnd), leaves, tEnd);
  }
  const MF meets = hn::Gt(tEnd, zero);
  const MI meetsToo = hn::RebindMask(i, meets);
  const bool all = hn::AllTrue(f, meets);
  const auto keep = [&](VF values, float* array) {
    all ? hn::StoreU(values, f, array + end_)
        : static_cast<void>(hn::CompressBlendedStore(values, meets, f, array + end_));
  };
  const auto keepWhole = [&](VI values, std::int32_t* array) {
    all ? hn::StoreU(values, i, array + end_)
        : static_cast<void>(hn::CompressBlendedStore(values, meetsToo, i, array + end_));
  };
  for (int axis = 0; axis < 3; ++axis) {
    keep(origin[axis], ready_.origin[axis]);
    keep(along[axis], ready_.direction[axis]);
    keep(inverse[axis], ready_.inverse[axis]);
    keepWhole(hn::Min(hn::ConvertTo(i, origin[axis]), hn::Set(i, view_.dims[axis] - 2)), ready_.start[axis]);
  }
  keep(tEnd, ready_.tEnd);
  keep(isovalue, ready_.isovalue);
  keep(shrink, ready_.scale);
  keep(zero, ready_.tBegin);
  keepWhole(binsOf(view_.ranges->bins(), isovalue), ready_.bin);
  keepWhole(hn::Add(hn::Iota(i, 0), hn::Set(i, static_cast<std::int32_t>(next_))), ready_.ray);
  if (!all)
    for (std::uint32_t missing = ~bitsOf(meetsToo) & ((1u << kLanes) - 1); missing != 0;
         missing &= missing - 1)
      missed(next_ + static_cast<std::size_t>(std::countr_zero(missing)));
  end_ += all ? kLanes : hn::CountTrue(f, meets);
  next_ += kLanes;
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
