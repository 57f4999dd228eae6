#include "gi/light_key.h"

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "gi/sampling/built_in_light.h"
#include "scene/rules/environment.h"
#include "scene/settings/choice_names.h"
#include "scene/shown_surfaces.h"

namespace isolux::gi {

namespace {

using nlohmann::ordered_json;

// Of the light itself: goes up when the same settings give other numbers. 2: other hashes of volumes.
constexpr int formatVersion = 2;

template <class Vector>
ordered_json arrayOf(const Vector& v) {
  ordered_json array = ordered_json::array();
  for (int i = 0; i < Vector::length(); ++i) array.push_back(v[i] == 0.0 ? 0.0 : v[i]);  // -0 is 0
  return array;
}

// q and -q, and those of any length, are one rotation.
glm::dvec4 canonicalRotation(glm::dvec4 wxyz) {
  const double length = glm::length(wxyz);
  if (!(length > 0.0)) return {1.0, 0.0, 0.0, 0.0};
  wxyz /= length;
  for (int i = 0; i < 4; ++i)
    if (wxyz[i] != 0.0) return wxyz[i] < 0.0 ? -wxyz : wxyz;
  return wxyz;
}

ordered_json environmentJson(const scene::Scene& resolved, const LightScene& light) {
  ordered_json json;
  const scene::Environment& settings = resolved.light.environment;
  if (scene::kindOf(settings) == scene::EnvironmentKind::builtIn) {
    // By its name: its numbers may differ in the last digits from machine to machine.
    json["built_in"] = scene::choiceName(settings.builtIn);
    json["version"] = kBuiltInLightVersion;
  } else {
    json["hash"] = base::hexText(light.environment ? light.environment->hash() : 0);
    if (!light.environment || light.environment->isConstant()) return json;
  }
  json["rotation"] = arrayOf(canonicalRotation(scene::rotationOf(settings, light.volume->facts.axes)));
  json["share"] = light.environmentShare;
  return json;
}

ordered_json albedoJson(const scene::Scene& resolved, const LightScene& light) {
  if (light.albedo.isConstant()) return arrayOf(light.albedo.at(0.0));
  if (resolved.isosurface.albedoSource == scene::AlbedoSource::map)
    return {{"map", static_cast<int>(resolved.isosurface.albedoMap)},
            {"low", resolved.isosurface.albedoLow.value()},
            {"high", resolved.isosurface.albedoHigh.value()}};
  ordered_json json = ordered_json::array();
  for (const auto& surface : scene::shownSurfaces(resolved))
    json.push_back({{"isovalue", surface.value.value()}, {"albedo", arrayOf(surface.albedo)}});
  return json;
}

ordered_json lampJson(const LampLight& lamp) {
  ordered_json json{{"kind", scene::choiceName(lamp.kind)}};
  if (lamp.kind == scene::LampKind::directional) {
    json["toward"] = arrayOf(lamp.toward);
    json["cos_half_angle"] = lamp.cosHalfAngle;
  } else {
    json["position_mm"] = arrayOf(lamp.positionMm);
    if (lamp.kind == scene::LampKind::sphere) json["radius_mm"] = lamp.radiusMm;
  }
  json["power"] = arrayOf(lamp.power);
  if (!lamp.shadows) json["shadows"] = false;
  return json;
}

// Of what the rays of this light pass; 0: all pieces are shown.
std::uint64_t hiddenKey(const scene::Scene& resolved, const LightScene& light) {
  if (!light.choice.onShown || !light.tracer) return 0;
  const std::vector<volume::HiddenOfSurface> hidden = light.tracer->hidden();
  const volume::HiddenPieces own = volume::hiddenAt(hidden, scene::litIsovalue(resolved));
  return own.voxels ? own.voxels->key() : 0;
}

}  // namespace

std::string lightKey(const scene::Scene& resolved, const LightScene& light, LightPart part) {
  const bool transfer = part == LightPart::sky && light.choice.sky == scene::GiMode::transfer;
  ordered_json json;
  json["format"] = formatVersion;
  json["light"] = part == LightPart::lamps ? "lamps" : "sky";
  json["content"] = transfer ? "transfer" : "irradiance";
  json["channels"] = part == LightPart::lamps ? 3 : light.choice.channels;
  if (transfer) json["sh_order"] = light.shOrder;
  json["volume"] = base::hexText(light.volume->grid().hash());
  json["inside"] = scene::choiceName(light.inside);
  json["lattice_scale"] = resolved.gi.latticeScale;
  if (light.choice.onShown) json["isovalue"] = scene::litIsovalue(resolved);
  if (const std::uint64_t hidden = hiddenKey(resolved, light); hidden != 0)
    json["hidden"] = base::hexText(hidden);
  if (light.tracer && light.tracer->cut().cuts()) json["cut"] = base::hexText(light.tracer->cut().key());
  json["sequence"] = scene::choiceName(light.sequence);
  json["bounces"] = light.bounces;
  if (light.bounces > 0) {
    json["albedo"] = albedoJson(resolved, light);
    if (light.bounces >= light.rouletteDepth) json["roulette_depth"] = light.rouletteDepth;
  }
  if (part == LightPart::lamps) {
    json["lamps"] = ordered_json::array();
    for (const LampLight& lamp : light.lamps) json["lamps"].push_back(lampJson(lamp));
    return json.dump();
  }
  if (light.choice.unitSky)
    json["environment"] = "unit";
  else if (!transfer)
    json["environment"] = environmentJson(resolved, light);
  if (!light.skyShadows) json["shadows"] = false;
  return json.dump();
}

}  // namespace isolux::gi
