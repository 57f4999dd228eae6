#include "render/light/light_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "base/color.h"

namespace isolux::render {

namespace {

constexpr float kDistance = 1.6f, kTransferDistance = 0.8f, kIsovalueDistance = 0.5f;  // texels
constexpr float kErrors = 0.5f;                                                        // standard errors
constexpr float kFlat =
    0.05f;  // texels squared: holds a fitted plane level where few texels say how it tilts
constexpr float kNothing = 50.0f;  // a Gaussian of this exponent
constexpr float kKink = 0.7f;      // halves the weight
constexpr float kLeastTrust = 1e-12f;
constexpr float kOfAnyNormal = 1e-4f;  // light_lattice.glsl has the same number
constexpr float kLeastPart = 1e-4f;    // of a transfer vector: less is not worth its time

std::size_t at(glm::ivec3 texel) {
  return volume::Extent3{glm::ivec3(kFilterTexels)}.index(texel);
}

// One of the two lights of a texel.
struct Light {
  glm::vec3 FilterTexel::*e;
  float FilterTexel::*paths;
};
constexpr Light kSky{&FilterTexel::sky, &FilterTexel::skyPaths};
constexpr Light kLamps{&FilterTexel::lamps, &FilterTexel::lampsPaths};

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
float weightOf(const FilterTexel& own, const FilterTexel& other, float distance) {
  const float cosine = glm::dot(own.normal, other.normal);
  if (cosine <= 0.0f) return 0.0f;
  // Between a plateau and a slope the slope says how far apart isosurfaces are.
  const float steepness = std::max({own.shape.steepness, other.shape.steepness, 1e-37f});
  const float off = (other.isovalue - own.isovalue) / (steepness * kIsovalueDistance);
  const glm::vec3 way = (other.place - own.place) / distance;
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
                              glm::ivec3 texel, float distance) {
  Neighbourhood result{&texels[at(texel)], trust[at(texel)], {}, {}, {}};
  for (int n = 0; n < 27; ++n) {
    const glm::ivec3 step = glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
    const std::size_t i = at(texel + step);
    result.texels[static_cast<std::size_t>(n)] = &texels[i];
    result.trust[static_cast<std::size_t>(n)] = trust[i];
    result.weights[static_cast<std::size_t>(n)] = trust[i] * weightOf(*result.own, texels[i], distance);
  }
  return result;
}

// How luminance changes from place to place, of a plane fitted to the neighbours, and its mean.
struct Plane {
  glm::vec3 slope{0.0f};  // per texel
  float mean = 0.0f;
};
Plane planeOf(const Neighbourhood& around, const std::array<float, 27>& weights, Light light) {
  Plane plane;
  float whole = 0.0f;
  glm::vec3 middle(0.0f);
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const FilterTexel& other = *around.texels[n];
    if (weights[n] == 0.0f) continue;
    whole += weights[n];
    middle += weights[n] * (other.place - around.own->place);
    plane.mean += weights[n] * base::luminance(other.*light.e);
  }
  if (!(whole > 0.0f)) return plane;
  middle /= whole;
  plane.mean /= whole;
  glm::mat3 spread(kFlat);
  glm::vec3 rise(0.0f);
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const FilterTexel& other = *around.texels[n];
    if (weights[n] == 0.0f) continue;
    const float weight = weights[n] / whole;
    const glm::vec3 way = other.place - around.own->place - middle;
    spread += glm::outerProduct(weight * way, way);
    rise += weight * (base::luminance(other.*light.e) - plane.mean) * way;
  }
  plane.slope = glm::inverse(spread) * rise;
  return plane;
}

glm::vec3 filtered(const Neighbourhood& around, Light light) {
  const FilterTexel& own = *around.own;
  std::array<float, 27> weights;
  for (std::size_t n = 0; n < weights.size(); ++n)
    weights[n] = around.weights[n] * (around.texels[n]->*light.paths);
  const Plane plane = planeOf(around, weights, light);
  // Paths count as far as they are believed: what is wrong is no edge of shadow.
  const float paths = around.ownTrust * (own.*light.paths);
  const float light2 = base::luminance(own.*light.e) * base::luminance(own.*light.e);
  const float variance = kErrors * kErrors * (light2 + plane.mean * plane.mean) / paths;
  float whole = 0.0f;
  glm::vec3 sum(0.0f);
  for (std::size_t n = 0; n < weights.size(); ++n) {
    const FilterTexel& other = *around.texels[n];
    if (weights[n] == 0.0f) continue;
    const float step = glm::dot(plane.slope, other.place - own.place);
    const float weight =
        weights[n] * (variance > 0.0f ? std::exp(-std::min(0.5f * step * step / variance, kNothing)) : 1.0f);
    whole += weight;
    sum += weight * (other.*light.e);
  }
  return sum / whole;
}

