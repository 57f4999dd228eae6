// What gloss costs: frames of a turning view with baked light, without and with it, pass by pass.
#include <cstdio>
#include <map>

#include <glm/gtc/matrix_transform.hpp>

#include "app/light/light_picture.h"
#include "base/quantiles.h"
#include "bench/bench.h"
#include "bench/frame.h"
#include "render/gl/gl_context.h"

namespace isolux::bench {
namespace {

constexpr int rounds = 15;

struct Times {
  std::vector<double> frame;
  std::map<std::string, std::vector<double>> passes;
};

void compare(Frame frame, const VolumePointer& volume) {
  app::LightController controller({});
  base::Progress progress;
  app::lightPicture(controller, *frame.renderer, frame.scene, frame.request, volume, progress);
  const glm::dvec3 eye = *frame.scene.camera.eye, target = *frame.scene.camera.target;
  std::map<bool, Times> times;
  for (int round = -1; round < rounds; ++round)
    for (const bool glossy : {false, true}) {
      scene::Scene scene = frame.scene;
      if (!glossy) scene.surfaces.front().specular = 0.0;
      const glm::dmat4 turn = glm::rotate(glm::dmat4(1.0), 0.002 * (2 * round + glossy), *scene.camera.up);
      scene.camera.eye = target + glm::dvec3(turn * glm::dvec4(eye - target, 0.0));
      const render::FrameReport& report = frame.renderer->render(scene, frame.request);
      if (round < 0) continue;
      times[glossy].frame.push_back(report.milliseconds);
      for (const render::PassReport& pass : report.passes)
        if (pass.state == render::PassState::ran)
          times[glossy].passes[pass.name].push_back(pass.milliseconds);
    }
  const double plain = base::median(times[false].frame), gloss = base::median(times[true].frame);
  std::printf("  %d ray%s per pixel  %7.2f ms, with gloss %7.2f ms  %5.2fx ",
              frame.request.supersampling * frame.request.supersampling,
              frame.request.supersampling == 1 ? " " : "s", plain, gloss, gloss / plain);
  for (const auto& [pass, samples] : times[true].passes) {
    const std::vector<double>& without = times[false].passes[pass];
    std::printf("  %s %+.2f", pass.c_str(),
                base::median(samples) - (without.empty() ? 0.0 : base::median(without)));
  }
  std::printf("\n");
  std::fflush(stdout);
}

void run() {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %s; 512 x 512, every frame from another direction; milliseconds that passes add\n",
              context->description().renderer.c_str());
  for (const Subject& subject : subjects()) {
    std::printf(" %s\n", subject.name.c_str());
    scene::Scene scene;
    scene.surfaces.front().value = subject.isovalue;
    scene.look.mode = scene::LookMode::gi;
    scene.surfaces.front().specular = 0.3;
    scene.gi.samples = 16;
    for (const int supersampling : {1, 2})
      compare(Frame(context->gl(), subject.volume, scene, supersampling), subject.volume);
  }
}

const Registration registration("gloss", "what gloss costs", run);

}  // namespace
}  // namespace isolux::bench
