// What looking for the edge of the object costs in a picture, against the derivatives that curvature needs.
#include <cstdio>

#include "bench/bench.h"
#include "bench/pass_times.h"
#include "render/gl/gl_context.h"

namespace isolux::bench {
namespace {

// With ranges that nobody measures.
Frame edgeFrame(const render::OffscreenContext& context, const Subject& subject, scene::LookMode look,
                scene::Executor executor) {
  scene::Scene scene;
  scene.surfaces.front().value = subject.isovalue;
  scene.look.mode = look;
  scene.look.rangeLow = -1.0;
  scene.look.rangeHigh = 1.0;
  return {context.gl(), subject.volume, scene, 1, {.executor = executor}};
}

void run() {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %s; 512 x 512, every pass of every frame\n", context->description().renderer.c_str());
  for (const Subject& subject : subjects())
    for (const auto executor : {scene::Executor::cpu, scene::Executor::gpu}) {
      const auto times = passTimes({edgeFrame(*context, subject, scene::LookMode::edge_offset, executor),
                                    edgeFrame(*context, subject, scene::LookMode::kappa1, executor)},
                                   5);
      const double edge = times[0].of("edge"), hessian = times[1].of("hessian");
      std::printf(" %s, %s: edge %.1f ms of a frame of %.1f; hessian %.1f ms of %.1f; edge / hessian %.1f\n",
                  subject.name.c_str(), executor == scene::Executor::cpu ? "processor" : "shaders", edge,
                  times[0].frame, hessian, times[1].frame, edge / hessian);
    }
}

const Registration registration("edge", "the edge pass against the hessian pass, in pictures of each", run);

}  // namespace
}  // namespace isolux::bench
