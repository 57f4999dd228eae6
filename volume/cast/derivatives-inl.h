// Writes gradient and Hessian at the points of an image. Included once per instruction set by
// simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_DERIVATIVES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_DERIVATIVES_INL_H
#undef ISOLUX_VOLUME_CAST_DERIVATIVES_INL_H
#else
#define ISOLUX_VOLUME_CAST_DERIVATIVES_INL_H
#endif

#include <variant>

#include "volume/cast/cast_kernels.h"
#include "volume/cast/scaled_derivatives-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// H_w = A^-T H_v A^-1, the lower triangle.
HWY_INLINE void toWorld(const glm::mat3& m, glm::vec3& diagonal, glm::vec3& mixed) {
  const glm::vec3 h0(diagonal.x, mixed.x, mixed.y), h1(mixed.x, diagonal.y, mixed.z),
      h2(mixed.y, mixed.z, diagonal.z);
  glm::vec3 rows[3];  // of A^-T H
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) rows[i][k] = m[0][i] * h0[k] + m[1][i] * h1[k] + m[2][i] * h2[k];
  const auto entry = [&](int i, int j) {
    return rows[i].x * m[0][j] + rows[i].y * m[1][j] + rows[i].z * m[2][j];
  };
  diagonal = {entry(0, 0), entry(1, 1), entry(2, 2)};
  mixed = {entry(0, 1), entry(0, 2), entry(1, 2)};
}

HWY_INLINE glm::vec4 withFlag(glm::vec3 v, float scale, bool flag) {
  return {v.x * scale, v.y * scale, v.z * scale, flag ? 1.0f : 0.0f};
}

// Writes derivativesAt(point) of each point of the target, transformed to world.
template <bool hessian, class At>
HWY_INLINE void storeDerivatives(const DerivativesView& view, const casting::DerivativesTarget& target,
                                 const At& derivativesAt) {
  const glm::vec4 none(0.0f);
  const glm::mat3& m = view.worldFromVoxel;
  for (std::size_t i = 0; i < target.count; ++i) {
    const glm::vec4 point = target.points[i];
    target.gradient[i] = none;
    if (hessian) target.diagonal[i] = target.mixed[i] = none;
    if (point.w < 0.0f) continue;
    PointDerivatives at = derivativesAt(locate(view.dims, glm::vec3(point)));
    const glm::vec3 g = at.gradient;
    target.gradient[i] =
        withFlag({m[0].x * g.x + m[1].x * g.y + m[2].x * g.z, m[0].y * g.x + m[1].y * g.y + m[2].y * g.z,
                  m[0].z * g.x + m[1].z * g.y + m[2].z * g.z},
                 view.dataUnits, true);
    if (!hessian || !at.known) continue;
    toWorld(m, at.diagonal, at.mixed);
    target.diagonal[i] = withFlag(at.diagonal, view.dataUnits, true);
    target.mixed[i] = withFlag(at.mixed, view.dataUnits, at.within);
  }
}

template <bool hessian>
void storeAll(const DerivativesView& view, const casting::DerivativesTarget& target) {
  if (view.scaled) {
    const ScaledDerivativesAt scaled(view);
    storeDerivatives<hessian>(view, target,
                              [&](const Located& p) { return scaled.template operator()<hessian>(p); });
    return;
  }
  const auto store = [&](const auto& cells, const auto& splines) {
    storeDerivatives<hessian>(view, target, [&](const Located& p) {
      PointDerivatives at{};
      if (view.cubic) {
        at = splines.template spline<hessian>(p);
        if (!at.known) at.gradient = cells.trilinear(p).gradient;
      } else {
        at = cells.trilinear(p);
        at.within = true;
      }
      return at;
    });
  };
  // Coefficients are floats; otherwise the spline is that of the samples.
  const auto* const coefficients = std::get_if<const float*>(&view.spline);
  std::visit(
      [&](const auto* samples) {
        const DerivativesAt cells(samples, view.dims);
        coefficients ? store(cells, DerivativesAt(*coefficients, view.dims)) : store(cells, cells);
      },
      view.samples);
}

void derivatives(const DerivativesView& view, const casting::DerivativesTarget& target) {
  target.diagonal ? storeAll<true>(view, target) : storeAll<false>(view, target);
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
