#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace isolux::scene {

namespace {

constexpr double framingMargin = 1.04;

// Half of the picture that may be filled, at unit distance: across and up.
struct Opening {
  double across, up;
};

Opening openingOf(const Camera& camera, glm::dvec2 room) {
  const double fov = std::clamp(std::isfinite(camera.fov) ? camera.fov : 30.0, 1e-3, 179.0);
  const double unit = std::tan(glm::radians(fov) / 2.0) / framingMargin;
  const auto orOne = [](double v) { return std::isfinite(v) && v > 0.0 ? v : 1.0; };
  return {unit * orOne(room.x), unit * orOne(room.y)};
}

FramingDirections directionsFor(const Camera& camera, glm::dvec2 room) {
  const CameraFrame frame = frameOf(camera);
  const Opening opening = openingOf(camera, room);
  // Outward normals of the picture's four sides; those of parallel rays do not lean.
  const bool leans = frame.projection == Projection::perspective;
  const glm::dvec3 across = leans ? frame.back * opening.across : glm::dvec3(0.0);
  const glm::dvec3 up = leans ? frame.back * opening.up : glm::dvec3(0.0);
  return {frame.right + across, across - frame.right, frame.up + up, up - frame.up, frame.back, -frame.back};
}

Camera framedFor(const Camera& camera, glm::dvec2 room,
                 const std::array<double, framingDirectionCount>& farthest) {
  if (!std::all_of(farthest.begin(), farthest.end(), [](double v) { return std::isfinite(v); }))
    return camera;
  const auto [right, left, top, bottom, front, behind] = farthest;
  const CameraFrame frame = frameOf(camera);
  const Opening opening = openingOf(camera, room);
  const double middle = (front - behind) / 2.0;  // along back
  const glm::dvec3 target =
      frame.right * ((right - left) / 2.0) + frame.up * ((top - bottom) / 2.0) + frame.back * middle;
  const double halfDepth = (front + behind) / 2.0;
  double distance = std::max((right + left) / (2.0 * opening.across), (top + bottom) / (2.0 * opening.up));
  if (frame.projection == Projection::perspective) distance -= middle;  // that was the eye's place
  // In front of it all, and of rays that start at the eye's plane.
  distance = std::max(distance, halfDepth * framingMargin);
  return lookingAt(camera, frame, target, distance);
}

}  // namespace

FramingDirections framingDirections(const Camera& camera, double aspect) {
  return directionsFor(camera, {aspect, 1.0});
}

Camera framing(const Camera& camera, double aspect,
               const std::array<double, framingDirectionCount>& farthest) {
  return framedFor(camera, {aspect, 1.0}, farthest);
}

Camera framing(const Camera& camera, glm::dvec2 room, std::span<const glm::dvec3> pointsMm) {
  const FramingDirections directions = directionsFor(camera, room);
  std::array<double, framingDirectionCount> farthest{};
  farthest.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (const glm::dvec3& point : pointsMm)
      farthest[i] = std::max(farthest[i], glm::dot(directions[i], point));
  return framedFor(camera, room, farthest);
}

Camera framingBall(const Camera& camera, double aspect, glm::dvec3 centreMm, double radiusMm) {
  if (!std::isfinite(radiusMm) || !std::isfinite(glm::dot(centreMm, centreMm))) return camera;
  const CameraFrame frame = frameOf(camera);
  const Opening opening = openingOf(camera, {aspect, 1.0});
  const double tangent = std::min(opening.across, opening.up);
  const double distance = frame.projection == Projection::perspective
                              ? radiusMm * std::sqrt(1.0 + 1.0 / (tangent * tangent))
                              : std::max(radiusMm / tangent, radiusMm * framingMargin);
  return lookingAt(camera, frame, centreMm, distance);
}

Camera fittedTo(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm, glm::dvec2 room) {
  if (!(room.x > 0.0 && room.y > 0.0) || !camera.eye || !camera.target) return camera;
  const Camera fit = fitted(camera, boundsMinMm, boundsMaxMm);
  const CameraFrame frame = frameOf(camera);
  const double roundings = 1e-9 * frame.distance;
  if (!(glm::distance(*camera.target, *fit.target) <= roundings &&
        glm::distance(*camera.eye, *fit.eye) <= roundings))
    return camera;
  const glm::dvec2 tangents = room * std::tan(glm::radians(std::clamp(camera.fov, 1e-3, 179.0)) / 2.0);
  double distance = frame.distance;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 d =
        glm::dvec3(corner & 1 ? boundsMaxMm.x : boundsMinMm.x, corner & 2 ? boundsMaxMm.y : boundsMinMm.y,
                   corner & 4 ? boundsMaxMm.z : boundsMinMm.z) -
        *fit.target;
    const double toward = frame.projection == Projection::perspective ? glm::dot(d, frame.back) : 0.0;
    distance = std::max({distance, toward + std::abs(glm::dot(d, frame.right)) / tangents.x,
                         toward + std::abs(glm::dot(d, frame.up)) / tangents.y});
  }
  return distance > frame.distance ? lookingAt(camera, frame, *fit.target, distance) : camera;
}

}  // namespace isolux::scene
