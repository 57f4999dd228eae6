// Gathers everything that lighting depends on from a resolved Scene. Immutable; shared by all threads.
//
// World coordinates are in mm; radiance is linear RGB. The environment's exposure is not included: light is
// baked at exposure 0 and the frame multiplies. With GiChoice::unitSky, the sky has radiance 1 and the frame
// multiplies by its colour.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "gi/sampling/environment.h"
#include "gi/sampling/lamp_sampling.h"
#include "scene/albedo.h"
#include "scene/rules/gi_choice.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::gi {

struct LightScene {
  std::shared_ptr<const volume::PreparedVolume> volume;
  std::shared_ptr<const volume::IsosurfaceTracer> tracer;
  scene::GiChoice choice;
  std::shared_ptr<const Environment> environment;  // null: no sky
  glm::mat3 worldFromEnvironment{1.0f};
  bool skyShadows = true;  // the surface occludes the direct light of the sky
  std::vector<LampLight> lamps;
  scene::AlbedoOfIsovalue albedo;
  scene::Inside inside = scene::Inside::above;
  scene::DirectionSequence sequence = scene::DirectionSequence::r2;
  int bounces = 0;
  int rouletteDepth = 3;
  double environmentShare = 0.0;
  int shOrder = 5;
  // For measurements: called by any thread with every batch of rays before it is traced. `any`: only whether
  // the rays hit is needed.
  std::function<void(std::span<const volume::TraceRay> rays, bool any)> traced = {};
};

// Returns a tracer for the scene's inside, without hidden components and clipped parts. Throws Error:
// interrupted; memory.
std::shared_ptr<const volume::IsosurfaceTracer> lightTracerOf(
    const scene::Scene& resolved, const std::shared_ptr<const volume::PreparedVolume>& volume,
    base::Progress& progress);
// Gathers the scene's lighting. `environment` is the environment of scene.light.environment, loaded by
// loadEnvironment(); it stays shared.
std::shared_ptr<const LightScene> makeLightScene(const scene::Scene& resolved,
                                                 const std::shared_ptr<const volume::PreparedVolume>& volume,
                                                 std::shared_ptr<const volume::IsosurfaceTracer> tracer,
                                                 std::shared_ptr<const Environment> environment);
// Returns the lighting of the back faces: they are the front faces of the complement of the inside. Its
// tracer shares the tables of `light`'s. Throws Error{interrupted}.
std::shared_ptr<const LightScene> innerSideOf(const LightScene& light, base::Progress& progress);
// Loads the file, or makes the constant environment or built-in light. Throws base::Error{input}.
std::shared_ptr<const Environment> loadEnvironment(const scene::Environment& settings);
std::vector<LampLight> lampsOf(const scene::Scene& resolved, const volume::GridGeometry& geometry);
// Returns the rotation of the scene's environment.
glm::dmat3 rotationOf(const scene::Scene& scene, const volume::PreparedVolume& volume);

enum class LightPart { sky, lamps };  // stored in separate lattices

}  // namespace isolux::gi
