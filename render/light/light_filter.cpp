#include "render/light/light_filter.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/color.h"

namespace isolux::render {

namespace {

constexpr float kDistance = 0.8f, kIsovalueDistance = 0.5f;  // texels
constexpr float kErrors = 3.0f;                              // standard errors
constexpr float kNothing = 50.0f;                            // a Gaussian of this exponent

std::size_t at(int x, int y, int z) {
  const int index = (z * kFilterTexels + y) * kFilterTexels + x;
  return static_cast<std::size_t>(index);
}

// How far the difference of two estimates may be their noise, 0 to 1.
float likeness(glm::vec3 light, float paths, glm::vec3 otherLight, float otherPaths) {
  if (paths == 0.0f || otherPaths == 0.0f) return 1.0f;
  const float a = base::luminance(light);
  const float b = base::luminance(otherLight);
  const float variance = kErrors * kErrors * (a * a / paths + b * b / otherPaths);
  return variance > 0.0f ? std::exp(-std::min(0.5f * (a - b) * (a - b) / variance, kNothing)) : 1.0f;
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
        const glm::vec3 way = (other.place - own.place) / kDistance;
        const float exponent = 0.5f * (glm::dot(way, way) + off * off);
        const float c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4;
        const float weight = c8 * c8 * std::exp(-std::min(exponent, kNothing));
        const float ofSky =
            weight * other.skyPaths * likeness(own.sky, own.skyPaths, other.sky, other.skyPaths);
        const float ofLamps =
            weight * other.lampsPaths * likeness(own.lamps, own.lampsPaths, other.lamps, other.lampsPaths);
        skyWeight += ofSky;
        result.sky += ofSky * other.sky;
        lampsWeight += ofLamps;
        result.lamps += ofLamps * other.lamps;
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
