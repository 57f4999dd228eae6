#include "app/view_math/turning.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>

namespace isolux::app {

namespace {

glm::dquat quaternionOf(const glm::dvec4& wxyz) {
  const double length = glm::length(wxyz);
  if (!(length > 0.0) || !std::isfinite(length)) return {1.0, 0.0, 0.0, 0.0};
  return {wxyz.x / length, wxyz.y / length, wxyz.z / length, wxyz.w / length};
}

glm::dvec4 wxyzOf(const glm::dquat& q) {
  glm::dvec4 wxyz(q.w, q.x, q.y, q.z);
  wxyz /= glm::length(wxyz);
  for (int i = 0; i < 4; ++i)  // quarter turns are exact
    if (std::abs(wxyz[i]) < 1e-15) wxyz[i] = 0.0;
  return wxyz;
}

glm::dquat attitudeOf(const scene::CameraFrame& frame) {
  return glm::quat_cast(glm::dmat3(frame.right, frame.up, frame.back));
}

glm::dquat about(const glm::dvec3& axis, double degrees) {
  return glm::angleAxis(glm::radians(degrees), axis);
}

constexpr glm::dvec3 axisX{1.0, 0.0, 0.0}, axisY{0.0, 1.0, 0.0}, axisZ{0.0, 0.0, 1.0};

// -180 reads as 180, and noise of the last digits as 0.
double tidy(double degrees) {
  const double rounded = std::round(degrees * 1e9) / 1e9;
  if (rounded <= -180.0) return rounded + 360.0;
  return rounded == 0.0 ? 0.0 : rounded;
}

glm::dvec3 onBall(glm::dvec2 p) {
  const double r2 = glm::dot(p, p);
  const double z = r2 <= 0.5 ? std::sqrt(1.0 - r2) : 0.5 / std::sqrt(r2);
  return glm::normalize(glm::dvec3(p, z));
}

}  // namespace

TurnAngles anglesOf(const glm::dvec4& rotation) {
  const glm::dquat q = quaternionOf(rotation);
  const glm::dvec3 middle = q * axisY;
  TurnAngles angles;
  angles.elevation = glm::degrees(std::asin(std::clamp(middle.z, -1.0, 1.0)));
  if (std::hypot(middle.x, middle.y) < 1e-9) {  // heading and roll turn about the same axis
    const glm::dvec3 right = q * axisX;
    angles.heading = glm::degrees(std::atan2(right.y, right.x));
  } else {
    angles.heading = glm::degrees(std::atan2(-middle.x, middle.y));
    const glm::dquat rest = about(axisX, -angles.elevation) * about(axisZ, -angles.heading) * q;
    const glm::dvec3 right = rest * axisX;
    angles.roll = glm::degrees(std::atan2(-right.z, right.x));
  }
  return {tidy(angles.heading), tidy(angles.elevation), tidy(angles.roll)};
}

glm::dvec4 rotationOf(const TurnAngles& angles) {
  return wxyzOf(about(axisZ, angles.heading) * about(axisX, angles.elevation) * about(axisY, angles.roll));
}

glm::dvec4 turnedByDrag(const glm::dvec4& rotation, const scene::CameraFrame& frame, glm::dvec2 from,
                        glm::dvec2 to) {
  const auto toWorld = [&](const glm::dvec3& v) {
    return frame.right * v.x + frame.up * v.y + frame.back * v.z;
  };
  const glm::dvec3 a = toWorld(onBall(from)), b = toWorld(onBall(to));
  // The rotation from a to b: (1 + a.b, a x b), normalised; the two are never opposite on one half of a ball.
  const glm::dvec3 axis = glm::cross(a, b);
  const glm::dquat turn = glm::normalize(glm::dquat(1.0 + glm::dot(a, b), axis.x, axis.y, axis.z));
  return wxyzOf(turn * quaternionOf(rotation));
}

glm::dvec3 rotated(const glm::dvec4& rotation, glm::dvec3 v) {
  return quaternionOf(rotation) * v;
}

glm::dvec3 rotatedBack(const glm::dvec4& rotation, glm::dvec3 v) {
  return glm::conjugate(quaternionOf(rotation)) * v;
}

scene::Camera cameraBetween(const scene::Camera& from, const scene::Camera& to, double part) {
  if (part >= 1.0 || !from.eye || !to.eye) return to;
  const scene::CameraFrame first = frameOf(from), second = frameOf(to);
  const double t = std::max(0.0, part);
  const glm::dmat3 attitude = glm::mat3_cast(glm::slerp(attitudeOf(first), attitudeOf(second), t));
  const glm::dvec3 targetFrom = first.eye - first.distance * first.back,
                   targetTo = second.eye - second.distance * second.back,
                   target = targetFrom + t * (targetTo - targetFrom);
  const double distance = first.distance * std::pow(second.distance / first.distance, t);
  scene::Camera between = to;
  between.target = target;
  between.eye = target + distance * attitude[2];
  between.up = attitude[1];
  return between;
}

double easedPart(double partOfTime) {
  const double t = std::clamp(partOfTime, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace isolux::app
