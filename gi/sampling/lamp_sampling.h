// Lamps as a surface point sees them: how much light arrives unoccluded, and where a shadow ray must go.
//
// Sphere lamps are sampled uniformly in the cone they are seen under, which stays exact for lamps that are
// far away or near; from inside one, which shines on both sides, by the cosine. Distant discs likewise by
// their cone (Shirley, Wang & Zimmerman 1996). Points are voxel coordinates, normals and directions unit
// vectors in the world, lengths mm. Positions of lamps are kept relative to the volume, so that large world
// coordinates cost no digits. Nearer than a thousandth of the shortest voxel axis a point lamp gets no
// brighter. Immutable; any thread.
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gi/light_scene.h"
#include "volume/grid.h"

namespace isolux::gi {

struct LampSample {
  glm::vec3 irradiance{0.0f};  // the estimate, if nothing is between; 0: no ray needed
  glm::vec3 toward{0.0f};      // mm from the point to what shines there; of distant lamps a unit direction
  bool distant = false;
};

class LampSampler {
 public:
  LampSampler(std::span<const LampLight> lamps, const volume::GridGeometry& geometry);

  int count() const { return static_cast<int>(lamps_.size()); }
  // Only lamps with an extent have samples that differ.
  bool hasExtent(int lamp) const { return lamps_[static_cast<std::size_t>(lamp)].extended; }

  // `u` in [0, 1)^2 is used by lamps with an extent.
  LampSample sample(int lamp, glm::vec3 voxel, glm::vec3 normal, glm::vec2 u) const;
  // One lamp, with a probability in proportion to its unoccluded irradiance; -1 where none shines, or all
  // together beyond what a float holds. `u` in [0, 1].
  int choose(glm::vec3 voxel, glm::vec3 normal, float u, float& probability) const;

 private:
  struct Lamp {
    scene::LampKind kind;
    bool extended;
    glm::vec3 voxel, toward, power;
    float radiusMm, oneMinusCosine, luminance;
  };
  glm::vec3 mmTo(const Lamp& lamp, glm::vec3 voxel) const;
  // Above 0 wherever any sample of the lamp has light.
  float brightness(const Lamp& lamp, glm::vec3 voxel, glm::vec3 normal) const;

  std::vector<Lamp> lamps_;
  glm::mat3 mmOfVoxels_;
  float nearestMm_;
};

}  // namespace isolux::gi
