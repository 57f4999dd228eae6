// What a picture of curvature costs at derivatives.scale against none, once the field is made.
#include <cstdio>

#include "bench/bench.h"
#include "bench/frame.h"
#include "render/gl/gl_context.h"
#include "tests/support/test_data.h"

namespace isolux::bench {
namespace {

Frame curved(const render::OffscreenContext& context, const Subject& subject, double scale,
             double normalScale, scene::Executor executor) {
  scene::Scene scene;
  scene.surfaces.front().value = subject.isovalue;
  scene.look.mode = scene::LookMode::kappa1;
  scene.derivatives.scale = scale;
  scene.derivatives.normalScale = normalScale;
  return {context.gl(), subject.volume, scene, 1, {.executor = executor}};
}

void run() {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %s; 512 x 512, kappa1, every pass of every frame\n", context->description().renderer.c_str());
  std::vector<Subject> list = subjects();
  if (const auto data = test::dataFolder(); !data.empty())
    list.push_back({"mri_colin27, skin", load(data / "volumes/mri_colin27.nii.gz"), 40.0});
  for (const Subject& subject : list) {
    std::printf(" %s\n", subject.name.c_str());
    for (const auto executor : {scene::Executor::cpu, scene::Executor::gpu}) {
      const std::string where = executor == scene::Executor::cpu ? " on the processor" : " by shaders";
      const auto frame = [&](double scale, double normalScale) {
        return curved(*context, subject, scale, normalScale, executor);
      };
      printComparison({"no scale" + where, "scale 1.5 mm, normals at none", "both at 1.5 mm"},
                      medians({frame(0.0, 0.0), frame(1.5, 0.0), frame(1.5, 1.5)}, 5));
    }
  }
}

const Registration registration("scaled_frames", "pictures of curvature at a scale and at none", run);

}  // namespace
}  // namespace isolux::bench
