// Points of a trilinear isosurface: the one near a position, and how far the object's own surface may lie
// from it.
//
// Positions are world mm. Any thread.
#pragma once

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/choices.h"
#include "scene/noise.h"
#include "volume/grid.h"

namespace isolux::volume {

struct SurfacePoint {
  glm::dvec3 world{0.0}, voxel{0.0};
  glm::dvec3 normal{0.0};  // unit, outward, world: of the smoothing cubic spline, which has no kinks
  glm::dvec3 facet{0.0};   // the same of the trilinear field
  glm::dmat3 shape{0.0};  // outward * Hessian of the spline / |its gradient|, 1/mm: t^T shape t bends along t
  double samplingMm = 0.0;  // where the object's surface lies along the normal, to the leading order
  double roundingMm = 0.0;
  double rippleMm = 0.0;  // the most that it may be about here
  double noiseMm = 0.0;   // standard deviation of that by noise
  double slicesMm = 0.0;  // the most that it may be between slices that are far apart (NoiseModel::slicesMm)
};

// Which surface, and what is known of the voxels.
struct SurfaceOf {
  const Grid& grid;
  double isovalue;
  scene::Inside inside = scene::Inside::above;
  scene::NoiseModel noise{};
};

// Onto the surface along the gradient, by Newton's steps, none longer than a voxel; nothing where they do not
// lead there within reachMm.
std::optional<glm::dvec3> ontoSurface(const SurfaceOf& surface, glm::dvec3 world, double reachMm);

// What is known of a point of the surface; nothing where the gradient vanishes or voxels are missing.
std::optional<SurfacePoint> surfacePoint(const SurfaceOf& surface, glm::dvec3 onSurface);

// The surface's point nearest to a position, within some voxels about it; nothing where none is there.
std::optional<SurfacePoint> nearestPoint(const SurfaceOf& surface, glm::dvec3 world);

// The same from a point of the surface that is near: slides along the surface while that brings it closer by
// more than `leastGainMm`. reachMm: of each step back onto the surface.
SurfacePoint slideNearest(const SurfaceOf& surface, glm::dvec3 world, const SurfacePoint& start,
                          double reachMm, int mostSlides, double leastGainMm = 0.0);

// How far a point's position may be wrong along the normal, mm: what sampling costs with its factor of
// safety, two standard deviations of the noise, and what lies between slices that were resampled.
double offsetError(const SurfacePoint& point);

}  // namespace isolux::volume
