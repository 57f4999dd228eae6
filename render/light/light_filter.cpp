#include "render/light/light_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace isolux::render {

namespace {

constexpr float kDistance = 0.6f, kIsovalueDistance = 0.5f;  // texels
constexpr float kKink = 0.7f;                                // halves the weight
constexpr float kLeastTrust = 1e-12f;

std::size_t at(int x, int y, int z) {
  const int index = (z * kFilterTexels + y) * kFilterTexels + x;
  return static_cast<std::size_t>(index);
}

// Weights by distance, of 0 to 3 axes that differ by one texel.
const std::array<float, 4>& distanceWeights() {
  static const std::array<float, 4> weights = [] {
    std::array<float, 4> w{};
    for (std::size_t axes = 0; axes < w.size(); ++axes)
      w[axes] = std::exp(-static_cast<float>(axes) / (2.0f * kDistance * kDistance));
    return w;
  }();
  return weights;
}

// How much each texel's light is to be believed: at most 1, and never nothing.
std::vector<float> trustIn(const std::vector<FilterTexel>& texels) {
  float steepest = 1e-37f;
  for (const FilterTexel& t : texels) steepest = std::max(steepest, t.shape.steepness);
  std::vector<float> trust;
  trust.reserve(texels.size());
  for (const FilterTexel& t : texels) {
    const float kink = t.shape.kink / kKink, squared = kink * kink;
    trust.push_back(std::max(t.shape.steepness / steepest / (1.0f + squared * squared), kLeastTrust));
  }
  return trust;
}

// What a neighbour counts, but for its paths and trust; `squared` is its distance.
float weightOf(const FilterTexel& own, const FilterTexel& other, int squared) {
  const float cosine = glm::dot(own.normal, other.normal);
  if (cosine <= 0.0f) return 0.0f;
  // Between a plateau and a slope the slope says how far apart isosurfaces are.
  const float steepness = std::max({own.shape.steepness, other.shape.steepness, 1e-37f});
  const float off = (other.isovalue - own.isovalue) / (steepness * kIsovalueDistance);
  const float c2 = cosine * cosine, c4 = c2 * c2;
  return distanceWeights()[static_cast<std::size_t>(squared)] * c4 * c4 *
         std::exp(-0.5f * std::min(off * off, 100.0f));
}

FilterTexel filtered(const std::vector<FilterTexel>& texels, const std::vector<float>& trust, int x, int y,
                     int z) {
  const FilterTexel& own = texels[at(x, y, z)];
  FilterTexel result = own;
  if (own.normal == glm::vec3(0.0f) || (own.skyPaths == 0.0f && own.lampsPaths == 0.0f)) return result;
  float skyWeight = 0.0f, lampsWeight = 0.0f;
  result.sky = result.lamps = glm::vec3(0.0f);
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const std::size_t i = at(x + dx, y + dy, z + dz);
        const FilterTexel& other = texels[i];
        const float weight = trust[i] * weightOf(own, other, dx * dx + dy * dy + dz * dz);
        skyWeight += weight * other.skyPaths;
        result.sky += weight * other.skyPaths * other.sky;
        lampsWeight += weight * other.lampsPaths;
        result.lamps += weight * other.lampsPaths * other.lamps;
      }
  result.sky = own.skyPaths > 0.0f ? result.sky / skyWeight : own.sky;
  result.lamps = own.lampsPaths > 0.0f ? result.lamps / lampsWeight : own.lamps;
  return result;
}

}  // namespace

FieldShape fieldShape(float own, glm::vec3 before, glm::vec3 behind) {
  glm::vec3 slope(0.0f), bend(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    const float low = own - before[axis], high = behind[axis] - own;
    const bool hasLow = std::isfinite(low), hasHigh = std::isfinite(high);
    slope[axis] = hasLow && hasHigh ? 0.5f * (low + high) : hasLow ? low : hasHigh ? high : 0.0f;
    bend[axis] = hasLow && hasHigh ? high - low : 0.0f;
  }
  const float largest = std::max({std::abs(slope.x), std::abs(slope.y), std::abs(slope.z)});
  if (!(largest > 0.0f)) return {};
  const float length = glm::length(slope / largest);
  const glm::vec3 along = slope / largest / length;
  return {largest * length, std::abs(glm::dot(along * along, bend / largest)) / length};
}

std::vector<FilterTexel> filterBlock(const std::vector<FilterTexel>& texels) {
  const std::vector<float> trust = trustIn(texels);
  std::vector<FilterTexel> result;
  result.reserve(gi::kTexelsOfBlock);
  for (int z = 1; z <= gi::kBlockTexels; ++z)
    for (int y = 1; y <= gi::kBlockTexels; ++y)
      for (int x = 1; x <= gi::kBlockTexels; ++x) result.push_back(filtered(texels, trust, x, y, z));
  return result;
}

}  // namespace isolux::render
