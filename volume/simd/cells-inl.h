// Reads the corners of a cell per SIMD lane, and forms the cubic along a ray through each. Included once per
// instruction set.
#if defined(ISOLUX_VOLUME_SIMD_CELLS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_SIMD_CELLS_INL_H
#undef ISOLUX_VOLUME_SIMD_CELLS_INL_H
#else
#define ISOLUX_VOLUME_SIMD_CELLS_INL_H
#endif

#include <cstring>
#include <limits>
#include <type_traits>

#include <hwy/cache_control.h>
#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include "volume/simd/lanes-inl.h"
#include "volume/voxels/extent.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// The cells that lanes are in.
struct CellLanes {
  VI axes[3];

  HWY_INLINE VI& operator[](int axis) { return axes[axis]; }
  HWY_INLINE VI operator[](int axis) const { return axes[axis]; }
};

// Returns where the ray of a lane is in its cell at t: [0, 1] on each axis.
HWY_INLINE glm::dvec3 inCell(glm::ivec3 cell, const float (&origin)[3][kLanes],
                             const float (&direction)[3][kLanes], std::size_t lane, float t) {
  glm::dvec3 p;
  for (int axis = 0; axis < 3; ++axis)
    p[axis] = static_cast<double>(origin[axis][lane]) +
              static_cast<double>(t) * static_cast<double>(direction[axis][lane]) - cell[axis];
  return glm::clamp(p, 0.0, 1.0);
}

// The values at a cell's corners x and x + 1.
struct Edge {
  VF low, high;
};

// The four edges along x of every lane's cell.
struct Corners {
  Edge e00, e10, e01, e11;
};

HWY_INLINE Edge edgeOf(const std::int16_t*, VI pair) {
  return {hn::ConvertTo(F(), hn::ShiftRight<16>(hn::ShiftLeft<16>(pair))),
          hn::ConvertTo(F(), hn::ShiftRight<16>(pair))};
}

HWY_INLINE Edge edgeOf(const std::uint16_t*, VI pair) {
  return {hn::ConvertTo(F(), hn::And(pair, hn::Set(I(), 0xffff))),
          hn::ConvertTo(F(), hn::BitCast(I(), hn::ShiftRight<16>(hn::BitCast(U(), pair))))};
}

// From the two lower bytes.
HWY_INLINE Edge edgeOf(const std::int8_t*, VI pair) {
  return {hn::ConvertTo(F(), hn::ShiftRight<24>(hn::ShiftLeft<24>(pair))),
          hn::ConvertTo(F(), hn::ShiftRight<24>(hn::ShiftLeft<16>(pair)))};
}

HWY_INLINE Edge edgeOf(const std::uint8_t*, VI pair) {
  const VI byte = hn::Set(I(), 0xff);
  return {hn::ConvertTo(F(), hn::And(pair, byte)),
          hn::ConvertTo(F(), hn::And(hn::ShiftRight<8>(pair), byte))};
}

template <class T>
HWY_INLINE Edge edgeOf(const T* type, const std::int32_t* pairs) {
  return edgeOf(type, hn::Load(I(), pairs));
}

HWY_INLINE Edge edgeOf(const float*, const std::int64_t* pairs) {
#if HWY_TARGET == HWY_SCALAR
  float edge[2];
  std::memcpy(edge, pairs, sizeof edge);
  return {hn::Set(F(), edge[0]), hn::Set(F(), edge[1])};
#else
  const hn::Repartition<std::int64_t, F> l;
  const VF a = hn::BitCast(F(), hn::Load(l, pairs)), b = hn::BitCast(F(), hn::Load(l, pairs + kLanes / 2));
  return {hn::ConcatEven(F(), b, a), hn::ConcatOdd(F(), b, a)};
#endif
}

// The voxels of a grid, read at one cell per lane. wide: voxels have no 32-bit numbers, but their rows have.
template <class T, bool wide>
class VoxelLanes {
 public:
  HWY_INLINE VoxelLanes(const T* voxels, glm::ivec3 dims)
      : voxels_(voxels), dims_(dims), row_(Extent3{dims}.row()), slice_(Extent3{dims}.slice()) {}

