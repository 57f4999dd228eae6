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
