#include "tests/support/rays.h"

#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/random.h"

namespace isolux::test {

using base::counterHash;
using base::uniformNoise;

glm::dvec3 randomVector(std::uint64_t i, std::uint64_t stream) {
  return {uniformNoise(stream, 3 * i), uniformNoise(stream, 3 * i + 1), uniformNoise(stream, 3 * i + 2)};
}

glm::dvec3 randomPoint(std::uint64_t i, glm::dvec3 low, glm::dvec3 high) {
  return glm::mix(low, high, glm::dvec3(uniformNoise(11, i), uniformNoise(12, i), uniformNoise(13, i)));
}

volume::Ray randomRay(std::uint64_t i, glm::ivec3 dims) {
  const glm::dvec3 size(dims - 1);
  glm::dvec3 target = randomVector(i, 1) * size;
  const glm::dvec3 outside =
      size * 0.5 + (glm::normalize(randomVector(i, 2) - 0.5)) * (2.0 * glm::length(size));
  const auto axis = static_cast<int>(counterHash(5, i) % 3);
  volume::Ray ray;
  glm::dvec3 &o = ray.origin, &d = ray.direction;
  switch (i % 8) {
    case 0:
    case 1:
      o = outside, d = glm::normalize(target - outside);
      break;
    case 2:
      o = target, d = randomVector(i, 3) - 0.5;
      break;
    case 3:  // along an axis
      o = target, d = glm::dvec3(0.0);
      o[axis] = i & 8 ? -5.0 : size[axis] + 5.0;
      d[axis] = i & 8 ? 1.0 : -0.25;
      break;
    case 4:  // along an axis, on voxel planes: through the samples
      o = glm::round(target), d = glm::dvec3(0.0);
      o[axis] = i & 8 ? 0.0 : size[axis];
      d[axis] = i & 8 ? 2.0 : -1.0;
      break;
    case 5:  // from one corner to another
      o = glm::round(target), d = glm::round(randomVector(i, 4) * size) - o;
      if (d == glm::dvec3(0.0)) d.x = 1.0;
      break;
    case 6:  // diagonal through cell corners
      o = glm::round(target), d = glm::dvec3(i & 8 ? 1 : -1, i & 16 ? 1 : -1, i & 32 ? 1 : -1);
      break;
    default:  // in a plane of voxels
      o = outside, d = target - outside;
      o[axis] = target[axis] = std::round(target[axis]);
      d[axis] = 0.0;
  }
  return ray;
}

volume::Ray grazingRay(std::uint64_t i, glm::dvec3 point, glm::dvec3 normal) {
  volume::Ray ray;
  const double most = std::pow(10.0, -1.7 - static_cast<double>(i % 6));
  const double off = (uniformNoise(4, i) - 0.5) * most, tilt = (uniformNoise(5, i) - 0.5) * most;
  ray.direction = glm::normalize(glm::cross(normal, randomVector(i, 2) - 0.5)) + normal * tilt;
  ray.origin = point + normal * off - ray.direction * 60.0;
  return ray;
}

}  // namespace isolux::test
