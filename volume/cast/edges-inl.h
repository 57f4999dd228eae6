// Finds how far the edge of the object lies from points: the walk of volume/edge/edge_walk.h in floats, over
// the field's derivatives at one point at a time. Included once per instruction set by simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_EDGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_EDGES_INL_H
#undef ISOLUX_VOLUME_CAST_EDGES_INL_H
#else
#define ISOLUX_VOLUME_CAST_EDGES_INL_H
#endif

#include "volume/cast/scaled_derivatives-inl.h"

HWY_BEFORE_NAMESPACE();
namespace isolux::volume::tracing {
namespace HWY_NAMESPACE {
#if HWY_TARGET == ISOLUX_SIMD_TARGET

// derive: gradient and Hessian at a point; known: whether the cell is there.
template <class Derive, class Known>
void storeEdges(const casting::EdgeView& view, const casting::EdgeTarget& target, const Derive& derive,
                const Known& known) {
  const auto sample = [&](const glm::vec3& voxel) -> EdgeSample<float> {
    const Located p = locate(view.field.dims, voxel);
    const PointDerivatives at = derive(p);
    if (!at.known || !known(p)) return {};
    const float unit = view.search.unit;
    const glm::vec3 d = at.diagonal * unit, m = at.mixed * unit;
    return {at.gradient * unit, glm::mat3(d.x, m.x, m.y, m.x, d.y, m.z, m.y, m.z, d.z), true};
  };
  const casting::EdgeSampler sampler{&sample, [](const void* derivatives, const glm::vec3& voxel) {
                                       return (*static_cast<const decltype(sample)*>(derivatives))(voxel);
                                     }};
  for (std::size_t i = 0; i < target.count; ++i) {
    const glm::vec4 point = target.points[i];
    target.edges[i] = {target.none, 0.0f};
    if (point.w < 0.0f) continue;
    const FoundEdge<float> edge = casting::edgeAt(view.search, sampler, glm::vec3(point));
    target.edges[i] = {edge.found ? edge.offsetMm : target.none, edge.strength};
  }
}

template <class Sample>
void edgesOf(const casting::EdgeView& view, const Sample* samples, const casting::EdgeTarget& target) {
  const DerivativesAt cells(samples, view.field.dims);
  const auto known = [&](const Located& p) { return !view.gaps || cells.trilinear(p).known; };
  const auto ofSpline = [&](const auto& splines) {
    storeEdges(
        view, target, [&](const Located& p) { return splines.template spline<true>(p); }, known);
  };
  if (view.field.scaled) {
    const ScaledDerivativesAt scaled(view.field);
    storeEdges(
        view, target, [&](const Located& p) { return scaled.template operator()<true>(p); }, known);
  } else if (const auto* const coefficients = std::get_if<const float*>(&view.field.spline)) {
    ofSpline(DerivativesAt(*coefficients, view.field.dims));
  } else {
    ofSpline(cells);
  }
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
