// Frames of the GL pipeline: block size, hit method, derivative field, supersampling.
#include <cstdio>

#include "bench/bench.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "scene/automatic.h"
#include "tests/support/test_data.h"
#include "volume/phantom.h"

namespace isolux::bench {
namespace {

using VolumePointer = std::shared_ptr<const volume::PreparedVolume>;

struct Subject {
  std::string name;
  VolumePointer volume;
  double isovalue;
};

std::vector<Subject> subjects() {
  scene::Progress progress;
  std::vector<Subject> list;
  scene::Source source;
  source.path = "phantom:gyroid:256";
  list.push_back({"gyroid 256", volume::loadVolume(source, progress), 0.0});
  source.path = "phantom:head";
  list.push_back({"head phantom, bone", volume::loadVolume(source, progress), 300.0});
  if (const auto data = test::dataFolder(); !data.empty()) {
    source.path = (data / "volumes/ct_head_skin_bone.nii.gz").string();
    list.push_back({"ct_head_skin_bone, bone", volume::loadVolume(source, progress), 0.51});
  }
  return list;
}

VolumePointer withBlocks(const VolumePointer& volume, int cells) {
  scene::Progress progress;
  auto copy = std::make_shared<volume::PreparedVolume>(*volume);
  copy->blocks = std::make_shared<volume::MinMaxBlocks>(volume->grid(), cells, progress);
  return copy;
}

// A renderer that draws one scene of one volume again and again.
struct Frame {
  Frame(const std::shared_ptr<const render::Gl>& gl, const VolumePointer& volume, scene::Scene wanted,
        int supersampling)
      : renderer(std::make_shared<render::Renderer>(gl)),
        scene(scene::resolve(std::move(wanted), volume->facts)) {
    renderer->setVolume(volume);
    request.size = {512, 512};
    request.supersampling = supersampling;
  }
  void operator()() const {
    renderer->invalidate();
    renderer->render(scene, request);
  }
  std::shared_ptr<render::Renderer> renderer;
  scene::Scene scene;
  render::FrameRequest request;
};

void run() {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %s, %s; 512 x 512, every pass of every frame\n", context->description().kind.c_str(),
              context->description().renderer.c_str());
  for (const Subject& subject : subjects()) {
    std::printf(" %s\n", subject.name.c_str());
    const VolumePointer large = withBlocks(subject.volume, 8), small = withBlocks(subject.volume, 4);
    scene::Scene base;
    base.isosurface.value = subject.isovalue;
    scene::Scene sampled = base, trilinear = base, interpolating = base;
    sampled.hit.method = scene::HitMethod::sampled;
    trilinear.derivatives.field = scene::Field::trilinear;
    interpolating.derivatives.field = scene::Field::cubic_interpolating;
    printComparison(
        {"exact hits, cubic gradient, blocks of 8", "the same, blocks of 4", "sampled hits (rate 2)",
         "trilinear gradient", "interpolating cubic gradient", "2 x 2 supersampling"},
        medians({Frame(context->gl(), large, base, 1), Frame(context->gl(), small, base, 1),
                 Frame(context->gl(), large, sampled, 1), Frame(context->gl(), large, trilinear, 1),
                 Frame(context->gl(), large, interpolating, 1), Frame(context->gl(), large, base, 2)},
                7));
  }
}

const Registration registration("render", "frames of the pipeline, alternatives in turns", run);

}  // namespace
}  // namespace isolux::bench
