#include "render/light/light_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/color.h"

namespace isolux::render {

namespace {

constexpr float kDistance = 0.8f, kIsovalueDistance = 0.5f;  // texels
constexpr float kErrors = 3.0f;                              // standard errors
constexpr float kNothing = 50.0f;                            // a Gaussian of this exponent
constexpr float kKink = 0.7f;                                // halves the weight
constexpr float kLeastTrust = 1e-12f;
constexpr float kLeastPart = 1e-4f;  // of a transfer vector: less is not worth its time

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

// What a neighbour counts, but for its paths and trust.
float weightOf(const FilterTexel& own, const FilterTexel& other) {
  const float cosine = glm::dot(own.normal, other.normal);
  if (cosine <= 0.0f) return 0.0f;
  // Between a plateau and a slope the slope says how far apart isosurfaces are.
  const float steepness = std::max({own.shape.steepness, other.shape.steepness, 1e-37f});
  const float off = (other.isovalue - own.isovalue) / (steepness * kIsovalueDistance);
  const glm::vec3 way = (other.place - own.place) / kDistance;
  const float c2 = cosine * cosine, c4 = c2 * c2, c8 = c4 * c4;
  return c8 * c8 * std::exp(-std::min(0.5f * (glm::dot(way, way) + off * off), kNothing));
}

// A texel, and what itself and each of its neighbours counts.
struct Neighbourhood {
  const FilterTexel* own;
  float ownTrust;
  std::array<const FilterTexel*, 27> texels;
  std::array<float, 27> weights, trust;
};

Neighbourhood neighbourhoodOf(const std::vector<FilterTexel>& texels, const std::vector<float>& trust,
                              glm::ivec3 texel) {
  Neighbourhood result{
      &texels[at(texel.x, texel.y, texel.z)], trust[at(texel.x, texel.y, texel.z)], {}, {}, {}};
  for (int n = 0; n < 27; ++n) {
    const glm::ivec3 step = glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
    const std::size_t i = at(texel.x + step.x, texel.y + step.y, texel.z + step.z);
    result.texels[static_cast<std::size_t>(n)] = &texels[i];
    result.trust[static_cast<std::size_t>(n)] = trust[i];
    result.weights[static_cast<std::size_t>(n)] = trust[i] * weightOf(*result.own, texels[i]);
  }
  return result;
}

FilterTexel filtered(const Neighbourhood& around) {
  const FilterTexel& own = *around.own;
  FilterTexel result = own;
  float skyWeight = 0.0f, lampsWeight = 0.0f;
  result.sky = result.lamps = glm::vec3(0.0f);
  for (std::size_t n = 0; n < around.texels.size(); ++n) {
    const FilterTexel& other = *around.texels[n];
    if (around.weights[n] == 0.0f) continue;
    // Paths count as far as they are believed: what is wrong is no edge of shadow.
    const float mine = around.ownTrust, others = around.trust[n];
    const float sky = around.weights[n] * other.skyPaths *
                      likeness(own.sky, mine * own.skyPaths, other.sky, others * other.skyPaths);
    const float lamps = around.weights[n] * other.lampsPaths *
                        likeness(own.lamps, mine * own.lampsPaths, other.lamps, others * other.lampsPaths);
    skyWeight += sky;
    result.sky += sky * other.sky;
    lampsWeight += lamps;
    result.lamps += lamps * other.lamps;
  }
  result.sky = own.skyPaths > 0.0f ? result.sky / skyWeight : own.sky;
  result.lamps = own.lampsPaths > 0.0f ? result.lamps / lampsWeight : own.lamps;
  return result;
}

void addTransfer(const Neighbourhood& around, std::size_t components, float* out) {
  float whole = 0.0f;
  for (std::size_t n = 0; n < around.texels.size(); ++n)
    whole += around.weights[n] * around.texels[n]->skyPaths;
  for (std::size_t n = 0; n < around.texels.size(); ++n) {
    const FilterTexel& other = *around.texels[n];
    const float part = around.weights[n] * other.skyPaths / whole;
    if (!(part > kLeastPart)) continue;
    for (std::size_t c = 0; c < components; ++c) out[c] += part * other.transfer[c];
  }
}

// The block's texels, x fastest.
std::vector<glm::ivec3> ownTexels() {
  std::vector<glm::ivec3> texels;
  for (int z = 1; z <= gi::kBlockTexels; ++z)
    for (int y = 1; y <= gi::kBlockTexels; ++y)
      for (int x = 1; x <= gi::kBlockTexels; ++x) texels.emplace_back(x, y, z);
  return texels;
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
  for (const glm::ivec3& texel : ownTexels()) {
    const FilterTexel& own = texels[at(texel.x, texel.y, texel.z)];
    const bool lit = own.normal != glm::vec3(0.0f) && (own.skyPaths > 0.0f || own.lampsPaths > 0.0f);
    result.push_back(lit ? filtered(neighbourhoodOf(texels, trust, texel)) : own);
  }
  return result;
}

std::vector<float> filterTransfer(const std::vector<FilterTexel>& texels, std::size_t components) {
  const std::vector<float> trust = trustIn(texels);
  std::vector<float> result(gi::kTexelsOfBlock * components, 0.0f);
  float* out = result.data();
  for (const glm::ivec3& texel : ownTexels()) {
    const FilterTexel& own = texels[at(texel.x, texel.y, texel.z)];
    if (own.normal != glm::vec3(0.0f) && own.skyPaths > 0.0f)
      addTransfer(neighbourhoodOf(texels, trust, texel), components, out);
    out += components;
  }
  return result;
}

}  // namespace isolux::render
