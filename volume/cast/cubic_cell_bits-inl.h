// Finds the cells of a block in which a tri-cubic B-spline can cross an isovalue, by its Bezier points: much
// closer to its values than the samples are. Included once per instruction set by simd_cast-inl.h.
//
// Axis by axis, the least of a cell's four Bezier points is taken of what is least along the axes before, and
// the most of what is most: weights are positive, so that these are bounds; where the field is linear, its
// range.
#if defined(ISOLUX_VOLUME_CAST_CUBIC_CELL_BITS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_CUBIC_CELL_BITS_INL_H
#undef ISOLUX_VOLUME_CAST_CUBIC_CELL_BITS_INL_H
#else
#define ISOLUX_VOLUME_CAST_CUBIC_CELL_BITS_INL_H
#endif

#include <algorithm>
#include <limits>
#include <type_traits>

#include "volume/cast/cell_bits_on_demand.h"
#include "volume/cast/ray_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

struct RangeLanes {
  VF least, most;
};

// Of the Bezier points between samples 1 and 2 of four. Uniform cubic B-spline, Farin 2002, 8.
HWY_INLINE RangeLanes bezierRange(VF s0, VF s1, VF s2, VF s3) {
  const F f;
  const VF third = hn::Set(f, 1.0f / 3.0f), half = hn::Set(f, 0.5f);
  const auto inThirds = [&](VF a, VF b) { return hn::Mul(third, hn::Add(hn::Add(a, a), b)); };
  const VF near = inThirds(s1, s2), far = inThirds(s2, s1);
  const VF first = hn::Mul(half, hn::Add(near, inThirds(s1, s0)));
  const VF last = hn::Mul(half, hn::Add(far, inThirds(s2, s3)));
  return {hn::Min(hn::Min(first, last), hn::Min(near, far)),
          hn::Max(hn::Max(first, last), hn::Max(near, far))};
}

// The samples that a block's 8^3 cells look up, less the first isovalue, scaled; then bounds.
class CubicBlock {
 public:
  static constexpr int kCells = 8, kSamples = kCells + 3, kStride = 16;  // floats between rows

  template <class T>
  void load(const CastView& view, const T* samples, glm::ivec3 block);
  casting::CellBitsOnDemand::Words crossed(const CastView& view);

 private:
  void boundAlongZ();
  void boundAlongY();
  float rounding() const;

  alignas(64) float samples_[kSamples][kSamples][kStride] = {};
  alignas(64) float least_[kCells][kSamples][kStride], most_[kCells][kSamples][kStride];
};

// Beyond the border samples repeat.
template <class T>
void CubicBlock::load(const CastView& view, const T* samples, glm::ivec3 block) {
  const glm::ivec3 first = kCells * block - 1, last = view.dims - 1;
  const auto clamped = [&](int at, int axis) {
    return static_cast<std::size_t>(std::min(std::max(at, 0), last[axis]));
  };
  const auto row = static_cast<std::size_t>(view.dims.x), slice = row * static_cast<std::size_t>(view.dims.y);
  const float offset = std::is_same_v<T, float> ? view.offset : 0.0f;
  const bool within = first.x >= 0 && first.x + kSamples - 1 <= last.x;
  for (int z = 0; z < kSamples; ++z)
    for (int y = 0; y < kSamples; ++y) {
      const T* line = samples + clamped(first.z + z, 2) * slice + clamped(first.y + y, 1) * row;
      T repeated[kSamples];
      if (within) {
        line += first.x;
      } else {
        for (int x = 0; x < kSamples; ++x) repeated[x] = line[clamped(first.x + x, 0)];
        line = repeated;
      }
      float* const out = samples_[z][y];
      for (int x = 0; x < kSamples; ++x)
        out[x] = ((static_cast<float>(line[x]) - offset) - view.isovalue) * view.scale;
    }
}

// What bounds, and values of the cells' own polynomials, may be off by.
inline float CubicBlock::rounding() const {
  const F f;
  VF largest = hn::Zero(f);
  for (const auto& plane : samples_)
    for (const auto& row : plane)
      for (int x = 0; x < kStride; x += static_cast<int>(kLanes)) {
        const VF size = hn::Abs(hn::Load(f, &row[x]));
        largest = hn::IfThenElse(hn::Gt(size, largest), size, largest);  // not where one is missing
      }
  return 16.0f * std::numeric_limits<float>::epsilon() * hn::GetLane(hn::MaxOfLanes(f, largest));
}

inline void CubicBlock::boundAlongZ() {
  const F f;
  for (int z = 0; z < kCells; ++z)
    for (int y = 0; y < kSamples; ++y)
      for (int x = 0; x < kStride; x += static_cast<int>(kLanes)) {
        const auto at = [&](int k) { return hn::Load(f, &samples_[z + k][y][x]); };
        const RangeLanes range = bezierRange(at(0), at(1), at(2), at(3));
        hn::Store(range.least, f, &least_[z][y][x]);
        hn::Store(range.most, f, &most_[z][y][x]);
      }
}

// Row y then is of cells.
inline void CubicBlock::boundAlongY() {
  const F f;
  for (int z = 0; z < kCells; ++z)
    for (int y = 0; y < kCells; ++y)
      for (int x = 0; x < kStride; x += static_cast<int>(kLanes)) {
        const auto of = [&](const float(&rows)[kSamples][kStride]) {
          return bezierRange(hn::Load(f, &rows[y][x]), hn::Load(f, &rows[y + 1][x]),
                             hn::Load(f, &rows[y + 2][x]), hn::Load(f, &rows[y + 3][x]));
        };
        const VF least = of(least_[z]).least, most = of(most_[z]).most;
        hn::Store(least, f, &least_[z][y][x]);
        hn::Store(most, f, &most_[z][y][x]);
      }
}

// Cells beside missing samples have a bit or not: no side is known behind them in either case.
inline casting::CellBitsOnDemand::Words CubicBlock::crossed(const CastView& view) {
  const F f;
  const float slack = rounding();
  boundAlongZ();
  boundAlongY();
  casting::CellBitsOnDemand::Words words{};
  for (int z = 0; z < kCells; ++z)
    for (int y = 0; y < kCells; ++y)
      for (int x = 0; x < kCells; x += static_cast<int>(kLanes)) {
        const auto of = [&](const float(&row)[kStride]) {  // what lies behind 8 cells is not used
          return bezierRange(hn::Load(f, &row[x]), hn::LoadU(f, &row[x] + 1), hn::LoadU(f, &row[x] + 2),
                             hn::LoadU(f, &row[x] + 3));
        };
        const VF least = of(least_[z][y]).least, most = of(most_[z][y]).most;
        MF crossed = noLane();
        for (int k = 0; k < view.surfaces; ++k)
          crossed = hn::Or(crossed, hn::And(hn::Le(least, hn::Set(f, view.shifts[k] + slack)),
                                            hn::Ge(most, hn::Set(f, view.shifts[k] - slack))));
        const std::uint64_t bits = bitsOf(hn::RebindMask(I(), crossed)) & 255;
        words[static_cast<std::size_t>(z)] |= bits << (x + 8 * y);
      }
  return words;
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
