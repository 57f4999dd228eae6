#include "app/light/light_report.h"

#include <cstdio>

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

}  // namespace isolux::app
