// A path tracer of a triangle mesh that shares nothing with ours but the scene: Embree's intersections,
// independent random numbers, a search of its own in the light probe. What the light tracer is judged by.
//
// One bounce; E of a point is the mean over paths of pi * L(cosine-distributed direction) or of
// L cos / pdf(a direction drawn from the probe's pixels), half of each, by the balance heuristic (Veach &
// Guibas 1995).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "bench/embree_scene.h"
#include "bench/triangles.h"
#include "gi/light_scene.h"

namespace isolux::bench {

class MeshPathTracer {
 public:
  // Normals of the mesh are those of the field's gradient at its corners (volume::sampleCubic), interpolated
  // between. `light` has no lamps; `isovalue`, of the mesh, in data units.
  MeshPathTracer(std::shared_ptr<const gi::LightScene> light, Triangles mesh, double isovalue);

  struct Estimate {
    glm::dvec3 irradiance{0.0}, variance{0.0};  // of the mean
  };
  // At a surface point, voxel coordinates. The same for the same seed.
  Estimate irradiance(glm::dvec3 voxel, std::uint64_t seed, int paths) const;

 private:
  struct Hit;
  struct Random;
  bool firstEntry(glm::dvec3 voxel, glm::dvec3 worldDirection, Hit& hit) const;
  glm::dvec3 normalAt(glm::dvec3 voxel) const;  // outward, unit, world
  glm::dvec3 direct(glm::dvec3 voxel, glm::dvec3 normal, Random& random, bool bounces) const;

  std::shared_ptr<const gi::LightScene> light_;
  Triangles mesh_;
  std::vector<glm::dvec3> normals_;  // of the mesh's points
  std::vector<double> below_;        // sums of the probe's pixels' luminance times solid angle, up to each
  glm::dvec3 albedo_;
  glm::dmat3 voxelFromWorld_, worldFromEnvironment_;
  double offset_;  // off the surface, mm
  EmbreeScene embree_;
};

}  // namespace isolux::bench
