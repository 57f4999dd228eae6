// Solids with known volume and area, thinner and thicker, in grids of every kind: what measures are judged
// by.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/support/analytic_fields.h"
#include "volume/grid.h"

namespace isolux::test {

struct KnownSolid {
  std::string name;
  std::function<double(glm::dvec3)> field;  // signed distance, world mm, positive inside
  double volume = 0.0, area = 0.0;
};

// 0.4 x 0.4 x 2.5 mm, along axes of determinant -1 of which none is the world's; as long as wide.
inline volume::GridGeometry thickObliqueSlices(int size) {
  const glm::dvec3 n = glm::normalize(glm::dvec3(1.0, -2.0, 0.6));
  glm::dmat3 directions(1.0);
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) directions[a][b] -= 2.0 * n[a] * n[b];
  return volume::GridGeometry::make({size, size, size * 4 / 25}, {0.4, 0.4, 2.5}, {3.0, 4.0, 5.0},
                                    directions);
}

// About the middle of the domain, but not at a voxel's.
struct SolidPlace {
  explicit SolidPlace(const volume::GridGeometry& geometry) {
    const glm::dvec3 lengths = glm::dvec3(geometry.dims - 1) * geometry.spacingMm();
    edge = std::min({lengths.x, lengths.y, lengths.z});
    centre = glm::dvec3(geometry.worldFromVoxel * glm::dvec4(glm::dvec3(geometry.dims - 1) * 0.5, 1.0)) +
             glm::dvec3(0.09, 0.19, 0.29) * geometry.spacingMm().x;
  }
  glm::dvec3 centre;
  double edge;
};

inline double roundedBox(glm::dvec3 beyond) {
  return std::min(std::max({beyond.x, beyond.y, beyond.z}), 0.0) +
         glm::length(glm::max(beyond, glm::dvec3(0.0)));
}

inline std::vector<KnownSolid> knownSolids(const volume::GridGeometry& geometry) {
  const SolidPlace at(geometry);
  const double e = at.edge, pi = std::numbers::pi;
  const glm::dvec3 c = at.centre;
  const double ball = 0.35 * e, ring = 0.27 * e, tube = 0.12 * e, radius = 0.25 * e, half = 0.3 * e;
  return {
      {"ball", [=](glm::dvec3 p) { return ball - glm::length(p - c); }, 4.0 / 3.0 * pi * ball * ball * ball,
       4.0 * pi * ball * ball},
      {"torus",
       [=](glm::dvec3 p) {
         const glm::dvec3 q = p - c;
         return tube - std::hypot(std::hypot(q.x, q.y) - ring, q.z);
       },
       2.0 * pi * pi * ring * tube * tube, 4.0 * pi * pi * ring * tube},
      {"cylinder",
       [=](glm::dvec3 p) {
         const glm::dvec3 q = p - c;
         return -roundedBox({std::hypot(q.x, q.y) - radius, -1e9, std::abs(q.z) - half});
       },
       2.0 * pi * radius * radius * half, 2.0 * pi * radius * (2.0 * half + radius)},
      {"cube", [=](glm::dvec3 p) { return -roundedBox(glm::abs(p - c) - half); }, 8.0 * half * half * half,
       24.0 * half * half},
  };
}

}  // namespace isolux::test
