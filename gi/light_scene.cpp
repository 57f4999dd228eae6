#include "gi/light_scene.h"

#include <algorithm>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/portable_math.h"
#include "gi/sampling/built_in_light.h"
#include "scene/rules/environment.h"

namespace isolux::gi {

namespace {

using scene::LampKind;

// Of least error under a cathedral's lights. Directions drawn from the environment carry no reflected light:
// with 4 bounces, 0.75 has 1.6 times the error of 0.5; with at most one, 0.8 to 0.9 times.
constexpr double shareOfFewBounces = 0.75, shareOfManyBounces = 0.5;
// A lamp in the middle of the volume counts as this far away, in lengths of the diagonal: its brightness is
// told by what it gives there.
constexpr double nearestDistance = 0.01;

bool shines(const scene::Lamp& lamp) {
  return lamp.shown && lamp.intensity > 0.0 && lamp.color != glm::dvec3(0.0);
}

}  // namespace

glm::dmat3 rotationOf(const scene::Scene& scene, const volume::PreparedVolume& volume) {
  const glm::dvec4 wxyz = scene::rotationOf(scene.light.environment, volume.facts.axes);
  return worldFromEnvironment(glm::dquat(wxyz.x, wxyz.y, wxyz.z, wxyz.w));
}

std::shared_ptr<const Environment> loadEnvironment(const scene::Environment& settings) {
  switch (scene::kindOf(settings)) {
    case scene::EnvironmentKind::file:
      return std::make_shared<const Environment>(Environment::load(settings.file));
    case scene::EnvironmentKind::oneColor:
      return std::make_shared<const Environment>(Environment::constant(*settings.constant));
    case scene::EnvironmentKind::builtIn:
      break;
  }
  return std::make_shared<const Environment>(builtInEnvironment(settings.builtIn));
}

std::vector<LampLight> lampsOf(const scene::Scene& resolved, const volume::GridGeometry& geometry) {
  const auto [low, high] = geometry.worldBounds();
  const glm::dvec3 centre = 0.5 * (low + high);
  const double diagonal = std::max(glm::length(high - low), 1e-9);
  std::vector<LampLight> lights;
  for (const scene::Lamp& lamp : resolved.lamps) {
    if (!shines(lamp)) continue;
    LampLight light;
    light.kind = lamp.kind;
    light.shadows = lamp.shadows;
    const glm::dvec3 brightness = lamp.intensity * lamp.color;
    if (lamp.kind == LampKind::directional) {
      light.toward = glm::normalize(lamp.direction);
      light.cosHalfAngle = base::portableCos(0.5 * lamp.angle * std::numbers::pi / 180.0);
      const double sine2 = (1.0 - light.cosHalfAngle) * (1.0 + light.cosHalfAngle);
      light.power = sine2 > 0.0 ? brightness / sine2 : std::numbers::pi * brightness;
    } else {
      light.positionMm = lamp.position.value();
      const double distance = std::max(glm::length(light.positionMm - centre), nearestDistance * diagonal);
      if (lamp.kind == LampKind::point) {
        light.power = std::numbers::pi * distance * distance * brightness;
      } else {
        light.radiusMm = lamp.radius.value();
        const double apart = std::max(1.0, distance / light.radiusMm);  // 1: the centre is inside the sphere
        light.power = apart * apart * brightness;
      }
    }
    lights.push_back(light);
  }
  return lights;
}

std::shared_ptr<const volume::IsosurfaceTracer> lightTracerOf(
    const scene::Scene& resolved, const std::shared_ptr<const volume::PreparedVolume>& volume,
    base::Progress& progress) {
  auto tracer =
      std::make_shared<volume::IsosurfaceTracer>(volume->volume.grid, resolved.isosurface.inside, progress);
  tracer->hide(volume::hiddenOf(resolved, *volume->pieces, progress), progress);
  tracer->cut(volume::SurfaceCut(resolved, volume->grid().geometry()));
  return tracer;
}

std::shared_ptr<const LightScene> makeLightScene(const scene::Scene& resolved,
                                                 const std::shared_ptr<const volume::PreparedVolume>& volume,
                                                 std::shared_ptr<const volume::IsosurfaceTracer> tracer,
                                                 std::shared_ptr<const Environment> environment) {
  const scene::GiChoice choice = scene::giChoiceOf(resolved);
  double share = 0.0;  // an even sky has no direction to prefer
  if (environment && !choice.unitSky && !environment->isConstant() && choice.sky != scene::GiMode::transfer)
    share =
        resolved.gi.environmentShare.value_or(choice.bounces <= 1 ? shareOfFewBounces : shareOfManyBounces);
  LightScene light{.volume = volume,
                   .tracer = std::move(tracer),
                   .choice = choice,
                   .environment = std::move(environment),
                   .worldFromEnvironment = glm::mat3(rotationOf(resolved, *volume)),
                   .skyShadows = resolved.light.environment.shadows,
                   .lamps = lampsOf(resolved, volume->grid().geometry()),
                   .albedo = scene::AlbedoOfIsovalue(resolved),
                   .inside = resolved.isosurface.inside,
                   .sequence = resolved.gi.sequence,
                   .bounces = choice.bounces,
                   .rouletteDepth = resolved.gi.rouletteDepth,
                   .environmentShare = share,
                   .shOrder = resolved.gi.shOrder};
  return std::make_shared<const LightScene>(std::move(light));
}

std::shared_ptr<const LightScene> innerSideOf(const LightScene& light, base::Progress& progress) {
  auto inner = std::make_shared<LightScene>(light);
  inner->inside = scene::otherSide(light.inside);
  inner->tracer = light.tracer->otherSide(progress);
  return inner;
}

}  // namespace isolux::gi
