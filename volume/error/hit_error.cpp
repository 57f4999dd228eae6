#include "volume/error/hit_error.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/field/reconstruct.h"
#include "volume/field/value_scaling.h"
#include "volume/hit/exact_cubic_hit.h"

namespace isolux::volume {

namespace {

// Roundings of the field along a segment, in parts of the largest corner (coefficient) less the isovalue:
// three interpolations of two roundings, the mean of the middle ones, de Casteljau; of degree 9 twice as
// many.
constexpr double kTrilinearRoundings = 3.0, kCubicRoundings = 6.0;
constexpr double kRootTolerance = 1e-6 / 3.0;  // regula falsi ends at 1e-6 of a segment: its deviation
// An enclosure may be so many times as wide as the slope at the hit says before it is a jump.
constexpr double kContinuous = 4.0;
constexpr double kNarrowVoxels = 1e-3, kWideVoxels = 0.25;

double squared(double x) {
  return x * x;
}
glm::dvec3 squared(const glm::dvec3& v) {
  return v * v;
}

struct FoundCrossing {
  double t;
  glm::dvec3 voxel;
  bool entering, certain;
  std::size_t surface;
};

std::optional<FoundCrossing> nearestCrossing(const HitSource& source, std::span<const RaySurface> surfaces,
                                             const Ray& ray, double offset) {
  std::optional<FoundCrossing> nearest;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const RaySurface& surface = surfaces[k];
    Ray part = ray;
    part.tMinimum = std::max(ray.tMinimum, surface.begin);
    part.tMaximum = std::min(ray.tMaximum, surface.end);
    if (!(part.tMinimum <= part.tMaximum)) continue;
    const double isovalue = surface.isovalue + offset;
    const CubicHit found = firstHitOfField(source.grid, source.field, source.coefficients, source.blocks,
                                           isovalue, part, surface.hidden);
    if (!found.hit || (nearest && found.hit->t >= nearest->t)) continue;
    nearest = {found.hit->t, found.hit->voxel, found.hit->entering, found.certain, k};
  }
  return nearest;
}

// The largest |corner - isovalue| of the cell, data units; of the samples, of which coefficients are not far.
double spreadAbout(const HitSource& source, const glm::dvec3& voxel, double isovalue) {
  const Grid& grid = source.grid;
  const glm::ivec3 cell = grid.geometry().cellOf(voxel);
  const int apron = source.field == scene::Field::trilinear ? 0 : 1;
  double spread = 0.0;
  forEachIn(cell - apron, cell + apron + 2, [&](glm::ivec3 at) {
    const double value = grid.value(glm::clamp(at, glm::ivec3(0), grid.dims() - 1));
    if (std::isfinite(value)) spread = std::max(spread, std::abs(value - isovalue));
  });
  return spread;
}

// What texels and the isovalue are rounded in parts of, data units: the value less what is taken off before
// (value_scaling.h); of integers in texture units less the lowest that their type has.
double texelSize(const HitSource& source, double isovalue) {
  const Grid& grid = source.grid;
  const double slope = grid.slope(), stored = (isovalue - grid.intercept()) / slope;
  if (!std::holds_alternative<std::vector<float>>(grid.voxels()))
    return std::abs(slope) *
           (source.onProcessor ? std::abs(stored) : std::sqrt(2.0) * std::abs(stored - lowestStored(grid)));
  const double a = (grid.minimum() - grid.intercept()) / slope,
               b = (grid.maximum() - grid.intercept()) / slope;
  const ValueScaling scaling = scalingOf(std::min(a, b), std::max(a, b));
  return std::abs((stored - static_cast<double>(scaling.offset)) * slope);
}

// Whether a voxel is missing in a cell as near to the point as rounding is.
bool nearGap(const Grid& grid, const glm::dvec3& voxel, const glm::dvec3& reach) {
  if (grid.missingCount() == 0) return false;
  const glm::ivec3 low = grid.geometry().cellOf(voxel - reach),
                   high = grid.geometry().cellOf(voxel + reach) + 1;
  bool gap = false;
  forEachIn(low, high + 1, [&](glm::ivec3 at) { gap = gap || std::isnan(grid.stored(at)); });
  return gap;
}

// Whether the answers between the two crossings are one continuous way.
bool isOneCrossing(const FoundCrossing& at, const std::optional<FoundCrossing>& below,
                   const std::optional<FoundCrossing>& above, double expectedMm, double voxelsPerMm) {
  const auto alike = [&](const std::optional<FoundCrossing>& other) {
    return other && other->certain && other->entering == at.entering && other->surface == at.surface;
  };
  if (!at.certain || !alike(below) || !alike(above)) return false;
  const double width = std::abs(above->t - below->t);
  return width <= std::max(kContinuous * expectedMm, kNarrowVoxels / voxelsPerMm) &&
         width * voxelsPerMm <= kWideVoxels;
}

// What rounding makes of the field at the hit: `out` from its gradient to its randomPart.
void roundField(const HitSource& source, double isovalue, HitEnclosure& out) {
  out.gradient = sampleField(source.grid, source.field, source.coefficients, out.voxel).gradient;
  const double ofField = (source.field == scene::Field::trilinear ? kTrilinearRoundings : kCubicRoundings) *
                         spreadAbout(source, out.voxel, isovalue);
  const double ofValue = kFloatRounding * std::hypot(ofField, texelSize(source, isovalue));
  const double known = std::abs(glm::dot(out.gradient, out.rounding.shift));
  out.fieldError =
      known + kErrorLevel * std::hypot(glm::length(out.gradient * out.rounding.deviation), ofValue);
  out.randomPart = out.fieldError > 0.0 ? 1.0 - known / out.fieldError : 1.0;
}

}  // namespace

