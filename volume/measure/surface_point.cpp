#include "volume/measure/surface_point.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/field/reconstruct.h"
#include "volume/hit/nearest_point.h"

namespace isolux::volume {

namespace {

constexpr double kPointSafety = 2.0, kPointSigmas = 2.0;
constexpr double kRootRounding = 1e-6;  // of a voxel: float voxels, and the search for a root
constexpr int kMostSteps = 20;
constexpr float kNearVoxels = 3.0f;

}  // namespace

std::optional<glm::dvec3> ontoSurface(const SurfaceOf& surface, glm::dvec3 world, double reachMm) {
  const GridGeometry& geometry = surface.grid.geometry();
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  const double longest = geometry.leastSpacingMm(), enough = 1e-9 * geometry.mostSpacingMm();
  const glm::dvec3 last(surface.grid.dims() - 1);
  glm::dvec3 at = world;
  for (int step = 0; step < kMostSteps; ++step) {
    glm::dvec3 voxel(voxelFromWorld * glm::dvec4(at, 1.0));
    voxel = glm::clamp(voxel, glm::dvec3(0.0), last);
    const FieldSample field = sampleTrilinear(surface.grid, voxel);
    const glm::dvec3 gradient = worldGradient(geometry, field.gradient);
    const double squared = glm::dot(gradient, gradient), off = field.value - surface.isovalue;
    if (!(squared > 0.0)) return std::nullopt;  // NaN too
    glm::dvec3 move = -gradient * (off / squared);
    const double length = glm::length(move);
    if (length > longest) move *= longest / length;
    at = geometry.worldOf(voxel) + move;
    if (glm::length(at - world) > reachMm) return std::nullopt;
    if (length < enough) return at;
  }
  // Between two cells whose gradients differ the steps may go to and fro: close is good enough.
  const glm::dvec3 voxel(voxelFromWorld * glm::dvec4(at, 1.0));
  const FieldSample field = sampleTrilinear(surface.grid, voxel);
  const double off = std::abs(field.value - surface.isovalue);
  if (!(off <= 1e-3 * longest * glm::length(worldGradient(geometry, field.gradient)))) return std::nullopt;
  return at;
}

std::optional<SurfacePoint> surfacePoint(const SurfaceOf& surface, glm::dvec3 onSurface) {
  const GridGeometry& geometry = surface.grid.geometry();
  const double sign = surface.inside == scene::Inside::above ? 1.0 : -1.0;
  SurfacePoint point;
  point.world = onSurface;
  point.voxel = geometry.voxelOf(onSurface);
  const FieldSample facet = sampleTrilinear(surface.grid, point.voxel),
                    spline = sampleCubic(surface.grid, point.voxel);
  const glm::dvec3 flat = sign * worldGradient(geometry, facet.gradient),
                   smooth = sign * worldGradient(geometry, spline.gradient);
  const double steepness = glm::length(smooth), facetSteepness = glm::length(flat);
  if (!(steepness > 0.0 && facetSteepness > 0.0)) return std::nullopt;
  point.normal = -smooth / steepness;
  point.facet = -flat / facetSteepness;
  point.shape = worldHessian(geometry, spline.hessian) * (-sign / steepness);
  // Along each axis the trilinear field is off by x (1 - x) f'' / 2; the surface of the true one lies outward
  // of a point where it is larger.
  double lacks = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double x = point.voxel[axis] - std::floor(point.voxel[axis]);
    lacks -= 0.5 * x * (1.0 - x) * spline.hessian[axis][axis];
  }
  // Where the gradient nearly vanishes the leading order says nothing: no more than a voxel.
  const double voxelMm = geometry.voxelMm();
  point.samplingMm = std::clamp(sign * lacks / steepness, -voxelMm, voxelMm);
  double most = 0.0;
  for (int axis = 0; axis < 3; ++axis) most += std::abs(spline.hessian[axis][axis]) / 8.0;
  point.rippleMm = std::min(most / steepness, voxelMm);
  point.roundingMm = kRootRounding * voxelMm;
  point.noiseMm = std::min(surface.noise.at(surface.isovalue) / steepness, voxelMm);
  // A surface that runs across the slices may lie anywhere between two of them.
  const glm::dmat3 axes = geometry.directions();
  const glm::dvec3 across = glm::normalize(glm::cross(axes[0], axes[1]));
  point.slicesMm = 0.5 * surface.noise.slicesMm * std::abs(glm::dot(point.normal, across));
  return point;
}

std::optional<SurfacePoint> nearestPoint(const SurfaceOf& surface, glm::dvec3 world) {
  const GridGeometry& geometry = surface.grid.geometry();
  const glm::dvec3 voxel = geometry.voxelOf(world);
  if (!geometry.holds(voxel)) return std::nullopt;
  const double widest = geometry.mostSpacingMm();
  const auto near = nearestSurfacePoint(surface.grid, glm::vec3(voxel), glm::vec3(kNearVoxels),
                                        surface.grid.storedIsovalue(surface.isovalue));
  if (!near) return std::nullopt;
  const glm::dvec3 at = geometry.worldOf(glm::dvec3(*near));
  const auto exact = ontoSurface(surface, at, widest);
  if (!exact) return std::nullopt;
  const auto start = surfacePoint(surface, *exact);
  if (!start) return std::nullopt;
  return slideNearest(surface, world, *start, widest, 8,
                      1e-9 * widest);  // the search was in voxels: now in mm
}

SurfacePoint slideNearest(const SurfaceOf& surface, glm::dvec3 world, const SurfacePoint& start,
                          double reachMm, int mostSlides, double leastGainMm) {
  SurfacePoint at = start;
  for (int slide = 0; slide < mostSlides; ++slide) {
    const glm::dvec3 foot = world + at.facet * glm::dot(at.world - world, at.facet);
    const auto closer = ontoSurface(surface, foot, reachMm);
    if (!closer || glm::length(*closer - world) >= glm::length(at.world - world) - leastGainMm) break;
    const auto point = surfacePoint(surface, *closer);
    if (!point) break;
    at = *point;
  }
  return at;
}

double offsetError(const SurfacePoint& point) {
  return kPointSafety * std::abs(point.samplingMm) + kPointSigmas * point.noiseMm + point.roundingMm +
         point.slicesMm;
}

}  // namespace isolux::volume
