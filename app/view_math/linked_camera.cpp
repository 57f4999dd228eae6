#include "app/view_math/linked_camera.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isolux::app {

namespace {

glm::dvec3 middleOf(const scene::VolumeFacts& facts) {
  return 0.5 * (facts.boundsMinMm + facts.boundsMaxMm);
}

bool holds(const scene::VolumeFacts& facts, glm::dvec3 pointMm) {
  return glm::clamp(pointMm, facts.boundsMinMm, facts.boundsMaxMm) == pointMm;
}

}  // namespace

scene::Camera linkedCamera(scene::Camera camera, const scene::VolumeFacts& first,
                           const scene::VolumeFacts& second) {
  if (!camera.eye || !camera.target) return camera;
  const bool anatomical =
      first.axes == scene::WorldAxes::anatomical && second.axes == scene::WorldAxes::anatomical;
  const glm::dvec3 from = middleOf(first), to = middleOf(second);
  if (anatomical && holds(first, to) && holds(second, from)) return camera;
  double scale = 1.0;
  if (!anatomical) {
    const double one = glm::length(first.boundsMaxMm - first.boundsMinMm);
    const double other = glm::length(second.boundsMaxMm - second.boundsMinMm);
    if (one > 0.0 && other > 0.0) scale = other / one;
  }
  camera.eye = to + scale * (*camera.eye - from);
  camera.target = to + scale * (*camera.target - from);
  return camera;
}

}  // namespace isolux::app
