#include "gi/gloss/stored_irradiance.h"

#include <algorithm>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "gi/harmonics/spherical_harmonics.h"

namespace isolux::gi {

// E of one texel, for light of unit exposure.
glm::vec3 StoredIrradiance::valueOf(const LightContent& content, const float* means) const {
  if (content.kind == LightContent::Kind::irradiance)
    return content.channels == 1 ? glm::vec3(means[0]) : glm::vec3(means[0], means[1], means[2]);
  const auto terms = static_cast<std::size_t>(content.order) * static_cast<std::size_t>(content.order);
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < std::min(terms, light_.environment.size()); ++i)
    for (int c = 0; c < 3; ++c)
      sum[c] += means[static_cast<std::size_t>(content.channels == 1 ? 0 : c) * terms + i] *
                light_.environment[i][c];
  return glm::max(sum, glm::vec3(0.0f));
}

StoredIrradiance::Lookup StoredIrradiance::lookUp(const LightLattice* lattice, LastBlock& last,
                                                  glm::vec3 voxel, glm::vec3 normal) const {
  Lookup found;
  if (!lattice) return found;
  const LatticeGeometry& geometry = lattice->geometry();
  const auto components = static_cast<std::size_t>(lattice->content().components());
  const glm::vec3 at(geometry.texelOf(glm::dvec3(voxel)));
  const glm::ivec3 low(glm::floor(at));
  const glm::vec3 part = at - glm::vec3(low);
  float fitting = 0.0f;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step = volume::cornerStep(corner);
    const glm::ivec3 texel = low + step;
    const glm::vec3 weights = glm::mix(1.0f - part, part, glm::vec3(step));
    const float weight = weights.x * weights.y * weights.z;
    if (!(weight > 0.0f) || !geometry.contains(texel)) continue;
    const std::uint32_t index = geometry.blockOf(texel);
    if (index != last.index) last = {index, lattice->at(index)};
    if (!last.block) continue;
    const auto i = static_cast<std::size_t>(LatticeGeometry::indexInBlock(texel));
    if (last.block->samples[i] == 0) continue;
    const float cosine = std::max(glm::dot(last.block->normals[i], normal), 0.0f);
    const float fits = weight * cosine * cosine * cosine * cosine;
    fitting += fits;
    found.baked += cosine > 0.0f ? weight : 0.0f;
    found.irradiance += fits * valueOf(lattice->content(), &last.block->means[i * components]);
  }
  if (fitting > 0.0f) found.irradiance /= fitting;
  return found;
}

glm::vec3 StoredIrradiance::openSky(glm::vec3 normal) const {
  float basis[9];
  evaluateSh(3, normal, basis);
  glm::vec3 sum(0.0f);
  for (std::size_t i = 0; i < 9; ++i) sum += basis[i] * light_.irradianceSh[i];
  return glm::max(sum, glm::vec3(0.0f));
}

glm::vec3 StoredIrradiance::unoccluded(glm::vec3 voxel, glm::vec3 normal) const {
  glm::vec3 sum = openSky(normal);
  for (int lamp = 0; lamp < lamps_.count(); ++lamp)
    sum += lamps_.sample(lamp, voxel, normal, glm::vec2(0.5f)).irradiance;
  return sum;
}

StoredIrradiance::Lookup StoredIrradiance::at(glm::vec3 voxel, glm::vec3 normal) {
  const Lookup sky = lookUp(light_.sky.get(), lastSky_, voxel, normal);
  const Lookup lamps = lookUp(light_.lamps.get(), lastLamps_, voxel, normal);
  const bool transfers = light_.sky && light_.sky->content().kind == LightContent::Kind::transfer;
  const float baked = std::min(light_.sky ? sky.baked : 1.0f, light_.lamps ? lamps.baked : 1.0f);
  const glm::vec3 ofSky =
      light_.sky ? (transfers ? glm::vec3(1.0f) : light_.skyScale) * sky.irradiance : openSky(normal);
  return {ofSky + lamps.irradiance, light_.sky || light_.lamps ? baked : 0.0f};
}

}  // namespace isolux::gi
