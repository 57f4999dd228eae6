#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace isolux::scene {

namespace {

constexpr double framingMargin = 1.04;

// What may be filled, at unit distance: its middle, and half its size less the margin.
struct Opening {
  glm::dvec2 middle{0.0};
  double across, up;
};

double tangentOf(const Camera& camera) {
  const double fov = std::clamp(std::isfinite(camera.fov) ? camera.fov : 30.0, 1e-3, 179.0);
  return std::tan(glm::radians(fov) / 2.0);
}

glm::dvec2 halfOf(const Room& room) {
  return 0.5 * (room.high - room.low);
}

bool isUsable(const Room& room) {
  const glm::dvec2 half = halfOf(room);
  return half.x > 0.0 && half.y > 0.0 && std::isfinite(half.x + half.y);
}

Opening openingOf(const Camera& camera, const Room& room) {
  const double tangent = tangentOf(camera), unit = tangent / framingMargin;
  if (!isUsable(room)) return {{0.0, 0.0}, unit, unit};
  const glm::dvec2 half = halfOf(room);
  return {0.5 * (room.low + room.high) * tangent, unit * half.x, unit * half.y};
}

// Outward normals of the room's four sides; those of parallel rays do not lean.
std::array<glm::dvec3, framingDirectionCount> directionsOf(const CameraFrame& frame, const Opening& opening) {
  const auto leaning = [&](double side) {
    return frame.projection == Projection::perspective ? frame.back * side : glm::dvec3(0.0);
  };
  const glm::dvec2 middle = opening.middle;
  return {frame.right + leaning(opening.across + middle.x),
          leaning(opening.across - middle.x) - frame.right,
          frame.up + leaning(opening.up + middle.y),
          leaning(opening.up - middle.y) - frame.up,
          frame.back,
          -frame.back};
}

Camera framedFor(const Camera& camera, const CameraFrame& frame, const Opening& opening,
                 std::span<const double> farthest) {
  const double right = farthest[0], left = farthest[1], top = farthest[2], bottom = farthest[3],
               front = farthest[4], behind = farthest[5];
  const bool perspective = frame.projection == Projection::perspective;
  const double middle = (front - behind) / 2.0;  // along back
  const double halfDepth = (front + behind) / 2.0;
  double distance = std::max((right + left) / (2.0 * opening.across), (top + bottom) / (2.0 * opening.up));
  if (perspective) distance -= middle;  // that was the eye's place
  // In front of it all, and of rays that start at the eye's plane.
  distance = std::max(distance, halfDepth * framingMargin);
  const glm::dvec2 shift = opening.middle * (perspective ? distance + middle : distance);
  const glm::dvec3 target = frame.right * ((right - left) / 2.0 - shift.x) +
                            frame.up * ((top - bottom) / 2.0 - shift.y) + frame.back * middle;
  return lookingAt(camera, frame, target, distance);
}

bool isCentral(const Room& room) {
  return glm::distance(room.high, -room.low) <= 1e-9 * glm::length(room.high - room.low);
}

}  // namespace

Rooms wholePicture(double aspect) {
  return {{{-aspect, -1.0}, {aspect, 1.0}}};
}

std::vector<glm::dvec3> framingDirections(const Camera& camera, const Rooms& rooms) {
  const CameraFrame frame = frameOf(camera);
  std::vector<glm::dvec3> all;
  for (const Room& room : rooms)
    for (const glm::dvec3& direction : directionsOf(frame, openingOf(camera, room))) all.push_back(direction);
  return all;
}

Camera framing(const Camera& camera, const Rooms& rooms, std::span<const double> farthest) {
  constexpr double alike = 1.02;
  if (!std::ranges::all_of(farthest, [](double v) { return std::isfinite(v); })) return camera;
  const CameraFrame frame = frameOf(camera);
  std::vector<Camera> all;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    all.push_back(framedFor(camera, frame, openingOf(camera, rooms[i]),
                            farthest.subspan(i * framingDirectionCount, framingDirectionCount)));
    nearest = std::min(nearest, frameOf(all.back()).distance);
  }
  const auto best = std::ranges::find_if(
      all, [&](const Camera& framed) { return frameOf(framed).distance <= alike * nearest; });
  return best == all.end() ? camera : *best;
}

Camera framing(const Camera& camera, const Rooms& rooms, std::span<const glm::dvec3> pointsMm) {
  std::vector<double> farthest;
  for (const glm::dvec3& direction : framingDirections(camera, rooms)) {
    double most = -std::numeric_limits<double>::infinity();
    for (const glm::dvec3& point : pointsMm) most = std::max(most, glm::dot(direction, point));
    farthest.push_back(most);
  }
  return framing(camera, rooms, farthest);
}

Camera framingBall(const Camera& camera, const Rooms& rooms, glm::dvec3 centreMm, double radiusMm) {
  if (!std::isfinite(radiusMm) || !std::isfinite(glm::dot(centreMm, centreMm))) return camera;
  const CameraFrame frame = frameOf(camera);
  double tangent = 0.0;
  for (const Room& room : rooms) {
    const glm::dvec2 half = glm::min(room.high, -room.low);
    const Opening opening = openingOf(camera, {-half, half});
    tangent = std::max(tangent, std::min(opening.across, opening.up));
  }
  const double distance = frame.projection == Projection::perspective
                              ? radiusMm * std::sqrt(1.0 + 1.0 / (tangent * tangent))
                              : std::max(radiusMm / tangent, radiusMm * framingMargin);
  return lookingAt(camera, frame, centreMm, distance);
}

std::array<glm::dvec3, 8> cornersOf(glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm) {
  std::array<glm::dvec3, 8> corners{};
  for (unsigned i = 0; i < corners.size(); ++i)
    corners[i] = {i & 1U ? boundsMaxMm.x : boundsMinMm.x, i & 2U ? boundsMaxMm.y : boundsMinMm.y,
                  i & 4U ? boundsMaxMm.z : boundsMinMm.z};
  return corners;
}

Camera fittedTo(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm,
                const std::function<Rooms()>& roomsOf) {
  if (!camera.eye || !camera.target) return camera;
  const Camera fit = fitted(camera, boundsMinMm, boundsMaxMm);
  const CameraFrame frame = frameOf(camera);
  const double roundings = 1e-9 * frame.distance;
  if (!(glm::distance(*camera.target, *fit.target) <= roundings &&
        glm::distance(*camera.eye, *fit.eye) <= roundings))
    return camera;
  const Rooms rooms = roomsOf();
  if (!std::ranges::all_of(rooms, isUsable)) return camera;
  const std::array<glm::dvec3, 8> corners = cornersOf(boundsMinMm, boundsMaxMm);
  if (rooms.size() != 1 || !isCentral(rooms.front())) return framing(camera, rooms, corners);
  const glm::dvec2 tangents = halfOf(rooms.front()) * tangentOf(camera);
  double distance = frame.distance;
  for (const glm::dvec3& corner : corners) {
    const glm::dvec3 d = corner - *fit.target;
    const double toward = frame.projection == Projection::perspective ? glm::dot(d, frame.back) : 0.0;
    distance = std::max({distance, toward + std::abs(glm::dot(d, frame.right)) / tangents.x,
                         toward + std::abs(glm::dot(d, frame.up)) / tangents.y});
  }
  return distance > frame.distance ? lookingAt(camera, frame, *fit.target, distance) : camera;
}

}  // namespace isolux::scene
