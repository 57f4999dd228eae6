// Forms the polynomial of degree 9 of a tri-cubic B-spline's cell along each lane's ray; as
// resources/shaders/cast/trace_cubic.glsl. Included once per instruction set by simd_cast-inl.h.
//
// Its Bernstein coefficients follow from the 64 samples by convex combinations only: blossoms at the
// segment's ends along each axis give the Bezier points of the box between them; their means over i + j + k =
// m are the coefficients (volume/hit/exact_cubic_hit.h).
#if defined(ISOLUX_VOLUME_CAST_CUBIC_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_CUBIC_CELLS_INL_H
#undef ISOLUX_VOLUME_CAST_CUBIC_CELLS_INL_H
#else
#define ISOLUX_VOLUME_CAST_CUBIC_CELLS_INL_H
#endif

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

#include "volume/cast/bernstein9-inl.h"
#include "volume/cast/cubic_cell_bits-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// Four samples along x of each lane's cell.
struct RowLanes {
  VF s[4];
};

HWY_INLINE RowLanes rowLanes(const float* row) {
  RowLanes out;
  hn::LoadInterleaved4(F(), row, out.s[0], out.s[1], out.s[2], out.s[3]);
  return out;
}

template <class T>
HWY_INLINE RowLanes rowLanes(const T* row) {
  const hn::Repartition<T, F> whole;
  VI first = hn::BitCast(I(), hn::Load(whole, row)), second;
  if constexpr (sizeof(T) == 1) {
    second = hn::ShiftRight<16>(first);
  } else {
    const VI behind = hn::BitCast(I(), hn::Load(whole, row + 2 * kLanes));
    second = hn::ConcatOdd(I(), behind, first);
    first = hn::ConcatEven(I(), behind, first);
  }
  const Edge a = edgeOf(row, first), b = edgeOf(row, second);
  return {{a.low, a.high, b.low, b.high}};
}

// The weights of four samples for the blossom F(u, v, v) of the uniform cubic B-spline on [0, 1], times 3.
HWY_INLINE void blossom(VF u, VF v, VF (&weights)[4]) {
  const F f;
  const VF one = hn::Set(f, 1.0f), two = hn::Set(f, 2.0f), half = hn::Set(f, 0.5f);
  const VF rest = hn::Sub(one, v), across = hn::Mul(half, rest), along = hn::Mul(half, v);
  const VF a = hn::Mul(across, rest), c = hn::Mul(along, v);
  const VF b = hn::MulAdd(across, hn::Add(one, v), hn::Mul(along, hn::Sub(two, v)));
  weights[0] = hn::Mul(a, hn::Sub(one, u));
  weights[1] = hn::MulAdd(a, hn::Add(u, two), hn::Mul(b, hn::Sub(two, u)));
  weights[2] = hn::MulAdd(b, hn::Add(u, one), hn::Mul(c, hn::Sub(hn::Set(f, 3.0f), u)));
  weights[3] = hn::Mul(c, u);
}

// Row i: the weights at (from^(3-i), to^i), times 3 C(3, i) scale.
struct Blossoms {
  VF w[4][4];

  HWY_INLINE Blossoms(VF from, VF to, float scale) {
    blossom(from, from, w[0]);
    blossom(to, from, w[1]);
    blossom(from, to, w[2]);
    blossom(to, to, w[3]);
    const VF end = hn::Set(F(), scale), middle = hn::Set(F(), 3.0f * scale);
    for (int i = 0; i < 4; ++i)
      for (VF& weight : w[i]) weight = hn::Mul(weight, i == 0 || i == 3 ? end : middle);
  }
};

// T: of the samples. Missing ones are NaN, in float samples only.
template <class T>
class CubicCells {
 public:
  using Curve = Bernstein9;
  // The 4 x 4 x 4 samples about the cell of each lane: rows along x, row 4 k + j at (j, k).
  struct Samples {
    alignas(64) T rows[16][4 * kLanes] = {};
  };

  CubicCells(const CastView& view, const T* samples)
      : view_(view),
        samples_(samples),
        row_(static_cast<std::size_t>(view.dims.x)),
        slice_(row_ * static_cast<std::size_t>(view.dims.y)) {}

  // Of lanes in boxes that can hold a crossing, returns those whose cell can.
  HWY_INLINE MI mayCross(const CellLanes& cell, MI wanted) const;

