#include "volume/measure/thickness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "volume/hit/exact_hit.h"

namespace isolux::volume {

namespace {

constexpr double kLeastCosine = 0.05;  // of a ray with the surface it leaves through
constexpr int kRefinements = 12, kTolerancePasses = 4;

// What a ball may cut into the surface without being smaller for it: ripples, and what a doubtful normal
// makes of points that lie to the side.
struct Tolerance {
  double mm = 0.0, angle = 0.0;
};

constexpr double kMostDoubt = 0.3;

// The spline's normal is off by the change of h^2 f'' / 6 along the surface, ripples being h^2 f'' / 8. Where
// the surface bends as much across the thickest slices, ripples are larger than here.
Tolerance toleranceAt(const SurfacePoint& point, double thickestMm) {
  double squares = 0.0;
  for (int i = 0; i < 3; ++i) squares += glm::dot(point.shape[i], point.shape[i]);
  const double bend = std::min(std::sqrt(squares), 1.0 / thickestMm);
  const double ripple = std::max(point.rippleMm, bend * thickestMm * thickestMm / 8.0);
  return {ripple + 2.0 * point.noiseMm, std::min(kMostDoubt, 8.0 / 6.0 * ripple * bend)};
}

// The ball through p with its centre against the normal that q lies on.
struct Ball {
  double radius = std::numeric_limits<double>::infinity();
  double doubt = 0.0;  // of the radius, by that of the normal
};

Ball ballTouching(const SurfacePoint& p, glm::dvec3 q, const Tolerance& tolerance) {
  const glm::dvec3 off = p.world - q;
  const double squared = glm::dot(off, off), along = glm::dot(off, p.normal);
  const double aside = tolerance.angle * std::sqrt(std::max(squared - along * along, 0.0));
  const double deep = along - tolerance.mm - aside;
  if (!(deep > 0.0)) return {};
  const double radius = (squared - tolerance.mm * tolerance.mm) / (2.0 * deep);
  return {radius, radius * aside / deep};
}

struct Touch {
  Ball ball;
  glm::dvec3 at{0.0};
};

// The smallest ball of all that touch a corner of the graph.
Touch smallestTouch(const SurfaceGraph& graph, const SurfacePoint& point, const Tolerance& tolerance) {
  Touch touch;
  for (const glm::dvec3& q : graph.points) {
    const Ball ball = ballTouching(point, q, tolerance);
    if (ball.radius < touch.ball.radius) touch = {ball, q};
  }
  return touch;
}

}  // namespace

std::optional<ThicknessByRay> thicknessByRay(const SurfaceOf& surface, const MinMaxBlocks& blocks,
                                             const SurfacePoint& point) {
  const glm::dmat4 voxelFromWorld = surface.grid.geometry().voxelFromWorld();
  const glm::dvec3 direction(voxelFromWorld * glm::dvec4(-point.normal, 0.0));
  const bool above = surface.inside == scene::Inside::above;
  double from = 1e-6 * surface.grid.geometry().voxelMm();
  for (int crossing = 0; crossing < 3; ++crossing) {  // a point just outside is entered first
    const auto hit = firstHit(surface.grid, blocks, surface.isovalue, {point.voxel, direction, from});
    if (!hit) return std::nullopt;
    from = hit->t * (1.0 + 1e-12) + 1e-12;
    if (hit->entering == above) continue;
    ThicknessByRay result;
    result.exit = point.world - point.normal * hit->t;
    const auto exit = surfacePoint(surface, result.exit);
    if (!exit) return std::nullopt;
    const double cosine = std::max(-glm::dot(point.normal, exit->normal), kLeastCosine);
    const double turned = 1.0 - std::min(glm::dot(point.normal, point.facet), 1.0);  // doubt of the direction
    result.mm = {hit->t, offsetError(point) + offsetError(*exit) / cosine + hit->t * turned};
    return result;
  }
  return std::nullopt;
}

std::optional<InscribedBall> inscribedBall(const SurfaceOf& surface, const SurfaceGraph& graph,
                                           const SurfacePoint& point) {
  const GridGeometry& geometry = surface.grid.geometry();
  const double voxel = geometry.voxelMm(), thickest = geometry.mostSpacingMm();
  Tolerance tolerance = toleranceAt(point, thickest);
  Ball found;
  std::optional<SurfacePoint> touched;
  for (int pass = 0; pass < kTolerancePasses;
       ++pass) {  // where slices are thick, ripples are larger elsewhere
    const Touch touch = smallestTouch(graph, point, tolerance);
    touched = surfacePoint(surface, touch.at);
    found = touch.ball;
    if (!(found.radius < std::numeric_limits<double>::infinity()) || !touched) return std::nullopt;
    const Tolerance there = toleranceAt(*touched, thickest);
    if (there.mm <= tolerance.mm && there.angle <= tolerance.angle) break;
    tolerance = {std::max(there.mm, tolerance.mm), std::max(there.angle, tolerance.angle)};
  }
  for (int i = 0; i < kRefinements; ++i) {
    const SurfacePoint closer =
        slideNearest(surface, point.world - found.radius * point.normal, *touched, 4.0 * voxel, kRefinements);
    const Ball refined = ballTouching(point, closer.world, tolerance);
    if (!(refined.radius < found.radius)) break;
    const bool settled = found.radius - refined.radius < 1e-9 * found.radius;
    found = refined;
    touched = closer;
    if (settled) break;
  }
  // What touches straight across lies `tolerance` deep: half of that in the radius.
  InscribedBall ball;
  ball.diameterMm.value = std::max(2.0 * found.radius - tolerance.mm, 0.0);
  ball.diameterMm.error = 1.2 * (tolerance.mm + found.doubt) + offsetError(point) + offsetError(*touched);
  ball.centre = point.world - 0.5 * ball.diameterMm.value * point.normal;
  ball.touches = touched->world;
  if (!geometry.holds(geometry.voxelOf(ball.centre))) return std::nullopt;
  return ball;
}

}  // namespace isolux::volume
