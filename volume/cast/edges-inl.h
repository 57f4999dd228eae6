// How far the edge of the object lies from points: the walk of volume/edge/edge_walk.h in floats, over the
// field's derivatives at one point at a time. Included once per instruction set by simd_cast-inl.h.
#if defined(ISOLUX_VOLUME_CAST_EDGES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUX_VOLUME_CAST_EDGES_INL_H
#undef ISOLUX_VOLUME_CAST_EDGES_INL_H
#else
#define ISOLUX_VOLUME_CAST_EDGES_INL_H
#endif

#include "volume/cast/derivatives_at-inl.h"
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
    const glm::vec4 point(voxel, 0.0f);
    const PointDerivatives at = derive(point);
    if (!at.known || !known(point)) return {};
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
  const DerivativesAt<Sample> cells(view.field, samples);
  const auto known = [&](glm::vec4 point) { return !view.gaps || cells.trilinear(point).known; };
  if (view.field.scaled) {
    const ScaledDerivativesAt scaled(view.field);
    storeEdges(
        view, target, [&](glm::vec4 point) { return scaled.template operator()<true>(point); }, known);
  } else if (const auto* const coefficients = std::get_if<const float*>(&view.field.spline)) {
    const DerivativesAt<float> splines(view.field, *coefficients);
    storeEdges(
        view, target, [&](glm::vec4 point) { return splines.template spline<true>(point); }, known);
  } else {
    storeEdges(
        view, target, [&](glm::vec4 point) { return cells.template spline<true>(point); }, known);
  }
}

#endif
}  // namespace HWY_NAMESPACE
}  // namespace isolux::volume::tracing
HWY_AFTER_NAMESPACE();

#endif
