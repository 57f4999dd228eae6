#include "bench/papers_light.h"

#include <chrono>
#include <cstdio>
#include <thread>

#include "app/light/light_controller.h"
#include "bench/bench.h"
#include "bench/frame.h"
#include "gi/light_scene.h"
#include "gi/reference/reference.h"

namespace isolux::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int pathsOfPaper[] = {100, 625, 2500, 10000};
constexpr glm::ivec2 sizeOfTable1{900, 900};

double secondsSinceStart(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

struct BakeRow {
  const char* name;
  bool moves;  // the environment: transfer
  scene::GiExtent extent;
  double paperMinutes[4];
  int measured;  // of the four columns, the first: times go with the paths, and the rest would take hours
};
constexpr BakeRow bakeRows[] = {
    {"spherical harmonics, one view", true, scene::GiExtent::view, {0.33, 2.63, 10.6, 48.2}, 2},
    {"spherical harmonics, full texture", true, scene::GiExtent::full, {8.47, 52.8, 210.0, 853.0}, 1},
    {"irradiance, one view", false, scene::GiExtent::view, {0.95, 5.80, 23.7, 98.3}, 2},
    {"irradiance, full texture", false, scene::GiExtent::full, {18.2, 113.0, 450.0, 1806.0}, 1}};
constexpr double paperReferenceMinutes[] = {0.73, 4.51, 18.0, 72.1};

scene::Scene engineScene(const std::filesystem::path& data) {
  scene::Scene scene;
  scene.surfaces.front().value = 80.0;
  scene.look.mode = scene::LookMode::gi;
  scene.light.environment.file = (data / "hdr/grace_cathedral_1k.hdr").string();
  scene.gi.bounces = 1;
  return scene;
}

struct Baked {
  std::unique_ptr<app::LightController> controller;
  double seconds = 0.0;
};

Baked bake(const scene::Scene& scene, Frame& frame, const VolumePointer& volume) {
  base::Progress progress;
  Baked baked{std::make_unique<app::LightController>(app::LightController::Options{}), 0.0};
  const auto begin = Clock::now();
  baked.controller->setScene(scene::resolve(scene, volume->facts), volume);
  baked.controller->setVisible(frame.renderer->hitVoxels());
  baked.controller->finish(progress);
  baked.seconds = secondsSinceStart(begin);
  return baked;
}

void printTimes(const char* name, const double (&paperMinutes)[4], int measured,
                const std::function<double(int paths)>& secondsOf) {
  std::printf("| %s |", name);
  for (int i = 0; i < 4; ++i) {
    if (i < measured)
      std::printf(" %.2f s : %.2f min |", secondsOf(pathsOfPaper[i]), paperMinutes[i]);
    else
      std::printf(" : %g min |", paperMinutes[i]);
    std::fflush(stdout);
  }
  std::printf("\n");
}

double pathTraced(const scene::Scene& scene, const VolumePointer& volume, int paths) {
  base::Progress progress;
  const scene::Scene resolved = scene::resolve(scene, volume->facts);
  const auto environment = gi::loadEnvironment(resolved.light.environment);
  const auto begin = Clock::now();
  const auto tracer = gi::lightTracerOf(resolved, volume, progress);
  const gi::Reference::Options options{sizeOfTable1, static_cast<int>(std::thread::hardware_concurrency())};
  gi::Reference picture(volume, tracer, environment, resolved, options, progress);
  picture.refineTo(static_cast<std::uint32_t>(paths), progress);
  return secondsSinceStart(begin);
}

void printTable1(const render::OffscreenContext& context, const scene::Scene& scene,
                 const VolumePointer& volume) {
  Frame frame(context.gl(), volume, scene);
  frame.request.size = sizeOfTable1;
  frame.renderer->render(frame.scene, frame.request);
  std::printf(
      "\nTable 1, ours : paper (30 processors of 400 MHz), at 100, 625, 2500 and 10 000 paths\n\n"
      "| | 100 | 625 | 2500 | 10 000 |\n|---|---:|---:|---:|---:|\n");
  for (const BakeRow& row : bakeRows) {
    scene::Scene lit = scene;
    lit.light.environment.moves = row.moves;
    lit.gi.extent = row.extent;
    printTimes(row.name, row.paperMinutes, row.measured, [&](int paths) {
      lit.gi.samples = paths;
      return bake(lit, frame, volume).seconds;
    });
  }
  printTimes("path traced picture", paperReferenceMinutes, 1,
             [&](int paths) { return pathTraced(scene, volume, paths); });
}

// Frames of 512 x 512, alternatives in turns, and what the light takes beside the volume.
void printTable2(const render::OffscreenContext& context, const scene::Scene& scene,
                 const VolumePointer& volume) {
  scene::Scene lambert = scene, lambertShadow, phongShadow, irradiance = scene, transfer = scene;
  lambert.look.mode = scene::LookMode::lambert;
  lambertShadow = lambert;
  lambertShadow.look.shadow = 1.0;
  phongShadow = lambertShadow;
  phongShadow.look.mode = scene::LookMode::blinn_phong;
  transfer.light.environment.moves = true;
  for (scene::Scene* lit : {&irradiance, &transfer}) {
    lit->gi.samples = 100;
    lit->gi.extent = scene::GiExtent::full;
  }
  std::vector<Frame> frames;
  std::vector<double> megabytes;
  std::vector<std::unique_ptr<app::LightController>> lights;  // outlive the frames' renderers
  for (const scene::Scene& each : {lambert, lambertShadow, phongShadow, irradiance, transfer}) {
    frames.emplace_back(context.gl(), volume, each);
    Frame& frame = frames.back();
    const std::size_t before = frame.renderer->render(frame.scene, frame.request).gpuBytes;
    megabytes.push_back(0.0);
    if (each.look.mode != scene::LookMode::gi) continue;
    Baked baked = bake(each, frame, volume);
    frame.renderer->setLight(baked.controller->light());
    const std::size_t after = frame.renderer->render(frame.scene, frame.request).gpuBytes;
    megabytes.back() = 1e-6 * static_cast<double>(after - before);
    lights.push_back(std::move(baked.controller));
  }
  const std::vector<double> times = medians({frames.begin(), frames.end()}, 7);
  const char* const names[] = {"diffuse, no shadow", "diffuse, shadow", "Phong, shadow", "irradiance",
                               "spherical harmonics"};
  const char* const paper[] = {"17.0", "8.75", "8.60", "15.6", "11.7"};
  const char* const paperBytes[] = {"0", "0", "0", "9.75 MB", "975 MB"};
  std::printf(
      "\nTable 2, pictures per second of 512 × 512 (paper: 30 processors of 600 MHz), and memory\n\n"
      "| | ours | paper | to the diffuse one | paper | memory | paper "
      "|\n|---|---:|---:|---:|---:|---:|---:|\n");
  for (std::size_t i = 0; i < times.size(); ++i)
    std::printf("| %s | %.1f | %s | %.2f | %.2f | %.1f MB | %s |\n", names[i], 1e3 / times[i], paper[i],
                times[0] / times[i], std::atof(paper[i]) / 17.0, megabytes[i], paperBytes[i]);
}

}  // namespace

void printPapersLight(const render::OffscreenContext& context, const std::filesystem::path& data) {
  const VolumePointer volume = load((data / "volumes/engine_crop.mhd").string());
  const scene::Scene scene = engineScene(data);
  std::printf("\nWyman et al. 2006: engine block under Grace Cathedral, one bounce, %u threads\n",
              std::thread::hardware_concurrency());
  printTable2(context, scene, volume);
  printTable1(context, scene, volume);
}

}  // namespace isolux::bench
