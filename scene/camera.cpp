#include "scene/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace isolux::scene {

namespace {

constexpr double reachMm = 1e13;  // the range of camera.eye and camera.target
// Eye to target. Files have voxels of 1e-9 to 1e9 mm; nearer than this part of the target's coordinates,
// roundings turn the view.
constexpr double nearestMm = 1e-12, farthestMm = reachMm / 2, nearestOfTarget = 1e-9;
constexpr double fitMargin = 1.04;  // air around a fitted box
constexpr glm::dvec3 anterior{0.0, -1.0, 0.0}, superior{0.0, 0.0, 1.0};

double finiteOr(double value, double otherwise) {
  return std::isfinite(value) ? value : otherwise;
}

glm::dvec3 finitePoint(glm::dvec3 p) {
  for (int i = 0; i < 3; ++i) p[i] = std::clamp(finiteOr(p[i], 0.0), -reachMm, reachMm);
  return p;
}

// The unit vector along v, by way of its largest component so that no length over- or underflows; zero when
// v has no direction.
glm::dvec3 unitOrZero(glm::dvec3 v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0) || !std::isfinite(largest)) return glm::dvec3(0.0);
  return glm::normalize(v / largest);
}

double halfAngleTangent(double fovDegrees) {
  const double fov = std::clamp(finiteOr(fovDegrees, 30.0), 1e-3, 179.0);
  return std::tan(glm::radians(fov) / 2.0);
}

glm::dvec3 targetOf(const CameraFrame& frame) {
  return frame.eye - frame.back * frame.distance;
}

// The smallest distance from `target` at which all corners of the box are inside a square picture.
double fittingDistance(const CameraFrame& frame, glm::dvec3 target, double tangent, glm::dvec3 low,
                       glm::dvec3 high) {
  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p{corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z};
    const glm::dvec3 d = p - target;
    const double side =
        std::max(std::abs(glm::dot(d, frame.right)), std::abs(glm::dot(d, frame.up))) * fitMargin;
    const double toward = glm::dot(d, frame.back);
    distance = std::max(distance, frame.projection == Projection::perspective
                                      ? toward + side / tangent
                                      : std::max(side / tangent, toward * fitMargin));
  }
  return distance > 0.0 ? distance : 1.0;
}

// From the volume to the viewer.
glm::dvec3 sideOf(StandardView view, WorldAxes axes) {
  const glm::dvec3 front = frontOf(axes), up = upOf(axes), left(1.0, 0.0, 0.0), right(-1.0, 0.0, 0.0);
  const std::array<glm::dvec3, standardViewCount> sides{front, -front, left, right, up, -up};
  return sides[static_cast<std::size_t>(view)];
}

}  // namespace

Camera lookingAt(Camera camera, const CameraFrame& frame, glm::dvec3 target, double distance) {
  camera.target = finitePoint(target);
  const glm::dvec3 far = glm::abs(*camera.target);
  const double nearest = std::max(nearestMm, nearestOfTarget * std::max({far.x, far.y, far.z}));
  camera.eye = finitePoint(*camera.target + frame.back * std::clamp(distance, nearest, farthestMm));
  camera.up = frame.up;
  return camera;
}

CameraFrame frameOf(const Camera& camera) {
  CameraFrame frame{};
  frame.projection = camera.projection;
  const glm::dvec3 target = finitePoint(camera.target.value_or(glm::dvec3(0.0)));
  frame.eye = finitePoint(camera.eye.value_or(target + anterior));
  frame.back = unitOrZero(frame.eye - target);
  frame.distance = glm::length(frame.eye - target);
  if (frame.back == glm::dvec3(0.0)) {  // the eye is on the target: look from the front, as if 1 mm away
    frame.back = anterior;
    frame.distance = 1.0;
  }
  // The first of the wanted up, superior and anterior that is not along the view direction.
  for (const glm::dvec3& wanted : {unitOrZero(camera.up.value_or(superior)), superior, anterior}) {
    const glm::dvec3 right = glm::cross(wanted, frame.back);
    if (glm::length(right) < 1e-6) continue;
    frame.right = glm::normalize(right);
    break;
  }
  frame.up = glm::normalize(glm::cross(frame.back, frame.right));
  frame.halfHeight = halfAngleTangent(camera.fov);
  if (frame.projection == Projection::orthographic) frame.halfHeight *= frame.distance;
  return frame;
}

Ray rayThrough(const CameraFrame& frame, glm::dvec2 ndc, double aspect) {
  const glm::dvec3 offset =
      frame.right * (ndc.x * frame.halfHeight * aspect) + frame.up * (ndc.y * frame.halfHeight);
  if (frame.projection == Projection::orthographic) return {frame.eye + offset, -frame.back};
  return {frame.eye, glm::normalize(offset - frame.back)};
}

