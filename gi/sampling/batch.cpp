// Compiled for every instruction set and chosen at run time (Highway).
#include "gi/sampling/batch.h"

#include <cmath>
#include <numbers>

#include "gi/sampling/guide_table.h"

#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "gi/sampling/batch.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolux::gi {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using F = hn::ScalableTag<float>;
using I = hn::ScalableTag<std::int32_t>;
using VF = hn::Vec<F>;
using VI = hn::Vec<I>;
using MF = hn::Mask<F>;
using MI = hn::Mask<I>;

HWY_INLINE VF number(float value) {
  return hn::Set(F(), value);
}
HWY_INLINE VI whole(std::int32_t value) {
  return hn::Set(I(), value);
}
HWY_INLINE VF load(const BatchFloats& list, std::size_t i) {
  return hn::Load(F(), list.v + i);
}
HWY_INLINE VI load(const BatchWords& list, std::size_t i) {
  return hn::Load(I(), reinterpret_cast<const std::int32_t*>(list.v) + i);
}
HWY_INLINE void store(VF values, BatchFloats& list, std::size_t i) {
  hn::Store(values, F(), list.v + i);
}
HWY_INLINE void store(VI values, BatchWords& list, std::size_t i) {
  hn::Store(values, I(), reinterpret_cast<std::int32_t*>(list.v) + i);
}
HWY_INLINE VI gather(const std::uint32_t* table, VI index) {
  return hn::GatherIndex(I(), reinterpret_cast<const std::int32_t*>(table), index);
}
HWY_INLINE VF gather(const float* table, VI index) {
  return hn::GatherIndex(F(), table, index);
}

// 2^31 has no int32: it is the least of them.
constexpr std::int32_t kCertain = INT32_MIN;
HWY_INLINE VF floatOf(VI count) {
  return hn::IfThenElse(hn::RebindMask(F(), hn::Lt(count, hn::Zero(I()))), number(0x1p31f),
                        hn::ConvertTo(F(), count));
}
HWY_INLINE VI probabilityOf(VF u) {
  return hn::ConvertTo(I(), hn::Min(hn::Mul(u, number(0x1p31f)), number(0x1p31f - 128.0f)));
}

// Sines and cosines of angles of at most pi / 4 (directions.h).
HWY_INLINE void sineCosine(VF angle, VF& sine, VF& cosine) {
  const VF a2 = hn::Mul(angle, angle), one = number(1.0f);
  const auto next = [&](VF sum, float term) { return hn::Add(number(term), hn::Mul(a2, sum)); };
  VF s = next(number(1.0f / 362880), -1.0f / 5040);
  s = next(next(s, 1.0f / 120), -1.0f / 6);
  sine = hn::Mul(angle, hn::Add(one, hn::Mul(a2, s)));
  VF c = next(number(1.0f / 40320), -1.0f / 720);
  c = next(next(c, 1.0f / 24), -0.5f);
  cosine = hn::Add(one, hn::Mul(a2, c));
}

// Of `turn` times a full turn, in [-1/2, 1/2] (sineCosineOfTurn()).
HWY_INLINE void sineCosineOfTurns(VF turn, VF& sine, VF& cosine) {
  const I i;
  const VI quarter = hn::Sub(hn::ConvertTo(i, hn::Add(hn::Mul(number(4.0f), turn), number(2.5f))), whole(2));
  const VF rest = hn::Sub(turn, hn::Mul(number(0.25f), hn::ConvertTo(F(), quarter)));
  VF s, c;
  sineCosine(hn::Mul(number(6.28318531f), rest), s, c);
  const auto bit = [&](VI value, int mask) {
    return hn::RebindMask(F(), hn::Gt(hn::And(value, whole(mask)), hn::Zero(i)));
  };
  const MF swap = bit(quarter, 1);
  sine = hn::IfThenElse(swap, c, s);
  cosine = hn::IfThenElse(swap, s, c);
  sine = hn::IfThenElse(bit(quarter, 2), hn::Neg(sine), sine);
  cosine = hn::IfThenElse(bit(hn::Add(quarter, whole(1)), 2), hn::Neg(cosine), cosine);
}

