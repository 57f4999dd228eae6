// Stored light at the tracer's own speed: rays per second of a bake, everything included, against those of
// the tracer alone on the rays that this bake has traced. The engine block of light_table under Grace
// Cathedral, one bounce; every texel of random blocks. Processor time, medians of interleaved rounds.
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <mutex>
#include <set>
#include <thread>

#include "base/quantiles.h"
#include "base/random.h"
#include "bench/bench.h"
#include "bench/subjects.h"
#include "gi/bake/light_bake.h"
#include "gi/trace/lattice_estimator.h"
#include "scene/rules/automatic.h"
#include "tests/support/test_data.h"

namespace isolux::bench {
namespace {

constexpr std::size_t kBlocks = 64;
constexpr std::uint32_t kPaths = 100;
constexpr int kRounds = 7;

double processSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Every ray of a bake, batch after batch as they were traced.
struct Recording {
  struct Batch {
    std::size_t begin, count;
    bool any;  // only whether they hit
  };
  std::mutex mutex;
  std::vector<volume::TraceRay> rays;
  std::vector<Batch> batches;

  void add(std::span<const volume::TraceRay> list, bool any) {
    const std::lock_guard lock(mutex);
    batches.push_back({rays.size(), list.size(), any});
    rays.insert(rays.end(), list.begin(), list.end());
  }
};

std::shared_ptr<gi::LightScene> lightOf(const VolumePointer& volume, const std::string& probe) {
  scene::Scene scene;
  scene.look.mode = scene::LookMode::gi;
  scene.surfaces.front().value = 80.0;
  scene.light.environment.file = probe;
  scene.gi.bounces = 1;
  const scene::Scene resolved = scene::resolve(scene, volume->facts);
  base::Progress progress;
  auto tracer = std::make_shared<const volume::IsosurfaceTracer>(volume->volume.grid,
                                                                 resolved.isosurface.inside, progress);
  return std::make_shared<gi::LightScene>(*gi::makeLightScene(
      resolved, volume, std::move(tracer), gi::loadEnvironment(resolved.light.environment)));
}

std::vector<gi::BlockRequest> randomBlocks(const gi::LatticeGeometry& geometry) {
  std::set<std::uint32_t> chosen;
  for (std::uint64_t i = 0; chosen.size() < kBlocks; ++i)
    chosen.insert(static_cast<std::uint32_t>(base::uniformNoise(7, i) * geometry.blockCount()));
  std::vector<gi::BlockRequest> blocks;
  for (const std::uint32_t block : chosen) {
    gi::BlockRequest wanted;
    wanted.block = block;
    for (int i = 0; i < gi::kTexelsOfBlock; ++i)
      if (geometry.contains(geometry.texelOf(block, i))) wanted.texels.set(static_cast<std::size_t>(i));
    blocks.push_back(wanted);
  }
  return blocks;
}

// Its rays.
std::uint64_t bake(const std::shared_ptr<const gi::LightScene>& light, int threads) {
  const auto geometry = gi::LatticeGeometry::make(light->volume->grid().dims(), 1.0);
  const auto estimator = std::make_shared<const gi::LatticeEstimator>(light, geometry, gi::LightPart::sky);
  const auto lattice = std::make_shared<gi::LightLattice>(geometry, estimator->content(), "");
  gi::LightBake bake(lattice, estimator, {.samples = kPaths, .threads = threads});
  bake.want(gi::Priority::visible, randomBlocks(geometry));
  if (!bake.waitFor(0, 600.0)) std::printf("  the bake did not end\n");
  return bake.counters().rays;
}

// Each thread a part of the batches.
void trace(const volume::IsosurfaceTracer& tracer, const Recording& recording, int threads) {
  const auto part = [&](std::size_t thread) {
    const std::size_t count = recording.batches.size(), parts = static_cast<std::size_t>(threads);
    std::vector<float> t;
    std::vector<std::uint8_t> hit;
    for (std::size_t i = count * thread / parts; i < count * (thread + 1) / parts; ++i) {
      const Recording::Batch& batch = recording.batches[i];
      const auto rays = std::span(recording.rays).subspan(batch.begin, batch.count);
      t.resize(std::max(t.size(), batch.count));
      hit.resize(std::max(hit.size(), batch.count));
      if (batch.any)
        tracer.anyEntries(rays, std::span(hit).first(batch.count));
      else
        tracer.firstEntries(rays, std::span(t).first(batch.count));
    }
  };
  std::vector<std::jthread> others;
  for (int thread = 1; thread < threads; ++thread)
    others.emplace_back(part, static_cast<std::size_t>(thread));
  part(0);
}

void compare(const std::shared_ptr<const gi::LightScene>& light, const Recording& recording, int threads) {
  std::vector<double> bakes, traces, ratios;
  std::uint64_t rays = 0;
  for (int round = -1; round < kRounds; ++round) {
    const double begin = processSeconds();
    rays = bake(light, threads);
    const double between = processSeconds();
    trace(*light->tracer, recording, threads);
    const double end = processSeconds();
    if (round < 0) continue;
    bakes.push_back(static_cast<double>(rays) / (between - begin) * 1e-6);
    traces.push_back(static_cast<double>(recording.rays.size()) / (end - between) * 1e-6);
    ratios.push_back(bakes.back() / traces.back());
  }
  std::printf("  %d thread%s: bake %5.2f, tracer alone %5.2f Mrays/s a core; ratio %4.1f %%\n", threads,
              threads == 1 ? " " : "s", base::median(bakes), base::median(traces),
              100.0 * base::median(ratios));
}

void run() {
  const std::filesystem::path data = test::dataFolder();
  if (data.empty()) {
    std::printf("  skipped: the shared data folder is not there\n");
    return;
  }
  const auto light = lightOf(load((data / "volumes/engine_crop.mhd").string()),
                             (data / "hdr/grace_cathedral_1k.hdr").string());
  Recording recording;
  const auto listened = std::make_shared<gi::LightScene>(*light);
  listened->traced = [&](std::span<const volume::TraceRay> rays, bool any) { recording.add(rays, any); };
  bake(listened, 1);
  std::size_t any = 0;
  for (const Recording::Batch& batch : recording.batches) any += batch.any ? batch.count : 0;
  const auto all = static_cast<double>(recording.rays.size());
  std::printf("  %zu blocks, %u paths a texel, %.1f M rays, of %.0f %% only whether they hit; %s\n", kBlocks,
              kPaths, 1e-6 * all, 100.0 * static_cast<double>(any) / all, light->tracer->target());
  for (const int threads : {1, 2}) compare(light, recording, threads);
}

const Registration registration("bake_rate",
                                "a bake, everything included, against the tracer alone on its rays", run);

}  // namespace
}  // namespace isolux::bench