double lowestStored(const Grid& grid) {
  return grid.visit([](const auto& voxels) {
    using Stored = typename std::decay_t<decltype(voxels)>::value_type;
    return std::is_integral_v<Stored> ? static_cast<double>(std::numeric_limits<Stored>::lowest()) : 0.0;
  });
}

RayRounding rayRounding(const PictureRays& rays, glm::dvec2 fragment, const Ray& exact, double startMm,
                        double t, bool onProcessor) {
  const glm::dvec2 picture(rays.picture), half(rays.halfExtent);
  const glm::dvec2 ndc = fragment / picture * 2.0 - 1.0, plane = ndc * half;
  const glm::dvec3 right(rays.right), up(rays.up), forward(rays.forward), eye(rays.eye);
  const glm::dvec3 offset = plane.x * right + plane.y * up;
  const double length = rays.orthographic ? 1.0 : std::sqrt(1.0 + glm::dot(plane, plane));
  const double startDepth = rays.orthographic ? 0.0 : static_cast<double>(rays.startDepth);
  const glm::dvec3 origin = eye + (rays.orthographic ? 1.0 : startDepth) * offset;
  const glm::dvec3 direction = rays.orthographic ? forward : (forward + offset) / length;
  const double along = t - (rays.orthographic ? startMm : startDepth * length);
  const glm::dvec3 point = origin + along * direction;

  RayRounding out;
  out.shift = point - (exact.origin + t * exact.direction);
  // Of the place on the image plane: a division, a difference, a product.
  const glm::dvec2 ofPlane = half * half * ((ndc + 1.0) * (ndc + 1.0) + 2.0 * ndc * ndc);
  const glm::dvec3 ofOffset = squared(right) * ofPlane.x + squared(up) * ofPlane.y +
                              squared(plane.x * right) + squared(plane.y * up) + squared(offset);
  const double reach = rays.orthographic ? 1.0 : startDepth + along / length;
  glm::dvec3 sum = reach * reach * ofOffset + 2.0 * squared(point);
  if (rays.orthographic || startDepth != 0.0) sum += squared(origin);
  const glm::dvec3 ofProduct = squared(along * direction);
  if (!rays.orthographic) sum += squared(along / length * (forward + offset)) + ofProduct;
  if (!onProcessor) sum += ofProduct;
  out.deviation = kFloatRounding * glm::sqrt(sum);
  // Of unit length the direction is but for three roundings; t at the cell's ends, between them, and as
  // handed on.
  const double ofLength = rays.orthographic ? 0.0 : 3.0 * squared(along);
  out.depthDeviation = std::sqrt(squared(kFloatRounding) * (ofLength + 2.0 * squared(along) + squared(t)) +
                                 squared(kRootTolerance / glm::length(exact.direction)));
  return out;
}

HitEnclosure encloseHit(const HitSource& source, std::span<const RaySurface> surfaces,
                        const PictureRays& rays, glm::dvec2 fragment, const Ray& ray, double startMm,
                        double fieldErrorElsewhere) {
  HitEnclosure out;
  const auto at = nearestCrossing(source, surfaces, ray, 0.0);
  out.hit = at.has_value();
  if (!at) {
    out.fieldError = fieldErrorElsewhere;
    out.certain =
        !(fieldErrorElsewhere > 0.0) || (!nearestCrossing(source, surfaces, ray, -fieldErrorElsewhere) &&
                                         !nearestCrossing(source, surfaces, ray, fieldErrorElsewhere));
    return out;
  }
  const RaySurface& surface = surfaces[at->surface];
  out.t = out.first = out.last = at->t;
  out.voxel = at->voxel;
  out.isovalue = surface.isovalue;
  out.rounding = rayRounding(rays, fragment, ray, startMm, at->t, source.onProcessor);
  roundField(source, surface.isovalue, out);

  const double voxelsPerMm = glm::length(ray.direction);
  const double slope = std::abs(glm::dot(out.gradient, ray.direction));
  const auto below = nearestCrossing(source, surfaces, ray, -out.fieldError),
             above = nearestCrossing(source, surfaces, ray, out.fieldError);
  out.certain = isOneCrossing(*at, below, above, 2.0 * out.fieldError / slope, voxelsPerMm);
  for (const auto& end : {below, above}) {
    if (!end) continue;
    out.first = std::min(out.first, end->t);
    out.last = std::max(out.last, end->t);
  }
  const double back = -glm::dot(out.gradient, out.rounding.shift) / glm::dot(out.gradient, ray.direction);
  out.shifted =
      out.voxel + out.rounding.shift +
      std::clamp(std::isnan(back) ? 0.0 : back, out.first - out.t, out.last - out.t) * ray.direction;
  out.bound = std::max(out.t - out.first, out.last - out.t) + kErrorLevel * out.rounding.depthDeviation;
  const glm::dvec3 reach = glm::abs(out.rounding.shift) + kErrorLevel * out.rounding.deviation +
                           out.bound * glm::abs(ray.direction);
  // Where the surface is cut, and at a cut face, the ray's answer ends by a jump.
  const double end = std::min(surface.end, ray.tMaximum);
  if (out.t - out.bound < surface.begin || out.t + out.bound > end) out.certain = false;
  if (out.certain && nearGap(source.grid, out.voxel, reach)) out.certain = false;
  if (!out.certain) out.bound = std::numeric_limits<double>::infinity();
  return out;
}

}  // namespace isolux::volume
