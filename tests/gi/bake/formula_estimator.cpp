#include "tests/gi/bake/formula_estimator.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "gi/bake/bake_queue.h"
#include "gi/lattice/texel_bits.h"

namespace isolux::gi {

namespace {

std::uint32_t mixed(std::uint32_t a, std::uint32_t b) {
  std::uint32_t h = a * 0x9e3779b1u ^ (b + 0x7f4a7c15u) * 0x85ebca6bu;
  h = (h ^ (h >> 15)) * 0x2c1b3c6du;
  return h ^ (h >> 13);
}

std::uint32_t numberOf(glm::ivec3 t) {
  return static_cast<std::uint32_t>((t.z * 1009 + t.y) * 1013 + t.x);
}

double estimateOf(glm::ivec3 texel, std::uint32_t sample, int component) {
  const std::uint32_t seed = mixed(numberOf(texel), static_cast<std::uint32_t>(component));
  return static_cast<double>(mixed(seed, sample) >> 8) / 16777216.0;
}

}  // namespace

glm::vec3 FormulaEstimator::normalOf(glm::ivec3 texel) {
  return mixed(numberOf(texel), 7) % 7 == 0 ? glm::vec3(0.0f) : glm::vec3(0.0f, 0.0f, 1.0f);
}

float FormulaEstimator::meanOf(glm::ivec3 texel, SampleRange range, int component) {
  double sum = 0.0;
  for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
    sum += estimateOf(texel, i, component);
  return static_cast<float>(sum / range.count);
}

float FormulaEstimator::bakedOf(glm::ivec3 texel, const std::vector<std::uint32_t>& rounds, int component) {
  float mean = 0.0f;
  std::uint32_t first = 0;
  for (const std::uint32_t end : rounds) {
    const std::uint32_t count = end - first;
    mean += (meanOf(texel, {first, count}, component) - mean) *
            (static_cast<float>(count) / static_cast<float>(end));
    first = end;
  }
  return mean;
}

void FormulaEstimator::points(std::span<const glm::ivec3> texels, std::span<TexelPoint> points) const {
  std::transform(texels.begin(), texels.end(), points.begin(), [](glm::ivec3 texel) {
    return TexelPoint{glm::vec3(texel), normalOf(texel)};
  });
}

bool FormulaEstimator::add(std::span<const glm::ivec3> texels, std::span<const TexelPoint> points,
                           SampleRange range, std::span<double> sums, std::uint64_t& rays,
                           const std::stop_token& stop) const {
  ++calls;
  if (before && !before(texels, range, stop)) return false;
  const auto components = static_cast<std::size_t>(content_.components());
  for (std::size_t t = 0; t < texels.size(); ++t) {
    if (points[t].normal != normalOf(texels[t]) || points[t].normal == glm::vec3(0.0f))
      throw std::logic_error("a texel without its normal");
    for (std::size_t c = 0; c < components; ++c)
      for (std::uint32_t i = range.first; i < range.first + range.count; ++i)
        sums[t * components + c] += estimateOf(texels[t], i, static_cast<int>(c));
  }
  rays += 2 * range.count * texels.size();
  paths += range.count * texels.size();
  return true;
}

std::vector<BlockRequest> texelsWhere(const LatticeGeometry& lattice,
                                      const std::function<bool(glm::ivec3)>& chosen) {
  std::vector<BlockRequest> wanted;
  for (std::uint32_t block = 0; block < lattice.blockCount(); ++block) {
    BlockRequest next{block, {}};
    for (int i = 0; i < kTexelsOfBlock; ++i) {
      const glm::ivec3 texel = lattice.texelOf(block, i);
      next.texels[static_cast<std::size_t>(i)] = lattice.contains(texel) && chosen(texel);
    }
    if (next.texels.any()) wanted.push_back(next);
  }
  return wanted;
}

std::string differenceFrom(const LightLattice& lattice, std::uint32_t samples) {
  const std::vector<std::uint32_t> rounds = roundsUpTo(samples);
  const auto components = static_cast<std::size_t>(lattice.content().components());
  for (std::uint32_t b = 0; b < lattice.geometry().blockCount(); ++b) {
    const auto block = lattice.at(b);
    if (!block) continue;
    for (std::size_t i = 0; i < kTexelsOfBlock; ++i) {
      if (block->samples[i] == 0) continue;
      const glm::ivec3 texel = lattice.geometry().texelOf(b, static_cast<int>(i));
      std::ostringstream place;
      place << "texel " << texel.x << " " << texel.y << " " << texel.z << ": ";
      const auto end = std::find(rounds.begin(), rounds.end(), block->samples[i]);
      if (end == rounds.end()) return place.str() + std::to_string(block->samples[i]) + " samples";
      if (block->normals[i] != FormulaEstimator::normalOf(texel)) return place.str() + "normal";
      const std::vector<std::uint32_t> done(rounds.begin(), end + 1);
      for (std::size_t c = 0; c < components; ++c)
        if (block->means[i * components + c] != FormulaEstimator::bakedOf(texel, done, static_cast<int>(c)))
          return place.str() + "component " + std::to_string(c);
    }
  }
  return {};
}

bool allHave(const LightLattice& lattice, const std::vector<BlockRequest>& wanted, std::uint32_t samples) {
  for (const BlockRequest& w : wanted) {
    const auto block = lattice.at(w.block);
    if (!block) return false;
    bool all = true;
    forEachTexel(w.texels, [&](std::size_t i) {
      const bool lit = FormulaEstimator::normalOf(lattice.geometry().texelOf(w.block, static_cast<int>(i))) !=
                       glm::vec3(0.0f);
      all = all && block->samples[i] == (lit ? samples : 0u);
    });
    if (!all) return false;
  }
  return true;
}

}  // namespace isolux::gi