  // Forms the field less the first isovalue, scaled, along each ray in [tIn, tOut] of its cell. Returns lanes
  // whose cell has a missing sample, or a missing corner: coefficients are known in gaps too.
  MF along(const RayLanes& ray, const CellLanes& cell, VF tIn, VF tOut, MI wanted, Samples& samples,
           Bernstein9& b) const;

  // The same at points; NaN beside missing samples.
  VF valueAt(const VF (&p)[3], MF wanted) const;

 private:
  // Calls visit(lane, cell) for each lane wanted.
  template <class Visit>
  HWY_INLINE void forCells(const CellLanes& cell, MI wanted, const Visit& visit) const;
  const casting::CellBitsOnDemand::Words& wordsOf(glm::ivec3 block) const;
  void load(std::size_t lane, glm::ivec3 cell, Samples& samples) const;
  HWY_INLINE bool hasMissingCorner(glm::ivec3 low) const;
  HWY_INLINE RowLanes lessIsovalue(const T* row) const;

  const CastView& view_;
  const T* samples_;
  std::size_t row_, slice_;
};

template <class T>
template <class Visit>
HWY_INLINE void CubicCells<T>::forCells(const CellLanes& cell, MI wanted, const Visit& visit) const {
  alignas(64) std::int32_t low[3][kLanes];
  for (int axis = 0; axis < 3; ++axis) hn::Store(cell[axis], I(), low[axis]);
  forLanes(bitsOf(wanted),
           [&](std::size_t lane) { visit(lane, glm::ivec3(low[0][lane], low[1][lane], low[2][lane])); });
}

template <class T>
const casting::CellBitsOnDemand::Words& CubicCells<T>::wordsOf(glm::ivec3 block) const {
  const std::size_t at = Extent3{view_.blockDims}.index(block);
  if (const auto* const known = view_.cells->find(at)) return *known;
  CubicBlock samples;
  samples.load(view_, samples_, block);
  casting::CellBitsOnDemand::Words words = samples.crossed(view_);
  // Where pieces touch what is seen changes within the spline's inside.
  for (const ShownCells& shown : view_.shown) {
    const auto around = shown.aroundHidden(8 * block);
    for (std::size_t z = 0; z < words.size(); ++z) words[z] |= around[z];
  }
  return *view_.cells->add(at, words);
}

template <class T>
HWY_INLINE MI CubicCells<T>::mayCross(const CellLanes& cell, MI wanted) const {
  const I i;
  alignas(64) std::int32_t may[kLanes] = {};
  forCells(cell, wanted, [&](std::size_t lane, glm::ivec3 low) {
    const auto& words = wordsOf(low >> 3);
    may[lane] = static_cast<std::int32_t>(
        words[static_cast<std::size_t>(low.z & 7)] >> ((low.x & 7) + 8 * (low.y & 7)) & 1);
  });
  return hn::Ne(hn::Load(i, may), hn::Zero(i));
}

// Beyond the border samples repeat.
template <class T>
void CubicCells<T>::load(std::size_t lane, glm::ivec3 cell, Samples& samples) const {
  const glm::ivec3 first = cell - 1, last = view_.dims - 1;
  const bool within = first.x >= 0 && first.y >= 0 && first.z >= 0 && first.x + 3 <= last.x &&
                      first.y + 3 <= last.y && first.z + 3 <= last.z;
  const auto lineAt = [&](int y, int z) {
    return samples_ + static_cast<std::size_t>(z) * slice_ + static_cast<std::size_t>(y) * row_;
  };
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      T* const row = &samples.rows[4 * k + j][4 * lane];
      if (within) {
        std::memcpy(row, lineAt(first.y + j, first.z + k) + first.x, 4 * sizeof(T));
        continue;
      }
      const T* const line =
          lineAt(std::min(std::max(first.y + j, 0), last.y), std::min(std::max(first.z + k, 0), last.z));
      for (int i = 0; i < 4; ++i) row[i] = line[std::min(std::max(first.x + i, 0), last.x)];
    }
}

template <class T>
HWY_INLINE bool CubicCells<T>::hasMissingCorner(glm::ivec3 low) const {
  const float* const corner = view_.gapsOf + static_cast<std::size_t>(low.z) * slice_ +
                              static_cast<std::size_t>(low.y) * row_ + static_cast<std::size_t>(low.x);
  for (const std::size_t line : {std::size_t{0}, row_, slice_, slice_ + row_})
    if (std::isnan(corner[line]) || std::isnan(corner[line + 1])) return true;
  return false;
}

