// distancesTo() of phantom_shapes.h, compiled for every instruction set and chosen at run time. No fused
// multiplication: it would round differently.
#include "volume/phantom/phantom_shapes.h"

#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "volume/phantom/phantom_distance.cpp"
#include <hwy/foreach_target.h>  // before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolux::volume {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Lanes = hn::CappedTag<float, PointRow::kPoints>;
using Floats = hn::Vec<Lanes>;

struct Vectors {
  Floats x, y, z;
};

HWY_INLINE Floats dot(const Vectors& a, const Vectors& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE Floats length(const Vectors& v) {
  return hn::Sqrt(dot(v, v));
}
HWY_INLINE Vectors quotient(const Vectors& a, const Vectors& b) {
  return {hn::Div(a.x, b.x), hn::Div(a.y, b.y), hn::Div(a.z, b.z)};
}
HWY_INLINE Vectors same(glm::vec3 v) {
  const Lanes f;
  return {hn::Set(f, v.x), hn::Set(f, v.y), hn::Set(f, v.z)};
}
HWY_INLINE Vectors mixed(glm::vec3 a, glm::vec3 b, Floats t) {
  const Lanes f;
  const Floats rest = hn::Sub(hn::Set(f, 1.0f), t);
  const auto one = [&](float from, float to) {
    return hn::Add(hn::Mul(hn::Set(f, from), rest), hn::Mul(hn::Set(f, to), t));
  };
  return {one(a.x, b.x), one(a.y, b.y), one(a.z, b.z)};
}

// First-order distance to an ellipsoid: F/|grad F| with F = k0 (k0 - 1), k0 = |q/r|.
HWY_INLINE Floats toEllipsoid(const Vectors& q, const Vectors& r) {
  const Lanes f;
  const Vectors scaled = quotient(q, r);
  const Floats k0 = length(scaled), k1 = length(quotient(scaled, r));
  const Floats distance = hn::Div(hn::Mul(k0, hn::Sub(k0, hn::Set(f, 1.0f))), k1);
  const Floats deepest = hn::Neg(hn::Min(hn::Min(r.x, r.y), r.z));  // at the centre
  return hn::IfThenElse(hn::Lt(k1, hn::Set(f, 1e-6f)), deepest, distance);
}

HWY_INLINE Floats toShape(const Shape& shape, const Vectors& p) {
  const Lanes f;
  const glm::vec3 axis = shape.b - shape.a;
  const float square = axis.x * axis.x + axis.y * axis.y + axis.z * axis.z;
  const Vectors a = same(shape.a);
  const Vectors fromA{hn::Sub(p.x, a.x), hn::Sub(p.y, a.y), hn::Sub(p.z, a.z)};
  if (!(square > 0.0f)) return toEllipsoid(fromA, same(shape.radiiA));
  const Floats along = hn::Div(dot(fromA, same(axis)), hn::Set(f, square));
  const Floats t = hn::Min(hn::Max(along, hn::Zero(f)), hn::Set(f, 1.0f));
  const Vectors middle = mixed(shape.a, shape.b, t);
  return toEllipsoid({hn::Sub(p.x, middle.x), hn::Sub(p.y, middle.y), hn::Sub(p.z, middle.z)},
                     mixed(shape.radiiA, shape.radiiB, t));
}

// smoothMinimum() of phantom_shapes.h.
HWY_INLINE Floats smallest(Floats a, Floats b, float k) {
  const Lanes f;
  const Floats least = hn::Min(a, b);
  if (k <= 0.0f) return least;
  const Floats width = hn::Set(f, k);
  const Floats h = hn::Div(hn::Max(hn::Sub(width, hn::Abs(hn::Sub(a, b))), hn::Zero(f)), width);
  const Floats cubed = hn::Mul(hn::Mul(h, h), h);
  return hn::Sub(least, hn::Mul(hn::Mul(cubed, width), hn::Set(f, 1.0f / 6.0f)));
}

void distances(std::span<const Shape* const> shapes, const PointRow& points, float* out) {
  constexpr float far = 1e4f;
  const Lanes f;
  for (std::size_t i = 0; i < PointRow::kPoints; i += hn::Lanes(f)) {
    const Vectors p{hn::LoadU(f, points.x + i), hn::LoadU(f, points.y + i), hn::LoadU(f, points.z + i)};
    const Vectors mirrored{hn::Abs(p.x), p.y, p.z};
    Floats distance = hn::Set(f, far);
    for (const Shape* const shape : shapes) {
      const Floats d = toShape(*shape, shape->mirrored ? mirrored : p);
      distance = shape->remove ? hn::Neg(smallest(hn::Neg(distance), d, shape->blend))
                               : smallest(distance, d, shape->blend);
    }
    hn::StoreU(distance, f, out + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolux::volume {

HWY_EXPORT(distances);

void distancesTo(std::span<const Shape* const> shapes, const PointRow& points,
                 float (&result)[PointRow::kPoints]) {
  HWY_DYNAMIC_DISPATCH(distances)(shapes, points, result);
}

}  // namespace isolux::volume
#endif
