#include "app/interaction/camera_turn.h"

#include <algorithm>
#include <cmath>

#include <glm/ext/quaternion_double.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace isolux::app {

namespace {

glm::dquat attitudeOf(const scene::CameraFrame& frame) {
  return glm::quat_cast(glm::dmat3(frame.right, frame.up, frame.back));
}

}  // namespace

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
