#include "volume/phantom/phantom_shapes.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

float segmentParameter(const Shape& shape, glm::vec3 p) {
  const glm::vec3 axis = shape.b - shape.a;
  const float square = glm::dot(axis, axis);
  return square > 0.0f ? std::clamp(glm::dot(p - shape.a, axis) / square, 0.0f, 1.0f) : 0.0f;
}

}  // namespace

float smoothMinimum(float a, float b, float k) {
  if (k <= 0.0f) return std::min(a, b);
  const float h = std::max(k - std::abs(a - b), 0.0f) / k;
  return std::min(a, b) - h * h * h * k * (1.0f / 6.0f);
}

Solid& Solid::add(glm::vec3 centre, glm::vec3 radii, float blend) {
  shapes_.push_back({centre, centre, radii, radii, blend, false, false});
  return *this;
}
Solid& Solid::addLimb(glm::vec3 a, glm::vec3 b, glm::vec3 radiiA, glm::vec3 radiiB, float blend) {
  shapes_.push_back({a, b, radiiA, radiiB, blend, false, false});
  return *this;
}
Solid& Solid::remove(glm::vec3 centre, glm::vec3 radii, float blend) {
  shapes_.push_back({centre, centre, radii, radii, blend, true, false});
  return *this;
}
Solid& Solid::removeLimb(glm::vec3 a, glm::vec3 b, glm::vec3 radiiA, glm::vec3 radiiB, float blend) {
  shapes_.push_back({a, b, radiiA, radiiB, blend, true, false});
  return *this;
}
Solid& Solid::addPair(glm::vec3 centre, glm::vec3 radii, float blend) {
  shapes_.push_back({centre, centre, radii, radii, blend, false, true});
  return *this;
}
Solid& Solid::addLimbs(glm::vec3 a, glm::vec3 b, glm::vec3 radiiA, glm::vec3 radiiB, float blend) {
  shapes_.push_back({a, b, radiiA, radiiB, blend, false, true});
  return *this;
}
Solid& Solid::removePair(glm::vec3 centre, glm::vec3 radii, float blend) {
  shapes_.push_back({centre, centre, radii, radii, blend, true, true});
  return *this;
}
Solid& Solid::removeLimbs(glm::vec3 a, glm::vec3 b, glm::vec3 radiiA, glm::vec3 radiiB, float blend) {
  shapes_.push_back({a, b, radiiA, radiiB, blend, true, true});
  return *this;
}

void Solid::select(glm::vec3 centre, float reach, float margin, std::vector<const Shape*>& out) const {
  out.clear();
  for (const Shape& shape : shapes_) {
    glm::vec3 p = centre;
    if (shape.mirrored) p.x = std::abs(p.x);
    const float t = segmentParameter(shape, p);
    const glm::vec3 r = glm::max(shape.radiiA, shape.radiiB);
    const float bound = std::max({r.x, r.y, r.z});
    const float distance = glm::length(p - glm::mix(shape.a, shape.b, t)) - bound;
    if (distance <= reach + margin + shape.blend) out.push_back(&shape);
  }
  // Nothing can be taken away from nothing.
  std::size_t first = 0;
  while (first < out.size() && out[first]->remove) ++first;
  out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(first));
}

}  // namespace isolux::volume
