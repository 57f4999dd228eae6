// What each look costs, and how its frame divides over the passes (Hadwiger et al. 2005, table 3).
#include <cstdio>

#include <nlohmann/json.hpp>

#include "bench/bench.h"
#include "bench/pass_times.h"
#include "render/gl/gl_context.h"
#include "scene/settings/settings.h"

namespace isolux::bench {
namespace {

constexpr int rounds = 5;

void compare(const render::OffscreenContext& context, const Subject& subject) {
  const scene::Setting& mode = scene::setting("look.mode");
  scene::Scene plain;
  plain.surfaces.front().value = subject.isovalue;
  const Frame base(context.gl(), subject.volume, plain);  // they share its renderer, and so its volume
  std::vector<Frame> frames;
  std::size_t reference = 0;
  for (std::size_t i = 0; i < mode.choices.size(); ++i) {
    frames.push_back(base);
    mode.set(frames.back().scene, mode.choices[i]);
    if (frames.back().scene == base.scene) reference = i;
  }
  const std::vector<PassTimes> times = passTimes(frames, rounds);
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::printf("  %-20s %8.2f ms %6.2fx ", mode.choices[i].c_str(), times[i].frame,
                times[i].frame / times[reference].frame);
    for (const auto& [pass, milliseconds] : times[i].passes)
      std::printf("  %s %.1f %%", pass.c_str(), 100.0 * milliseconds / times[i].frame);
    std::printf("\n");
  }
}

void run() {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %s; 512 x 512, every pass of every frame, against the default look\n",
              context->description().renderer.c_str());
  for (const Subject& subject : subjects()) {
    std::printf(" %s\n", subject.name.c_str());
    compare(*context, subject);
  }
}

const Registration registration("looks", "what each look costs, pass by pass", run);

}  // namespace
}  // namespace isolux::bench
