// Blocks of 4^3 against 8^3 cells: what they cost to build and to keep, how tightly they enclose the surface,
// and what a CPU ray pays for them. Both sizes run in the same process, on the same data and rays.
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include <benchmark/benchmark.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/test_data.h"
#include "volume/hit/exact_hit.h"
#include "volume/phantom/phantom.h"
#include "volume/read/reader.h"
#include "volume/skip/min_max_blocks.h"

namespace {

using namespace isolux;

struct Subject {
  std::shared_ptr<const volume::Grid> grid;
  double isovalue = 0.0;
};

// 0: gyroid 256^3; 1: CT of a head at bone (without the data folder the head phantom). Loaded once.
const Subject& subject(std::int64_t which) {
  static std::map<std::int64_t, Subject> loaded;
  if (const auto found = loaded.find(which); found != loaded.end()) return found->second;
  base::Progress progress;
  const std::filesystem::path folder = test::dataFolder();
  Subject made;
  if (which == 1 && !folder.empty()) {
    const auto path = folder / "volumes" / "ct_head_skin_bone.nii.gz";
    made.grid = volume::readVolume(path.string(), volume::ReadOptions(), progress).grid;
    made.isovalue = made.grid->valueOfStored(130.0);
  } else {
    const std::string text = which == 1 ? "head:256" : "gyroid:256";
    made.grid = std::make_shared<volume::Grid>(volume::makePhantom(volume::parsePhantom(text), progress));
    made.isovalue = which == 1 ? 300.0 : 0.0;
  }
  return loaded[which] = made;
}

void label(benchmark::State& state) {
  state.SetLabel((state.range(0) == 0 ? "gyroid 256" : "CT head, bone") + std::string(", blocks of ") +
                 std::to_string(state.range(1)) + "^3");
}

void buildBlocks(benchmark::State& state) {
  const Subject& data = subject(state.range(0));
  base::Progress progress;
  std::size_t bytes = 0;
  for (auto run : state) {
    const volume::MinMaxBlocks blocks(*data.grid, static_cast<int>(state.range(1)), progress);
    bytes = blocks.count() * 2 * sizeof(float);
    benchmark::DoNotOptimize(bytes);
  }
  state.counters["bytes"] = static_cast<double>(bytes);
  label(state);
}

void findActiveBlocks(benchmark::State& state) {
  const Subject& data = subject(state.range(0));
  base::Progress progress;
  const volume::MinMaxBlocks blocks(*data.grid, static_cast<int>(state.range(1)), progress);
  const auto isovalue = data.grid->storedIsovalue(data.isovalue);
  std::vector<std::uint8_t> flags;
  std::size_t active = 0;
  for (auto run : state) benchmark::DoNotOptimize(active = blocks.activeBlocks(isovalue, flags));
  // Cells of active blocks (those at the upper border are smaller) as a fraction of all cells.
  const glm::ivec3 cells = data.grid->dims() - 1;
  double covered = 0.0;
  for (int z = 0; z < blocks.dims().z; ++z)
    for (int y = 0; y < blocks.dims().y; ++y)
      for (int x = 0; x < blocks.dims().x; ++x) {
        if (flags[blocks.index({x, y, z})] == 0) continue;
        const glm::ivec3 low = glm::ivec3(x, y, z) * blocks.blockCells();
        const glm::dvec3 size(glm::min(low + blocks.blockCells(), cells) - low);
        covered += size.x * size.y * size.z;
      }
  state.counters["active_blocks"] = static_cast<double>(active);
  state.counters["active_cells_percent"] =
      100.0 * covered /
      (static_cast<double>(cells.x) * static_cast<double>(cells.y) * static_cast<double>(cells.z));
  label(state);
}

// Rays of a camera outside, one after the other over a square of 256 x 256.
void traceRays(benchmark::State& state) {
  const Subject& data = subject(state.range(0));
  base::Progress progress;
  const volume::MinMaxBlocks blocks(*data.grid, static_cast<int>(state.range(1)), progress);
  const glm::dvec3 size(data.grid->dims() - 1), centre = size * 0.5;
  const glm::dvec3 eye = centre + glm::length(size) * glm::normalize(glm::dvec3(0.6, 1.0, 0.35));
  const glm::dvec3 forward = glm::normalize(centre - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0, 0, 1))),
                   up = glm::cross(right, forward);
  constexpr std::uint64_t side = 256;
  std::uint64_t ray = 0;
  std::size_t hits = 0;
  for (auto run : state) {
    const double u = static_cast<double>(ray % side) / side - 0.5,
                 v = static_cast<double>(ray / side % side) / side - 0.5;
    const glm::dvec3 direction = glm::normalize(forward + u * right + v * up);
    hits += volume::firstHit(*data.grid, blocks, data.isovalue, {eye, direction}) ? 1 : 0;
    ++ray;
  }
  state.counters["hits_percent"] = 100.0 * static_cast<double>(hits) / static_cast<double>(ray);
  state.SetItemsProcessed(static_cast<std::int64_t>(ray));
  label(state);
}

BENCHMARK(buildBlocks)->ArgsProduct({{0, 1}, {4, 8}})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(findActiveBlocks)->ArgsProduct({{0, 1}, {4, 8}})->Unit(benchmark::kMicrosecond);
// Whole pictures, so that every run traces the same rays.
BENCHMARK(traceRays)->ArgsProduct({{0, 1}, {4, 8}})->Iterations(2 * 256 * 256)->Unit(benchmark::kMicrosecond);

}  // namespace