// Differences of like numbers are exact.
template <class T>
HWY_INLINE RowLanes CubicCells<T>::lessIsovalue(const T* row) const {
  const VF offset = hn::Set(F(), view_.offset), isovalue = hn::Set(F(), view_.isovalue);
  RowLanes out = rowLanes(row);
  for (VF& s : out.s) {
    if constexpr (std::is_same_v<T, float>) s = hn::Sub(s, offset);
    s = hn::Sub(s, isovalue);
  }
  return out;
}

template <class T>
MF CubicCells<T>::along(const RayLanes& ray, const CellLanes& cell, VF tIn, VF tOut, MI wanted,
                        Samples& samples, Bernstein9& b) const {
  const F f;
  const I i32;
  alignas(64) std::int32_t beside[kLanes] = {};
  forCells(cell, wanted, [&](std::size_t lane, glm::ivec3 low) {
    load(lane, low, samples);
    if (view_.gapsOf && hasMissingCorner(low)) beside[lane] = 1;
  });
  const Blossoms x(inCell(ray, 0, cell, tIn), inCell(ray, 0, cell, tOut), view_.scale / 27.0f);
  const Blossoms y(inCell(ray, 1, cell, tIn), inCell(ray, 1, cell, tOut), 1.0f);
  const Blossoms z(inCell(ray, 2, cell, tIn), inCell(ray, 2, cell, tOut), 1.0f);
  b = Bernstein9::zero();
  for (int k = 0; k < 4; ++k) {
    VF plane[7];  // i + j
    for (VF& sum : plane) sum = hn::Zero(f);
    for (int j = 0; j < 4; ++j) {
      const RowLanes row = lessIsovalue(samples.rows[4 * k + j]);
      for (int i = 0; i < 4; ++i) {
        VF sum = hn::Mul(x.w[i][0], row.s[0]);
        for (int tap = 1; tap < 4; ++tap) sum = hn::MulAdd(x.w[i][tap], row.s[tap], sum);
        for (int at = 0; at < 4; ++at) plane[i + at] = hn::MulAdd(y.w[at][j], sum, plane[i + at]);
      }
    }
    for (int at = 0; at < 4; ++at)
      for (int n = 0; n < 7; ++n) b.b[n + at] = hn::MulAdd(z.w[at][k], plane[n], b.b[n + at]);
  }
  constexpr float choose[10] = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
  for (int m = 1; m < 9; ++m) b.b[m] = hn::Mul(b.b[m], hn::Set(f, 1.0f / choose[m]));
  MF missing = hn::RebindMask(f, hn::Ne(hn::Load(i32, beside), hn::Zero(i32)));
  if constexpr (std::is_same_v<T, float>) missing = hn::Or(missing, hn::IsNaN(b.b[0]));
  return missing;
}

template <class T>
VF CubicCells<T>::valueAt(const VF (&p)[3], MF wanted) const {
  const F f;
  const CellLanes cell = cellsAt(view_, p);
  Samples samples;
  forCells(cell, hn::RebindMask(I(), wanted),
           [&](std::size_t lane, glm::ivec3 low) { load(lane, low, samples); });
  const RayLanes at{{p[0], p[1], p[2]}, {hn::Zero(f), hn::Zero(f), hn::Zero(f)}, {}};
  VF weights[3][4];
  for (int axis = 0; axis < 3; ++axis) {
    const VF in = inCell(at, axis, cell, hn::Zero(f));
    blossom(in, in, weights[axis]);
  }
  for (VF& weight : weights[0]) weight = hn::Mul(weight, hn::Set(f, view_.scale / 27.0f));
  VF value = hn::Zero(f);
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j) {
      const RowLanes row = lessIsovalue(samples.rows[4 * k + j]);
      VF sum = hn::Mul(weights[0][0], row.s[0]);
      for (int tap = 1; tap < 4; ++tap) sum = hn::MulAdd(weights[0][tap], row.s[tap], sum);
      value = hn::MulAdd(hn::Mul(weights[1][j], weights[2][k]), sum, value);
    }
  return value;
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
