#include "tests/support/line_area.h"

#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

#include "base/progress.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {

LineArea areaByLines(const volume::Grid& grid, double isovalue, std::size_t lines) {
  base::Progress progress;
  const volume::MinMaxBlocks blocks(grid, 8, progress);
  const auto [low, high] = grid.geometry().worldBounds();
  const glm::dvec3 centre = 0.5 * (low + high);
  const double radius = 0.5 * glm::length(high - low), pi = std::numbers::pi;
  const glm::dmat4 voxelFromWorld = grid.geometry().voxelFromWorld();
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto inBall = [&] {
    for (;;) {
      const glm::dvec3 p(uniform(random), uniform(random), uniform(random));
      if (const double squared = glm::dot(p, p); squared <= 1.0 && squared > 1e-4) return p;
    }
  };
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < lines; ++i) {
    const glm::dvec3 direction = glm::normalize(inBall());
    const glm::dvec3 u = glm::normalize(glm::cross(direction, inBall())), v = glm::cross(direction, u);
    const double r = radius * std::sqrt(0.5 * (uniform(random) + 1.0)), angle = pi * uniform(random);
    const glm::dvec3 origin =
        centre - 2.0 * radius * direction + r * (std::cos(angle) * u + std::sin(angle) * v);
    const glm::dvec3 from(voxelFromWorld * glm::dvec4(origin, 1.0)),
        to(voxelFromWorld * glm::dvec4(direction, 0.0));
    double crossings = 0.0, t = 0.0;
    while (const auto hit = firstHit(grid, blocks, isovalue, {from, to, t})) {
      crossings += 1.0;
      t = hit->t + 1e-9 * radius;
    }
    sum += crossings;
    squares += crossings * crossings;
  }
  const double n = static_cast<double>(lines), mean = sum / n, perCrossing = 2.0 * pi * radius * radius;
  return {mean * perCrossing, std::sqrt((squares / n - mean * mean) / n) * perCrossing};
}

}  // namespace isolux::test
