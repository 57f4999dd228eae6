// Frames of the pipeline: executor, block size, hit method, derivative field, supersampling.
#include <cstdio>

#include "bench/bench.h"
#include "bench/frame.h"
#include "bench/subjects.h"
#include "render/gl/gl_context.h"

namespace isolux::bench {
namespace {

VolumePointer withBlocks(const VolumePointer& volume, int cells) {
  base::Progress progress;
  auto copy = std::make_shared<volume::PreparedVolume>(*volume);
  copy->blocks = std::make_shared<volume::MinMaxBlocks>(volume->grid(), cells, progress);
  return copy;
}

void run() {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %s, %s; 512 x 512, every pass of every frame\n", context->description().kind.c_str(),
              context->description().renderer.c_str());
  for (const Subject& subject : subjects()) {
    std::printf(" %s\n", subject.name.c_str());
    const VolumePointer large = withBlocks(subject.volume, 8), small = withBlocks(subject.volume, 4);
    scene::Scene base;
    base.surfaces.front().value = subject.isovalue;
    scene::Scene sampled = base, trilinear = base, interpolating = base, shadowed = base, cubic = base;
    sampled.hit.method = scene::HitMethod::sampled;
    trilinear.derivatives.field = scene::Field::trilinear;
    interpolating.derivatives.field = scene::Field::cubic_interpolating;
    shadowed.look.shadow = 1.0;
    cubic.hit.field = scene::Field::cubic;
    scene::Scene cubicShadowed = cubic, interpolated = interpolating;
    cubicShadowed.look.shadow = 1.0;
    interpolated.hit.field = scene::Field::cubic_interpolating;
    const scene::HostSettings shaders{.executor = scene::Executor::gpu},
        processor{.executor = scene::Executor::cpu};
    const auto frame = [&](const VolumePointer& volume, const scene::Scene& scene, int supersampling = 1) {
      return Frame(context->gl(), volume, scene, supersampling, shaders);
    };
    const auto onProcessor = [&](const scene::Scene& scene) {
      return Frame(context->gl(), large, scene, 1, processor);
    };
    printComparison(
        {"exact hits, cubic gradient, blocks of 8", "the same on the processor", "the same, blocks of 4",
         "sampled hits (rate 2)", "trilinear gradient", "interpolating cubic gradient", "2 x 2 supersampling",
         "shadows", "the same on the processor"},
        medians({frame(large, base), onProcessor(base), frame(small, base), frame(large, sampled),
                 frame(large, trilinear), frame(large, interpolating), frame(large, base, 2),
                 frame(large, shadowed), onProcessor(shadowed)},
                7));
    printComparison(
        {"exact hits of the cubic field", "the same on the processor", "of the interpolating cubic field",
         "the same on the processor", "cubic field, shadows", "the same on the processor"},
        medians({frame(large, cubic), onProcessor(cubic), frame(large, interpolated),
                 onProcessor(interpolated), frame(large, cubicShadowed), onProcessor(cubicShadowed)},
                5));
  }
}

const Registration registration("render", "frames of the pipeline, alternatives in turns", run);

}  // namespace
}  // namespace isolux::bench
