// Reads baked irradiance at single points on the CPU, for light that a glossy surface reflects.
//
// A lookup weights the eight texels around a point trilinearly, times the 4th power of the cosine between the
// texel's normal and the point's.
#pragma once

#include <memory>

#include <glm/vec3.hpp>

#include "gi/picture_light.h"
#include "gi/sampling/lamp_sampling.h"

namespace isolux::gi {

// Keeps the block that it read last: one for each thread. `light` must outlive it.
class StoredIrradiance {
 public:
  StoredIrradiance(const PictureLight& light, const LampSampler& lamps) : light_(light), lamps_(lamps) {}

  struct Lookup {
    glm::vec3 irradiance{0.0f};
    float baked = 0.0f;  // fraction of the lookup
  };
  // Return E of sky and light sources at a front face, with the environment's exposure: of the texels that
  // are baked, with the unoccluded sky if none of it is, and without anything in the way. `voxel`: voxel
  // coordinates; `normal`: unit, world.
  Lookup at(glm::vec3 voxel, glm::vec3 normal);
  glm::vec3 unoccluded(glm::vec3 voxel, glm::vec3 normal) const;

 private:
  struct LastBlock {
    std::uint32_t index = ~0u;
    std::shared_ptr<const LatticeBlock> block;
  };
  Lookup lookUp(const LightLattice* lattice, LastBlock& last, glm::vec3 voxel, glm::vec3 normal) const;
  glm::vec3 openSky(glm::vec3 normal) const;
  glm::vec3 valueOf(const LightContent& content, const float* means) const;

  const PictureLight& light_;
  const LampSampler& lamps_;
  LastBlock lastSky_, lastLamps_;
};

}  // namespace isolux::gi