  // Lanes that are not `wanted` read one place that is always the same, not memory that nobody needs.
  HWY_INLINE Corners corners(const CellLanes& cell, MI wanted) const {
    using Pair = std::conditional_t<std::is_same_v<T, float>, std::int64_t, std::int32_t>;
    alignas(64) Pair pairs[4][kLanes];
    const auto load = [](Pair& pair, const T* corner) {
      if constexpr (sizeof(T) == 1) pair = 0;
      std::memcpy(&pair, corner, 2 * sizeof(T));
    };
    const Places places(*this, cell, wanted);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const T* const corner = at(places, lane);
      load(pairs[0][lane], corner);
      load(pairs[1][lane], corner + row_);
      load(pairs[2][lane], corner + slice_);
      load(pairs[3][lane], corner + slice_ + row_);
    }
    return {edgeOf(voxels_, pairs[0]), edgeOf(voxels_, pairs[1]), edgeOf(voxels_, pairs[2]),
            edgeOf(voxels_, pairs[3])};
  }

  HWY_INLINE void prefetch(const CellLanes& cell, MI wanted) const {
    const Places places(*this, cell, hn::Eq(cell[0], cell[0]));
    forLanes(bitsOf(wanted), [&](std::size_t lane) {
      const T* const corner = at(places, lane);
      hwy::Prefetch(corner);
      hwy::Prefetch(corner + row_);
      hwy::Prefetch(corner + slice_);
      hwy::Prefetch(corner + slice_ + row_);
    });
  }

 private:
  // Voxel x of a row, or where wide is not, x of all.
  struct Places {
    alignas(64) std::uint32_t row[kLanes], x[kLanes];

    HWY_INLINE Places(const VoxelLanes& voxels, const CellLanes& cell, MI wanted) {
      const I i;
      const VI rows = hn::Add(hn::Mul(cell[2], hn::Set(i, voxels.dims_.y)), cell[1]);
      VI places = cell[0];
      if constexpr (wide)
        hn::Store(hn::BitCast(U(), hn::IfThenElseZero(wanted, rows)), U(), row);
      else
        places = hn::Add(hn::Mul(rows, hn::Set(i, voxels.dims_.x)), places);
      hn::Store(hn::BitCast(U(), hn::IfThenElseZero(wanted, places)), U(), x);
    }
  };
  HWY_INLINE const T* at(const Places& places, std::size_t lane) const {
    return voxels_ + (wide ? places.row[lane] * row_ : 0) + places.x[lane];
  }

  const T* voxels_;
  glm::ivec3 dims_;
  std::size_t row_, slice_;
};

// Lanes with a corner that is NaN.
HWY_INLINE MF missing(const Corners& c) {
  const VF sum = hn::Add(hn::Add(hn::Add(c.e00.low, c.e00.high), hn::Add(c.e10.low, c.e10.high)),
                         hn::Add(hn::Add(c.e01.low, c.e01.high), hn::Add(c.e11.low, c.e11.high)));
  const MF suspect = hn::IsNaN(hn::Sub(sum, sum));
  // Large but finite corners may overflow in the sum.
  if (hn::AllFalse(F(), suspect)) return suspect;
  const auto either = [](const Edge& a, const Edge& b) {
    return hn::Or(hn::Or(hn::IsNaN(a.low), hn::IsNaN(a.high)), hn::Or(hn::IsNaN(b.low), hn::IsNaN(b.high)));
  };
  return hn::Or(either(c.e00, c.e10), either(c.e01, c.e11));
}

// Interpolates between two values; between values on one side of 0 never to the other, however far apart they
// are.
struct Between {
  VF at, rest;
  explicit HWY_INLINE Between(VF s) : at(s), rest(hn::Sub(hn::Set(F(), 1.0f), s)) {}
  HWY_INLINE VF operator()(VF a, VF b) const { return hn::MulAdd(at, b, hn::Mul(rest, a)); }
};

// The coefficients of cubics in Bernstein form on [0, 1].
struct BernsteinCoefficients {
  VF b0, b1, b2, b3;
};

// Returns the trilinear function along the segment of its cell from p to q: its polar form at the two ends.
// changed(v): what is interpolated of a corner's value.
template <class Changed>
HWY_INLINE BernsteinCoefficients bernsteinOf(const Corners& c, const VF (&p)[3], const VF (&q)[3],
                                             const Changed& changed) {
  const Between px(p[0]), py(p[1]), pz(p[2]), qx(q[0]), qy(q[1]), qz(q[2]);
  const VF a00 = changed(c.e00.low), a10 = changed(c.e10.low), a01 = changed(c.e01.low),
           a11 = changed(c.e11.low);
  const VF b00 = changed(c.e00.high), b10 = changed(c.e10.high), b01 = changed(c.e01.high),
           b11 = changed(c.e11.high);
  const VF p00 = px(a00, b00), p10 = px(a10, b10), p01 = px(a01, b01), p11 = px(a11, b11);
  const VF q00 = qx(a00, b00), q10 = qx(a10, b10), q01 = qx(a01, b01), q11 = qx(a11, b11);
  const VF pp0 = py(p00, p10), pp1 = py(p01, p11), pq0 = qy(p00, p10), pq1 = qy(p01, p11);
  const VF qp0 = py(q00, q10), qp1 = py(q01, q11), qq0 = qy(q00, q10), qq1 = qy(q01, q11);
  const VF third = hn::Set(F(), 1.0f / 3.0f);
  return {pz(pp0, pp1), hn::Mul(third, hn::Add(hn::Add(pz(qp0, qp1), pz(pq0, pq1)), qz(pp0, pp1))),
          hn::Mul(third, hn::Add(hn::Add(pz(qq0, qq1), qz(qp0, qp1)), qz(pq0, pq1))), qz(qq0, qq1)};
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
