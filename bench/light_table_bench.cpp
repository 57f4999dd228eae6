// Table 1 of Wyman et al. 2006 on its own volume: the engine block (110 x 208 x 149 with its axes turned)
// under Grace Cathedral, 100 paths per texel, one bounce; ours in seconds on this machine's cores, theirs on
// 30 CPUs (400 MHz R12000). And what it takes from a local picture to the first lit one.
#include <chrono>
#include <cstdio>
#include <thread>

#include "app/light/light_picture.h"
#include "bench/bench.h"
#include "bench/frame.h"
#include "render/gl/gl_context.h"
#include "tests/support/test_data.h"

namespace isolux::bench {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct Row {
  const char* name;
  bool moves;  // the environment: transfer
  scene::GiExtent extent;
  double paperMinutes;   // 0: not in the paper
  bool builtIn = false;  // the default light instead of the probe: no file to read
};
constexpr Row rows[] = {
    {"spherical harmonics, lazy, one 900x900 view", true, scene::GiExtent::view, 0.33},
    {"spherical harmonics, full", true, scene::GiExtent::full, 8.47},
    {"irradiance, lazy, one 900x900 view", false, scene::GiExtent::view, 0.95},
    {"irradiance, full", false, scene::GiExtent::full, 18.2},
    {"irradiance, built-in light, the same view", false, scene::GiExtent::view, 0.0, true}};

scene::Scene sceneOf(const Row& row, const std::string& probe) {
  scene::Scene scene;
  scene.look.mode = scene::LookMode::gi;
  scene.surfaces.front().value = 80.0;
  if (!row.builtIn) scene.light.environment.file = probe;
  scene.light.environment.moves = row.moves;
  scene.gi.extent = row.extent;
  scene.gi.samples = 100;
  scene.gi.bounces = 1;
  return scene;
}

void measure(const Row& row, Frame& frame, const VolumePointer& volume, const std::string& probe) {
  // A picture with local light is on screen when stored light is switched on.
  scene::Scene local = frame.scene;
  local.look.mode = scene::LookMode::blinn_phong;
  frame.renderer->setLight(nullptr);
  frame.renderer->render(local, frame.request);

  base::Progress progress;
  app::LightController controller({});
  const scene::Scene lit = scene::resolve(sceneOf(row, probe), volume->facts);
  const auto begin = Clock::now();
  controller.setScene(lit, volume);
  controller.setVisible(frame.renderer->hitVoxels());
  // The first picture: when a tenth of what is seen has its first paths.
  double first = 0.0;
  while (first == 0.0) {
    const gi::BakeCounters counters = controller.state().counters;
    if (controller.light() && counters.texelsStarted > 0 &&
        counters.texelsStarted * 10 >= counters.texelsWanted) {
      frame.renderer->setLight(controller.light());
      frame.renderer->render(lit, frame.request);
      first = secondsSince(begin);
    } else if (counters.texelsStarted > 0 && row.extent == scene::GiExtent::full) {
      first = -1.0;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  controller.finish(progress);
  const double seconds = secondsSince(begin);
  const gi::BakeCounters counters = controller.state().counters;
  std::printf("  %-44s %7.2f s", row.name, seconds);
  if (row.paperMinutes > 0.0) std::printf("  paper %7.1f s", 60.0 * row.paperMinutes);
  std::printf("  %6.2f M texels %8.1f M rays", 1e-6 * static_cast<double>(counters.texelsLit),
              1e-6 * static_cast<double>(counters.rays));
  if (first > 0.0) std::printf("  first lit picture after %.0f ms", 1e3 * first);
  std::printf("\n");
  std::fflush(stdout);
}

void run() {
  const std::filesystem::path data = test::dataFolder();
  if (data.empty()) {
    std::printf("  skipped: the shared data folder is not there\n");
    return;
  }
  const std::string probe = (data / "hdr/grace_cathedral_1k.hdr").string();
  const VolumePointer volume = load((data / "volumes/engine_crop.mhd").string());
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  Frame frame(context->gl(), volume, sceneOf(rows[0], probe));
  frame.request.size = {900, 900};
  const auto begin = Clock::now();
  gi::loadEnvironment(sceneOf(rows[0], probe).light.environment);
  std::printf("  %u threads; 100 paths, one bounce, order 5; the light probe's file is read in %.0f ms\n",
              std::thread::hardware_concurrency(), 1e3 * secondsSince(begin));
  for (const Row& row : rows) measure(row, frame, volume, probe);
}

const Registration registration("light_table", "Table 1 of Wyman et al. 2006 on its own volume", run);

}  // namespace
}  // namespace isolux::bench
