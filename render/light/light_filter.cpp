#include "render/light/light_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace isolux::render {

namespace {

constexpr float kDistance = 0.6f, kIsovalueDistance = 0.5f;  // texels

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

FilterTexel filtered(const std::vector<FilterTexel>& texels, int x, int y, int z) {
  const FilterTexel& own = texels[at(x, y, z)];
  FilterTexel result = own;
  if (own.normal == glm::vec3(0.0f) || (own.skyPaths == 0.0f && own.lampsPaths == 0.0f)) return result;
  const auto isovalue = [&](int dx, int dy, int dz) { return texels[at(x + dx, y + dy, z + dz)].isovalue; };
  const glm::vec3 slope(isovalue(1, 0, 0) - isovalue(-1, 0, 0), isovalue(0, 1, 0) - isovalue(0, -1, 0),
                        isovalue(0, 0, 1) - isovalue(0, 0, -1));
  const float steepness = std::max(0.5f * glm::length(slope), 1e-30f);
  float skyWeight = 0.0f, lampsWeight = 0.0f;
  result.sky = result.lamps = glm::vec3(0.0f);
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const FilterTexel& other = texels[at(x + dx, y + dy, z + dz)];
        const float cosine = glm::dot(own.normal, other.normal);
        if (cosine <= 0.0f) continue;
        const float off = (other.isovalue - own.isovalue) / (steepness * kIsovalueDistance);
        const float c2 = cosine * cosine, c4 = c2 * c2;
        const int squared = dx * dx + dy * dy + dz * dz;
        const float weight = distanceWeights()[static_cast<std::size_t>(squared)] * c4 * c4 *
                             std::exp(-0.5f * std::min(off * off, 100.0f));
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

std::vector<FilterTexel> filterBlock(const std::vector<FilterTexel>& texels) {
  std::vector<FilterTexel> result;
  result.reserve(gi::kTexelsOfBlock);
  for (int z = 1; z <= gi::kBlockTexels; ++z)
    for (int y = 1; y <= gi::kBlockTexels; ++y)
      for (int x = 1; x <= gi::kBlockTexels; ++x) result.push_back(filtered(texels, x, y, z));
  return result;
}

}  // namespace isolux::render