// A block and what is about it, filtered where somebody asks.
class FilteredBlock {
 public:
  FilteredBlock(const std::vector<FilterTexel>& texels, glm::ivec3 first)
      : texels_(texels),
        first_(first),
        trust_(trustIn(texels)),
        known_(texels.size()),
        result_(texels.size()) {}

  // Light that lookups give back at the texel's place.
  glm::vec3 sharpened(glm::ivec3 texel, Light light) {
    const glm::vec3 own = at(texel, light);
    return glm::max(own + (own - lookedUp(texels_[render::at(texel)], light)), 0.0f);
  }
  // Begins another light.
  void forget() { known_.assign(known_.size(), false); }

 private:
  glm::vec3 at(glm::ivec3 texel, Light light) {
    const std::size_t i = render::at(texel);
    if (!known_[i]) {
      result_[i] = filtered(neighbourhoodOf(texels_, trust_, texel, kDistance), light);
      known_[i] = true;
    }
    return result_[i];
  }

  // As light_lattice.glsl's weighted lookup, of texels that are filtered only.
  glm::vec3 lookedUp(const FilterTexel& own, Light light) {
    const glm::vec3 place = own.place - glm::vec3(first_);
    // A block's texels are lit less than a texel from themselves: their cells are within the border.
    const glm::ivec3 base =
        glm::clamp(glm::ivec3(glm::floor(place)), kFilterBorder - 1, kFilterTexels - kFilterBorder - 1);
    const glm::vec3 part = glm::clamp(place - glm::vec3(base), 0.0f, 1.0f);
    float whole = 0.0f;
    glm::vec3 sum(0.0f);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 step = volume::cornerStep(corner);
      const glm::vec3 parts = glm::mix(1.0f - part, part, glm::vec3(step));
      const glm::ivec3 texel = base + step;
      const FilterTexel& other = texels_[render::at(texel)];
      const float place3 = parts.x * parts.y * parts.z;
      if (place3 == 0.0f || other.normal == glm::vec3(0.0f) || other.*light.paths == 0.0f) continue;
      const float cosine = std::max(glm::dot(own.normal, other.normal), 0.0f), c2 = cosine * cosine;
      const float weight = place3 * (c2 * c2 + kOfAnyNormal);
      whole += weight;
      sum += weight * at(texel, light);
    }
    return whole > 0.0f ? sum / whole : own.*light.e;
  }

  const std::vector<FilterTexel>& texels_;
  glm::ivec3 first_;
  std::vector<float> trust_;
  std::vector<bool> known_;
  std::vector<glm::vec3> result_;
};

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
  volume::forEachIn(glm::ivec3(0), glm::ivec3(gi::kBlockTexels),
                    [&](glm::ivec3 texel) { texels.push_back(texel + kFilterBorder); });
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

std::vector<FilterTexel> filterBlock(const std::vector<FilterTexel>& texels, glm::ivec3 first) {
  const std::vector<glm::ivec3> own = ownTexels();
  std::vector<FilterTexel> result;
  result.reserve(gi::kTexelsOfBlock);
  for (const glm::ivec3& texel : own) result.push_back(texels[at(texel)]);
  FilteredBlock block(texels, first);
  for (const Light light : {kSky, kLamps}) {
    block.forget();
    for (std::size_t i = 0; i < own.size(); ++i)
      if (result[i].normal != glm::vec3(0.0f) && result[i].*light.paths > 0.0f)
        result[i].*light.e = block.sharpened(own[i], light);
  }
  return result;
}

std::vector<float> filterTransfer(const std::vector<FilterTexel>& texels, std::size_t components) {
  const std::vector<float> trust = trustIn(texels);
  std::vector<float> result(gi::kTexelsOfBlock * components, 0.0f);
  float* out = result.data();
  for (const glm::ivec3& texel : ownTexels()) {
    const FilterTexel& own = texels[at(texel)];
    if (own.normal != glm::vec3(0.0f) && own.skyPaths > 0.0f)
      addTransfer(neighbourhoodOf(texels, trust, texel, kTransferDistance), components, out);
    out += components;
  }
  return result;
}

}  // namespace isolux::render