// The intervals that hold numbers (intervalOf()): from `first` to `last`, of `starts` that begin at `base`.
struct Interval {
  VI index, start, count;
};
HWY_INLINE Interval search(const std::uint32_t* starts, VI base, std::int32_t intervals, VI first, VI last,
                           VI value) {
  const I i;
  const VI one = whole(1), final = whole(intervals - 1);
  for (MI open = hn::Gt(last, first); !hn::AllFalse(i, open); open = hn::Gt(last, first)) {
    const VI middle = hn::ShiftRight<1>(hn::Add(hn::Add(first, last), one));
    const VI start = gather(starts, hn::Add(base, middle));
    // A start of 2^31 is behind every number.
    const MI behind = hn::Or(hn::Gt(start, value), hn::Lt(start, hn::Zero(i)));
    first = hn::IfThenElse(hn::AndNot(behind, open), middle, first);
    last = hn::IfThenElse(hn::And(behind, open), hn::Sub(middle, one), last);
  }
  const VI start = gather(starts, hn::Add(base, first));
  const VI behind = gather(starts, hn::Add(base, hn::Min(hn::Add(first, one), final)));
  const VI end = hn::IfThenElse(hn::Gt(final, first), behind, whole(kCertain));
  return {first, start, hn::Sub(end, start)};
}
HWY_INLINE VF fractionOf(const Interval& found, VI value) {
  const VF within = hn::ConvertTo(F(), hn::Sub(value, found.start));
  return hn::Div(hn::Add(within, number(0.5f)), floatOf(found.count));
}

template <class T>
HWY_INLINE void prefetchAll(const T* table, VI index, std::size_t stride) {
  alignas(64) std::int32_t at[hn::MaxLanes(I())];
  hn::Store(index, I(), at);
  for (std::size_t lane = 0; lane < hn::Lanes(I()); ++lane)
    hwy::Prefetch(table + stride * static_cast<std::size_t>(at[lane]));
}

// In three stages, each of which asks memory for what the next one reads.
void sampleAll(const EnvironmentTables& tables, const BatchPairs& u, std::size_t count,
               EnvironmentBatch& samples) {
  const I i;
  const std::size_t lanes = hn::Lanes(i);
  const VI width = whole(tables.width), height = whole(tables.height), one = whole(1), zero = hn::Zero(i);
  const int rowBits = guideBits(static_cast<std::size_t>(tables.height)),
            columnBits = guideBits(static_cast<std::size_t>(tables.width));
  const VI columnGuide = whole(static_cast<std::int32_t>(guideSize(static_cast<std::size_t>(tables.width))));
  BatchWords rows, rowCounts, guides, firsts, lasts;
  BatchFloats fractions;
  for (std::size_t k = 0; k < count; k += lanes) {
    const VI value = probabilityOf(load(u.y, k));
    const VI cell = hn::ShiftRightSame(value, 31 - rowBits);
    const Interval row = search(tables.rowStart, zero, tables.height, gather(tables.rowGuide, cell),
                                gather(tables.rowGuide, hn::Add(cell, one)), value);
    const VI inRow = hn::ShiftRightSame(probabilityOf(load(u.x, k)), 31 - columnBits);
    const VI guide = hn::Add(hn::Mul(row.index, columnGuide), inRow);
    prefetchAll(tables.columnGuide, guide, 1);
    store(row.index, rows, k);
    store(row.count, rowCounts, k);
    store(fractionOf(row, value), fractions, k);
    store(guide, guides, k);
  }
  for (std::size_t k = 0; k < count; k += lanes) {
    const VI guide = load(guides, k), base = hn::Mul(load(rows, k), width);
    const VI first = gather(tables.columnGuide, guide),
             last = gather(tables.columnGuide, hn::Add(guide, one));
    prefetchAll(tables.columnStart, hn::Add(base, hn::ShiftRight<1>(hn::Add(hn::Add(first, last), one))), 1);
    store(first, firsts, k);
    store(last, lasts, k);
  }
  for (std::size_t k = 0; k < count; k += lanes) {
    const VI row = load(rows, k), base = hn::Mul(row, width);
    const VI value = probabilityOf(load(u.x, k));
    const Interval column =
        search(tables.columnStart, base, tables.width, load(firsts, k), load(lasts, k), value);
    const VI pixel = hn::Add(base, column.index);
    prefetchAll(tables.pixels, pixel, 3);
    store(pixel, samples.pixel, k);

    // 1 - cos of the angle from the nearer pole, over 2, is even within the row.
    const MI lower = hn::Not(hn::Gt(height, hn::Add(row, row)));
    const VI above = hn::IfThenElse(lower, hn::Sub(height, row), row);
    const VI below = hn::IfThenElse(lower, hn::Sub(above, one), hn::Add(above, one));
    const VF top = gather(tables.sineSquaredHalf, above), bottom = gather(tables.sineSquaredHalf, below);
    const VF half = hn::Add(top, hn::Mul(load(fractions, k), hn::Sub(bottom, top)));
    const VF unit = number(1.0f), two = number(2.0f);
    const VF sine = hn::Mul(two, hn::Sqrt(hn::Mul(half, hn::Max(hn::Zero(F()), hn::Sub(unit, half)))));
    const VF twice = hn::Mul(two, half);
    store(hn::IfThenElse(hn::RebindMask(F(), lower), hn::Sub(twice, unit), hn::Sub(unit, twice)),
          samples.direction.z, k);
    const VF at = hn::Add(hn::ConvertTo(F(), column.index), fractionOf(column, value));
    VF sineOfTurn, cosineOfTurn;
    sineCosineOfTurns(hn::Sub(hn::Div(at, hn::ConvertTo(F(), width)), number(0.5f)), sineOfTurn,
                      cosineOfTurn);
    store(hn::Mul(sine, sineOfTurn), samples.direction.x, k);
    store(hn::Mul(sine, cosineOfTurn), samples.direction.y, k);
    store(
        hn::Mul(hn::Mul(floatOf(load(rowCounts, k)), floatOf(column.count)), gather(tables.rowDensity, row)),
        samples.pdf, k);
  }
}

