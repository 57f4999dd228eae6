#include "gi/gloss/filtered_environment.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <glm/geometric.hpp>

#include "gi/sampling/gloss_lobe.h"

namespace isolux::gi {

namespace {

constexpr int kMostRows = 128, kFewestRows = 16;
constexpr double kRowsPerDeviation = 4.0;
constexpr double kLeast = 1e-4;  // of the lobe's maximum: less counts as nothing

int rowsFor(const Environment& environment, float roughness) {
  if (environment.isConstant()) return 1;
  const double deviation = 1.0 / std::sqrt(static_cast<double>(glossExponent(roughness)) + 1.0);
  const int wanted = static_cast<int>(std::ceil(kRowsPerDeviation * std::numbers::pi / deviation));
  return std::min(std::clamp(wanted, kFewestRows, kMostRows), std::max(environment.height(), kFewestRows));
}

// The mean of each pixel of a map with so many rows, weighted by solid angle.
Environment averaged(const Environment& of, int rows) {
  if (rows >= of.height() && 2 * rows >= of.width()) return of;
  const int columns = rows == 1 ? 1 : 2 * rows;
  std::vector<glm::dvec3> sums(static_cast<std::size_t>(rows * columns), glm::dvec3(0.0));
  std::vector<double> weights(sums.size(), 0.0);
  // At least three samples across each pixel of either map.
  const int height = 3 * std::max(rows, of.height()), width = 3 * std::max(columns, of.width());
  for (int y = 0; y < height; ++y) {
    const double row = (y + 0.5) / height, solidAngle = std::sin(std::numbers::pi * row);
    const int from = static_cast<int>(row * of.height()), to = static_cast<int>(row * rows);
    for (int x = 0; x < width; ++x) {
      const double column = (x + 0.5) / width;
      const auto pixel = static_cast<std::size_t>(to * columns + static_cast<int>(column * columns));
      sums[pixel] += solidAngle * glm::dvec3(of.pixels()[static_cast<std::size_t>(
                                      from * of.width() + static_cast<int>(column * of.width()))]);
      weights[pixel] += solidAngle;
    }
  }
  std::vector<glm::vec3> pixels;
  for (std::size_t i = 0; i < sums.size(); ++i) pixels.emplace_back(sums[i] / weights[i]);
  return Environment(columns, rows, std::move(pixels));
}

// The integral with the lobe about the middle of each pixel.
Environment convolved(const Environment& of, float exponent) {
  const int width = of.width(), height = of.height();
  if (of.isConstant()) return of;
  std::vector<glm::vec3> directions(of.pixels().size()), pixels;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      directions[static_cast<std::size_t>(row * width + column)] =
          glm::vec3(of.directionOf(column + 0.5, row + 0.5));
  // cos^k falls below the least within this angle.
  const auto nearest =
      static_cast<float>(exponent > 0.0f ? std::pow(kLeast, 1.0 / static_cast<double>(exponent)) : 0.0);
  const double reach = std::acos(static_cast<double>(nearest)) / std::numbers::pi * height;
  for (int row = 0; row < height; ++row) {
    const int first = std::max(0, static_cast<int>(std::floor(row - reach)));
    const int last = std::min(height - 1, static_cast<int>(std::ceil(row + reach)));
    for (int column = 0; column < width; ++column) {
      const glm::vec3 middle = directions[static_cast<std::size_t>(row * width + column)];
      glm::dvec3 sum(0.0);
      double weight = 0.0;
      for (int y = first; y <= last; ++y) {
        const double solidAngle = of.solidAngle(y);
        const auto start = static_cast<std::size_t>(y * width);
        for (std::size_t i = start; i < start + static_cast<std::size_t>(width); ++i) {
          const float cosine = std::min(glm::dot(middle, directions[i]), 1.0f);
          if (cosine <= nearest) continue;
          const double part = solidAngle * static_cast<double>(std::pow(cosine, exponent));
          sum += part * glm::dvec3(of.pixels()[i]);
          weight += part;
        }
      }
      pixels.emplace_back(weight > 0.0 ? glm::vec3(sum / weight)
                                       : of.pixels()[static_cast<std::size_t>(row * width + column)]);
    }
  }
  return Environment(width, height, std::move(pixels));
}

}  // namespace

FilteredEnvironment::FilteredEnvironment(const Environment& environment, float roughness)
    : roughness_(roughness),
      coarse_(averaged(environment, rowsFor(environment, roughness))),
      filtered_(convolved(coarse_, glossExponent(roughness))) {}

}  // namespace isolux::gi
