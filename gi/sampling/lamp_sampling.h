// Samples light sources from a surface point: the unoccluded irradiance and the direction of a shadow ray.
//
// Sphere lights are sampled uniformly in the cone that they subtend, which is exact near and far. From
// inside, where both sides shine, they are sampled by the cosine. Distant discs are sampled by their cone
// likewise (Shirley, Wang & Zimmerman 1996). Points are voxel coordinates, normals and directions unit
// vectors in the world, lengths mm. Positions are stored relative to the volume, so that large world
// coordinates do not reduce precision. Within a thousandth of the shortest voxel axis, a point light gets no
// brighter. Immutable; safe from any thread.
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/choices.h"
#include "volume/grid.h"

namespace isolux::gi {

// A light source in physical units, scaled so that E = pi * intensity * color on an unoccluded surface at the
// volume's centre that faces it.
struct LampLight {
  scene::LampKind kind = scene::LampKind::point;
  glm::dvec3 positionMm{0.0};
  double radiusMm = 0.0;             // sphere
  glm::dvec3 toward{0.0, 0.0, 1.0};  // directional: unit, world
  double cosHalfAngle = 1.0;         // directional: of the disc in the sky; 1 is a point
  // point: radiant intensity, mm^2 * radiance; sphere: radiance; directional: irradiance of a surface that
  // faces it if cosHalfAngle is 1, else radiance of the disc.
  glm::dvec3 power{0.0};
  bool shadows = true;  // the surface occludes its direct light
};

struct LampSample {
  glm::vec3 irradiance{0.0f};  // the estimate if unoccluded; 0: no ray needed
  glm::vec3 toward{0.0f};      // mm from the point to the sampled light; of distant lights a unit direction
  bool distant = false;
};

class LampSampler {
 public:
  LampSampler(std::span<const LampLight> lamps, const volume::GridGeometry& geometry);

  int count() const { return static_cast<int>(lamps_.size()); }
  // Returns whether the light has an extent; only then do its samples differ.
  bool hasExtent(int lamp) const { return lamps_[static_cast<std::size_t>(lamp)].extended; }
  bool hasShadows(int lamp) const { return lamps_[static_cast<std::size_t>(lamp)].shadows; }

  // Samples a light. `u` in [0, 1)^2 is used by lights with an extent.
  LampSample sample(int lamp, glm::vec3 voxel, glm::vec3 normal, glm::vec2 u) const;
  // Chooses a light with a probability proportional to its unoccluded irradiance. Returns -1 if none shines
  // or if their sum overflows a float. `u` in [0, 1].
  int choose(glm::vec3 voxel, glm::vec3 normal, float u, float& probability) const;

 private:
  struct Lamp {
    scene::LampKind kind;
    bool extended, shadows;
    glm::vec3 voxel, toward, power;
    float radiusMm, oneMinusCosine, luminance;
  };
  glm::vec3 mmTo(const Lamp& lamp, glm::vec3 voxel) const;
  // Returns a bound that is above 0 wherever any sample of the light is.
  float brightness(const Lamp& lamp, glm::vec3 voxel, glm::vec3 normal) const;

  std::vector<Lamp> lamps_;
  glm::mat3 mmOfVoxels_;
  float nearestMm_;
};

}  // namespace isolux::gi
