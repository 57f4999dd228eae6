#include "scene/curvature_map.h"

#include <cassert>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isolux::scene {

glm::dvec3 curvatureColor(std::span<const CurvaturePoint> points, glm::dvec2 kappa) {
  assert(!points.empty());
  constexpr double coincident = 1e-12;  // squared distance, far below a texel's
  kappa = glm::clamp(kappa, -1.0, 1.0);
  glm::dvec3 sum{0.0}, exact{0.0};
  double weights = 0.0;
  int hits = 0;
  for (const CurvaturePoint& point : points) {
    const glm::dvec2 offset = kappa - glm::dvec2(point.kappa1, point.kappa2);
    const double squared = glm::dot(offset, offset);
    if (squared < coincident) {
      exact += point.color;
      ++hits;
    } else {
      sum += point.color / squared;
      weights += 1.0 / squared;
    }
  }
  return hits > 0 ? exact / static_cast<double>(hits) : sum / weights;
}

std::vector<glm::vec3> curvatureTexels(std::span<const CurvaturePoint> points, int size) {
  assert(size > 0);
  std::vector<glm::vec3> texels;
  texels.reserve(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  const auto centre = [size](int i) { return (2.0 * i + 1.0) / size - 1.0; };
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      texels.emplace_back(curvatureColor(points, {centre(column), centre(row)}));
  return texels;
}

}  // namespace isolux::scene
