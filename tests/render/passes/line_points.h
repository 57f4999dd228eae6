// Lines in pictures as points of the surface.
#pragma once

#include <algorithm>
#include <vector>

#include <glm/geometric.hpp>

namespace isolux::test {

// Returns the share of the points of `of` that have one of `near` within `reach` mm.
inline double shareNear(const std::vector<glm::dvec3>& of, const std::vector<glm::dvec3>& near,
                        double reach) {
  if (of.empty()) return 1.0;
  const auto isNear = [&](const glm::dvec3& p) {
    return std::any_of(near.begin(), near.end(),
                       [&](const glm::dvec3& q) { return glm::distance(p, q) <= reach; });
  };
  return static_cast<double>(std::count_if(of.begin(), of.end(), isNear)) / static_cast<double>(of.size());
}

}  // namespace isolux::test
