// Traces what glossy surface points reflect: exact rays against the isosurface of each point.
//
// Two estimates of R (gi/sampling/gloss_lobe.h):
//   reflectionsOf()      for frames: R = visible / open * filtered environment + met * light / baked, and the
//                        visible fraction of each light source. Without anything in the way it has no noise.
//                        What rays meet has the light that is baked there. A source without shadows is
//                        visible everywhere.
//   reflectedRadiance()  the reference: unbiased, without baked or filtered light.
// Rays start as light paths do (gi/trace/path_tracer.h). Thread-safe.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

#include <glm/vec3.hpp>

#include "gi/bake/texel_estimator.h"
#include "gi/gloss/filtered_environment.h"
#include "gi/light_scene.h"
#include "gi/sampling/gloss_lobe.h"
#include "gi/trace/path_tracer.h"

namespace isolux::gi {

struct PictureLight;

// Holds what frames need to show gloss, besides the light itself.
struct GlossLight {
  std::shared_ptr<const LightScene> scene;  // its tracer is null where no light is baked: nothing occludes
  std::vector<std::shared_ptr<const FilteredEnvironment>>
      environments;  // one for each roughness in the scene

  std::shared_ptr<const FilteredEnvironment> of(float roughness) const;  // null: not in the scene
};

// Returns null if no shown surface of the scene is glossy (scene::showsGloss()). `before` may be null; its
// environments are used again if they are of the same environment.
std::shared_ptr<const GlossLight> makeGlossLight(const scene::Scene& resolved,
                                                 std::shared_ptr<const LightScene> light,
                                                 const GlossLight* before);

struct GlossPoint {
  glm::vec3 voxel{0.0f};
  float isovalue = 0.0f;                 // stored units
  glm::vec3 normal{0.0f}, mirror{0.0f};  // unit, world; toward the viewer's side, and the mirror direction
  float exponent = 0.0f;
  std::uint32_t seed = 0;                            // of its pattern of directions
  std::uint32_t sample = 0;                          // the first of the pattern
  const FilteredEnvironment* environment = nullptr;  // reflectionsOf() only
};

struct Reflection {
  float met = 0.0f;       // fraction of the lobe that meets the surface
  glm::vec3 light{0.0f};  // radiance of the baked part of that, with the environment's exposure
  float baked = 0.0f;
  glm::vec3 unoccluded{0.0f};  // radiance that takes the place of light / baked where nothing is baked
  // Luminance of the environment in the directions of the lobe: all of it, and what reaches the point.
  float open = 0.0f, visible = 0.0f;
  glm::vec3 lamps{1.0f};                                   // visible fraction of each light source
  glm::vec3 hit{std::numeric_limits<float>::quiet_NaN()};  // voxel that the last ray met; NaN: none

  void add(const Reflection& other, float weight) {
    met += weight * other.met;
    light += weight * other.light;
    baked += weight * other.baked;
    unoccluded += weight * other.unoccluded;
    open += weight * other.open;
    visible += weight * other.visible;
    lamps += weight * other.lamps;
  }
};

// Computes the means over `samples` rays of each point. Returns false when stopped.
bool reflectionsOf(const PictureLight& light, std::span<const GlossPoint> points, std::uint32_t samples,
                   std::span<Reflection> reflections, const std::stop_token& stop);

// Adds estimates of R over a range of samples to each point's sums; of the sky without its exposure, and of
// the light sources. `squares`: of the luminance of both together, the sky times `skyScale`. Returns false
// when stopped.
struct RadianceSum {
  glm::dvec3 sky{0.0}, lamps{0.0};
  double luminance = 0.0, squares = 0.0;
  RadianceSum& operator+=(const RadianceSum& more) {
    sky += more.sky;
    lamps += more.lamps;
    luminance += more.luminance;
    squares += more.squares;
    return *this;
  }
};
bool reflectedRadiance(const PathTracer& paths, std::span<const GlossPoint> points, SampleRange range,
                       double skyScale, std::span<RadianceSum> sums, std::uint64_t& rays,
                       const std::stop_token& stop);

}  // namespace isolux::gi
