// A volume in bricks against the same volume as one texture: the price of the indirection, pass by pass
// (Hadwiger et al. 2005, table 4), and a large volume within a quarter of its bytes: first picture, then an
// orbit.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <glm/geometric.hpp>

#include "bench/bench.h"
#include "bench/pass_times.h"
#include "render/gl/gl_context.h"

namespace isolux::bench {
namespace {

constexpr int rounds = 5;
constexpr int largeVoxels = 512;  // per axis
constexpr int orbitViews = 36;

int largestDifference(const render::ColorImage& a, const render::ColorImage& b) {
  int most = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
  return most;
}

void compare(const render::OffscreenContext& context, const Subject& subject) {
  std::vector<Frame> frames;
  for (const auto layout : {scene::MemoryLayout::whole, scene::MemoryLayout::bricks}) {
    scene::Scene scene;
    scene.surfaces.front().value = subject.isovalue;
    frames.emplace_back(context.gl(), subject.volume, scene, 1,
                        scene::HostSettings{.memory = {.layout = layout}, .executor = scene::Executor::gpu});
  }
  const std::vector<PassTimes> times = passTimes(frames, rounds);
  const render::FrameReport& report = frames[1].changed();
  std::printf(
      " %s: %zu of %zu bricks hold the surface, %zu were asked for; largest difference of the pictures %d of "
      "255\n",
      subject.name.c_str(), report.bricks.active, report.bricks.total, report.bricks.resident,
      largestDifference(frames[0].renderer->readColor(), frames[1].renderer->readColor()));
  std::printf("  %-20s %9.2f ms whole %9.2f ms bricks %6.2fx\n", "frame", times[0].frame, times[1].frame,
              times[1].frame / times[0].frame);
  for (const auto& [pass, milliseconds] : times[0].passes)
    std::printf("  %-20s %9.2f ms whole %9.2f ms bricks %6.2fx\n", pass.c_str(), milliseconds,
                times[1].of(pass), times[1].of(pass) / milliseconds);
}

void orbit(const render::OffscreenContext& context, const std::string& name) {
  const VolumePointer volume = load("phantom:" + name + ":" + std::to_string(largeVoxels));
  const std::size_t mebibytes = volume->grid().bytes() >> 20;
  // Bricks are of the graphics card; the processor reads voxels where they are.
  Frame whole(context.gl(), volume, {}, 1, {.executor = scene::Executor::gpu});
  whole.changed();
  const render::ColorImage expected = whole.renderer->readColor();
  whole.renderer.reset();  // its textures make room
  const scene::Memory memory{.gpuBudgetMb = static_cast<int>(mebibytes / 4)};
  Frame bricks(context.gl(), volume, {}, 1, {.memory = memory, .executor = scene::Executor::gpu});
  const render::FrameReport first = bricks.changed();
  std::printf(
      " %s %d, %zu MiB in a budget of %d MiB (%zu slots): %zu bricks uploaded, %zu replaced, %.3g %% "
      "missing, "
      "largest difference %d of 255\n",
      name.c_str(), largeVoxels, mebibytes, memory.gpuBudgetMb, first.bricks.slots, first.bricks.uploaded,
      first.bricks.evicted, 100.0 * first.bricks.missing,
      largestDifference(expected, bricks.renderer->readColor()));
  const glm::dvec3 target = *bricks.scene.camera.target, eye = *bricks.scene.camera.eye - target;
  const double radius = glm::length(eye);
  for (int lap = 1; lap <= 2; ++lap) {
    std::size_t uploaded = 0, evicted = 0, most = 0;
    double missing = 0.0;
    for (int view = 0; view < orbitViews; ++view) {
      const double angle = 2.0 * M_PI * view / orbitViews;
      bricks.scene.camera.eye =
          target + radius * glm::normalize(glm::dvec3(std::cos(angle), std::sin(angle), 0.3));
      const render::FrameReport& report = bricks.changed();
      uploaded += report.bricks.uploaded;
      evicted += report.bricks.evicted;
      most = std::max(most, report.bricks.resident);
      missing = std::max(missing, report.bricks.missing);
    }
    std::printf(
        "  lap %d of %d views: %zu bricks uploaded, %zu replaced, %zu resident, at most %.3g %% missing\n",
        lap, orbitViews, uploaded, evicted, most, 100.0 * missing);
  }
}

void run() {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %s; 512 x 512\n", context->description().renderer.c_str());
  for (const Subject& subject : subjects()) compare(*context, subject);
  for (const char* name : {"head", "torus", "gyroid"}) orbit(*context, name);
}

const Registration registration("bricks",
                                "volumes in bricks against whole ones; 512^3 in a quarter of its bytes", run);

}  // namespace
}  // namespace isolux::bench