Camera orbited(const Camera& camera, double yaw, double pitch) {
  if (!std::isfinite(yaw) || !std::isfinite(pitch)) return camera;
  const CameraFrame frame = frameOf(camera);
  // Yaw about up moves `back` toward `right`, then pitch moves it toward `up`.
  const glm::dvec3 yawed = frame.back * std::cos(yaw) + frame.right * std::sin(yaw);
  CameraFrame turned = frame;
  turned.back = glm::normalize(yawed * std::cos(pitch) + frame.up * std::sin(pitch));
  turned.up = glm::normalize(frame.up * std::cos(pitch) - yawed * std::sin(pitch));
  return lookingAt(camera, turned, targetOf(frame), frame.distance);
}

Camera rolled(const Camera& camera, double angle) {
  if (!std::isfinite(angle)) return camera;
  const CameraFrame frame = frameOf(camera);
  CameraFrame turned = frame;  // the picture turns clockwise when up leans to the left
  turned.up = glm::normalize(frame.up * std::cos(angle) - frame.right * std::sin(angle));
  return lookingAt(camera, turned, targetOf(frame), frame.distance);
}

Camera panned(const Camera& camera, glm::dvec2 fractionOfHeight) {
  if (!std::isfinite(fractionOfHeight.x) || !std::isfinite(fractionOfHeight.y)) return camera;
  const CameraFrame frame = frameOf(camera);
  const double heightMm =
      2.0 * frame.halfHeight * (frame.projection == Projection::perspective ? frame.distance : 1.0);
  const glm::dvec3 shift = (frame.right * fractionOfHeight.x + frame.up * fractionOfHeight.y) * heightMm;
  return lookingAt(camera, frame, targetOf(frame) - shift, frame.distance);
}

Camera zoomed(const Camera& camera, double factor) {
  if (!std::isfinite(factor) || factor <= 0.0) return camera;
  const CameraFrame frame = frameOf(camera);
  return lookingAt(camera, frame, targetOf(frame), frame.distance / factor);
}

std::string standardViewMark(StandardView view, WorldAxes axes) {
  return axisEnd(axes, sideOf(view, axes));
}

std::string standardViewName(StandardView view, WorldAxes axes) {
  constexpr std::array<const char*, standardViewCount> names{"Anterior", "Posterior", "Left",
                                                             "Right",    "Superior",  "Inferior"};
  return axes == WorldAxes::anatomical ? names[static_cast<std::size_t>(view)] : standardViewMark(view, axes);
}

Camera standardView(const Camera& camera, StandardView view, WorldAxes axes, glm::dvec3 boundsMinMm,
                    glm::dvec3 boundsMaxMm) {
  Camera from = camera;
  from.target = glm::dvec3(0.0);
  from.eye = sideOf(view, axes);
  from.up = upOf(axes);
  if (view == StandardView::superior)
    from.up = axes == WorldAxes::anatomical ? frontOf(axes) : -frontOf(axes);
  if (view == StandardView::inferior) from.up = frontOf(axes);
  return fitted(from, boundsMinMm, boundsMaxMm);
}

Camera fitted(const Camera& camera, glm::dvec3 boundsMinMm, glm::dvec3 boundsMaxMm) {
  const CameraFrame frame = frameOf(camera);
  const glm::dvec3 low = finitePoint(boundsMinMm), high = finitePoint(boundsMaxMm);
  const glm::dvec3 target = (low + high) / 2.0;
  return lookingAt(camera, frame, target,
                   fittingDistance(frame, target, halfAngleTangent(camera.fov), low, high));
}

EdgeLetters edgeLetters(const CameraFrame& frame, WorldAxes axesOfWorld) {
  const auto letters = [axesOfWorld](glm::dvec3 direction) {
    std::array<int, 3> axes{0, 1, 2};
    std::ranges::stable_sort(axes,
                             [&](int a, int b) { return std::abs(direction[a]) > std::abs(direction[b]); });
    const auto letter = [&](int axis) { return axisEnd(axesOfWorld, axis, direction[axis] > 0.0); };
    std::string text = letter(axes[0]);
    constexpr double tangentOf22Degrees = 0.41421356237309503;  // halfway between one side and a corner
    if (std::abs(direction[axes[1]]) > tangentOf22Degrees * std::abs(direction[axes[0]]))
      text += letter(axes[1]);
    return text;
  };
  return {letters(-frame.right), letters(frame.right), letters(frame.up), letters(-frame.up)};
}

}  // namespace isolux::scene
