#include "app/light/light_report.h"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/version.h"
#include "base/number_text.h"
#include "scene/rules/needs.h"

namespace isolux::app {

nlohmann::ordered_json bakeJson(const LightState& state) {
  const gi::BakeCounters& counters = state.counters;
  return {{"mode", state.mode},
          {"reason", state.choice.reason},
          {"channels", state.choice.channels},
          {"bounces", state.choice.bounces},
          {"texels", counters.texelsLit},
          {"samples", counters.samplesDone},
          {"rays", counters.rays},
          {"seconds", counters.seconds},
          {"threads", counters.threads},
          {"notes", state.warnings}};
}

nlohmann::ordered_json bakeStats(const LightState& state, const volume::Grid& grid) {
  return {{"version", version()}, {"bake", bakeJson(state)}, {"data_hash", base::hexText(grid.hash())}};
}

void printBake(const LightState& state) {
  const gi::BakeCounters& counters = state.counters;
  std::printf("light: %s (%s): %llu texels, %llu paths, %llu rays, %.3g s on %d threads\n",
              state.mode.c_str(), state.choice.reason.c_str(),
              static_cast<unsigned long long>(counters.texelsLit),
              static_cast<unsigned long long>(counters.samplesDone),
              static_cast<unsigned long long>(counters.rays), counters.seconds, counters.threads);
  for (const std::string& warning : state.warnings) std::printf("light: %s\n", warning.c_str());
  std::fflush(stdout);
}

nlohmann::ordered_json exposureJson(const scene::Scene& resolved, const gi::PictureLight* light) {
  if (!light || !scene::usesGi(resolved)) return nullptr;
  if (resolved.picture.exposure) return {{"stops", *resolved.picture.exposure}, {"from", "setting"}};
  nlohmann::ordered_json json{{"stops", light->automaticExposure},
                              {"from", light->seen ? "surface" : "lights"}};
  if (light->seen) {
    json["median"] = light->seen->median;
    json["highlight"] = light->seen->highlight;
  }
  return json;
}

void printExposure(const scene::Scene& resolved, const gi::PictureLight* light) {
  if (!light || !scene::usesGi(resolved)) return;
  if (resolved.picture.exposure)
    std::printf("exposure: %+.2f stops, as set\n", *resolved.picture.exposure);
  else if (!light->seen)
    std::printf("exposure: %+.2f stops, by the lights\n", static_cast<double>(light->automaticExposure));
  else
    std::printf("exposure: %+.2f stops, by the surface: its median luminance is %.3g, its highlights %.3g\n",
                static_cast<double>(light->automaticExposure), light->seen->median, light->seen->highlight);
  std::fflush(stdout);
}

}  // namespace isolux::app