// angleOf() of environment.cpp.
HWY_INLINE VF anglesOf(VF y, VF x) {
  const F f;
  const VF zero = hn::Zero(f), ax = hn::Abs(x), ay = hn::Abs(y);
  const VF low = hn::Min(ax, ay), high = hn::Max(ax, ay);
  const MF past = hn::Gt(low, hn::Mul(number(0.414213562f), high));
  const VF above = hn::IfThenElse(past, hn::Sub(low, high), low);
  const VF below = hn::IfThenElse(past, hn::Add(low, high), high);
  const VF t = hn::IfThenElse(hn::Gt(below, zero), hn::Div(above, below), zero);
  const VF t2 = hn::Mul(t, t);
  VF sum = hn::Sub(hn::Mul(number(8.05374449538e-2f), t2), number(1.38776856032e-1f));
  sum = hn::Add(hn::Mul(sum, t2), number(1.99777106478e-1f));
  sum = hn::Sub(hn::Mul(sum, t2), number(3.33329491539e-1f));
  VF angle = hn::Add(hn::Mul(hn::Mul(sum, t2), t), t);
  angle = hn::IfThenElse(past, hn::Add(angle, number(0.785398163f)), angle);
  angle = hn::IfThenElse(hn::Gt(ay, ax), hn::Sub(number(1.57079633f), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(number(3.14159265f), angle), angle);
  return hn::CopySign(angle, y);
}

void lookUpAll(const EnvironmentTables& tables, std::size_t count, EnvironmentBatch& samples) {
  const I i;
  const std::size_t lanes = hn::Lanes(i);
  const VI width = whole(tables.width), height = whole(tables.height), one = whole(1), zero = hn::Zero(i);
  const VI lastRow = whole(tables.height - 1), lastColumn = whole(tables.width - 1);
  const VF inversePi = number(std::numbers::inv_pi_v<float>);
  BatchWords rows, columns;
  for (std::size_t k = 0; k < count; k += lanes) {
    const VF x = load(samples.direction.x, k), y = load(samples.direction.y, k),
             z = load(samples.direction.z, k);
    const VF across = hn::Sqrt(hn::Add(hn::Mul(x, x), hn::Mul(y, y)));
    const VF polar = hn::Mul(anglesOf(across, z), inversePi);
    const VF turn = hn::Add(hn::Mul(anglesOf(x, y), hn::Mul(number(0.5f), inversePi)), number(0.5f));
    const auto cellOf = [&](VF part, VI cells, VI last) {
      return hn::Min(hn::Max(hn::ConvertTo(i, hn::Mul(part, hn::ConvertTo(F(), cells))), zero), last);
    };
    const VI row = cellOf(polar, height, lastRow), column = cellOf(turn, width, lastColumn);
    const VI pixel = hn::Add(hn::Mul(row, width), column);
    prefetchAll(tables.columnStart, pixel, 1);
    prefetchAll(tables.pixels, pixel, 3);
    store(row, rows, k);
    store(column, columns, k);
    store(pixel, samples.pixel, k);
  }
  const auto lengthOf = [&](const std::uint32_t* starts, VI at, MI isLast) {
    const VI end =
        hn::IfThenElse(isLast, whole(kCertain), gather(starts, hn::IfThenElse(isLast, at, hn::Add(at, one))));
    return floatOf(hn::Sub(end, gather(starts, at)));
  };
  for (std::size_t k = 0; k < count; k += lanes) {
    const VI row = load(rows, k);
    const VF ofRow = lengthOf(tables.rowStart, row, hn::Eq(row, lastRow));
    const VF ofColumn =
        lengthOf(tables.columnStart, load(samples.pixel, k), hn::Eq(load(columns, k), lastColumn));
    store(hn::Mul(hn::Mul(ofRow, ofColumn), gather(tables.rowDensity, row)), samples.pdf, k);
  }
}

void cosineAll(const BatchPairs& u, const BatchVectors& normals, std::size_t count, BatchVectors& directions,
               BatchFloats& cosines) {
  const F f;
  const VF zero = hn::Zero(f), one = number(1.0f), two = number(2.0f);
  for (std::size_t k = 0; k < count; k += hn::Lanes(f)) {
    // concentricDisk()
    const VF x = hn::Sub(hn::Mul(two, load(u.x, k)), one), y = hn::Sub(hn::Mul(two, load(u.y, k)), one);
    const MF wide = hn::Gt(hn::Abs(x), hn::Abs(y));
    const VF radius = hn::IfThenElse(wide, x, y);
    const VF ratio = hn::IfThenElse(hn::Eq(radius, zero), zero, hn::Div(hn::IfThenElse(wide, y, x), radius));
    VF sine, cosine;
    sineCosine(hn::Mul(number(0.785398163f), ratio), sine, cosine);
    const VF diskX = hn::Mul(radius, hn::IfThenElse(wide, cosine, sine));
    const VF diskY = hn::Mul(radius, hn::IfThenElse(wide, sine, cosine));
    // cosineHemisphere()
    const VF square = hn::Add(hn::Mul(diskX, diskX), hn::Mul(diskY, diskY));
    const VF up = hn::Sqrt(hn::Max(zero, hn::Sub(one, square)));
    // Frame::about(normal).toWorld()
    const VF nx = load(normals.x, k), ny = load(normals.y, k), nz = load(normals.z, k);
    const VF sign = hn::CopySign(one, nz);
    const VF a = hn::Div(number(-1.0f), hn::Add(sign, nz));
    const VF b = hn::Mul(hn::Mul(nx, ny), a);
    const VF tx = hn::Add(one, hn::Mul(hn::Mul(hn::Mul(sign, nx), nx), a)), ty = hn::Mul(sign, b),
             tz = hn::Mul(hn::Neg(sign), nx);
    const VF by = hn::Add(sign, hn::Mul(hn::Mul(ny, ny), a)), bz = hn::Neg(ny);
    const auto along = [&](VF t, VF bi, VF n) {
      return hn::Add(hn::Add(hn::Mul(diskX, t), hn::Mul(diskY, bi)), hn::Mul(up, n));
    };
    store(along(tx, b, nx), directions.x, k);
    store(along(ty, by, ny), directions.y, k);
    store(along(tz, bz, nz), directions.z, k);
    store(up, cosines, k);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isolux::gi
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolux::gi {

HWY_EXPORT(sampleAll);
HWY_EXPORT(lookUpAll);
HWY_EXPORT(cosineAll);

void sampleBatch(const EnvironmentTables& tables, const BatchPairs& u, std::size_t count,
                 EnvironmentBatch& samples) {
  HWY_DYNAMIC_DISPATCH(sampleAll)(tables, u, count, samples);
}

void lookUpBatch(const EnvironmentTables& tables, std::size_t count, EnvironmentBatch& samples) {
  HWY_DYNAMIC_DISPATCH(lookUpAll)(tables, count, samples);
}

void cosineBatch(const BatchPairs& u, const BatchVectors& normals, std::size_t count,
                 BatchVectors& directions, BatchFloats& cosines) {
  HWY_DYNAMIC_DISPATCH(cosineAll)(u, normals, count, directions, cosines);
}

}  // namespace isolux::gi
#endif
