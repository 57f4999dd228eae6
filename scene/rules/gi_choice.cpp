#include "scene/rules/gi_choice.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "scene/opacity.h"
#include "scene/rules/environment.h"
#include "scene/rules/relevance.h"
#include "scene/shown_surfaces.h"

namespace isolux::scene {

namespace {

bool isGrey(const glm::dvec3& color) {
  return color.x == color.y && color.y == color.z;
}

bool isBlack(const glm::dvec3& color) {
  return color.x == 0.0 && color.y == 0.0 && color.z == 0.0;
}

bool shines(const Lamp& lamp) {
  return lamp.shown && lamp.intensity > 0.0 && !isBlack(lamp.color);
}

bool albedoIsGrey(const Scene& scene) {
  if (scene.isosurface.albedoSource == AlbedoSource::map) return scene.isosurface.albedoMap == ColorMap::gray;
  return std::ranges::all_of(shownSurfaces(scene), isGrey, &Surface::albedo);
}

void addReason(GiChoice& choice, const char* clause) {
  choice.reason += (choice.reason.empty() ? "" : "; ") + std::string(clause);
}

// Isovalues of the shown isosurfaces whose light is baked; of all shown ones if all are too transparent.
std::vector<std::optional<double>> litValues(const Scene& scene) {
  std::vector<std::optional<double>> lit, shown;
  for (const Surface& surface : shownSurfaces(scene)) {
    shown.push_back(surface.value);
    if (bakesLight(surface)) lit.push_back(surface.value);
  }
  return lit.empty() ? shown : lit;
}

GiMode leastMode(const Scene& scene, GiChoice& choice) {
  const bool probe = !hasOneColor(scene.light.environment);
  if (!probe && isBlack(*scene.light.environment.constant)) {
    addReason(choice, "the environment is black");
    return GiMode::off;
  }
  if (!probe && scene.gi.bounces == 0) {
    addReason(choice, scene.light.environment.shadows
                          ? "constant environment, no bounces: one number per texel (sky visibility)"
                          : "constant environment, no bounces");
    return GiMode::vicinity;
  }
  if (!probe) {
    addReason(choice, "constant environment: irradiance for radiance 1, scaled by its colour");
    return GiMode::irradiance;
  }
  if (scene.light.environment.moves) {
    addReason(choice, "rotatable environment: transfer");
    return GiMode::transfer;
  }
  addReason(choice, scene.gi.bounces == 0 ? "static environment, no bounces: direct light"
                                          : "static environment: irradiance");
  return scene.gi.bounces == 0 ? GiMode::shadow : GiMode::irradiance;
}

}  // namespace

bool litAlone(const Scene& scene) {
  return litValues(scene).size() == 1;
}

double litIsovalue(const Scene& resolved) {
  return litValues(resolved).front().value();
}

GiChoice giChoiceOf(const Scene& scene) {
  GiChoice choice;
  if (shadingOf(scene) != Shading::gi) {
    choice.reason = "no look reads baked light";
    return choice;
  }
  if (scene.gi.mode == GiMode::off) {
    choice.reason = "gi.mode is off: local shading";
    return choice;
  }
  choice.lamps = std::ranges::any_of(scene.lamps, shines);
  if (scene.gi.mode == GiMode::automatic) {
    choice.sky = leastMode(scene, choice);
  } else {
    choice.sky = scene.gi.mode;
    addReason(choice, "gi.mode is set");
  }
  const bool probe = !hasOneColor(scene.light.environment);
  const bool direct = choice.sky == GiMode::vicinity || scene.gi.mode == GiMode::shadow;
  choice.bounces = direct ? 0 : scene.gi.bounces;
  // Vicinity under a probe takes the probe's mean for the sky's colour.
  choice.unitSky = choice.sky == GiMode::vicinity ||
                   (!probe && (choice.sky == GiMode::irradiance || choice.sky == GiMode::shadow));
  choice.traced = choice.sky != GiMode::off || choice.lamps;
  if (choice.sky != GiMode::off && !scene.light.environment.shadows) {
    const bool even = choice.unitSky && choice.bounces == 0;
    addReason(choice, even ? "no shadows of the environment: nothing to bake"
                           : "no shadows of the environment: unoccluded direct light");
    if (even) choice.sky = GiMode::off;
  }
  choice.wanted = choice.sky != GiMode::off || choice.lamps;
  if (choice.lamps) addReason(choice, "light sources are static: irradiance");

  const bool forView = scene.gi.texels == GiTexels::automatic && scene.gi.extent == GiExtent::view;
  choice.onShown = choice.wanted && (forView || scene.gi.texels == GiTexels::shown) && litAlone(scene);
  if (choice.onShown) addReason(choice, "one isosurface is lit: light on it alone");

  const bool grey = choice.bounces == 0 || albedoIsGrey(scene);
  if (grey && (choice.unitSky || choice.sky == GiMode::transfer)) {
    choice.channels = 1;
    addReason(choice, choice.bounces == 0 ? "no bounces: one channel" : "the albedo is grey: one channel");
  }
  return choice;
}

}  // namespace isolux::scene
