// A volume larger than memory: how long its index and its picture take, what is read and kept of it, and
// whether its hits are right.
//
// ISOLUX_BENCH_VOXELS voxels per axis (512; 2048 writes 17 GB into the folder for temporary files, TMPDIR),
// once as raw voxels and once as OME-Zarr. Values come from a formula, so that an independent search for the
// crossings in extended precision needs no file.
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "bench/bench.h"
#include "bench/frame.h"
#include "render/gl/gl_context.h"
#include "render/passes/view_uniforms.h"
#include "tests/support/rays.h"
#include "tests/support/trilinear_oracle.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::bench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int ramBudgetMb = 1024, gpuBudgetMb = 256;
constexpr int chunkVoxels = 128;  // per axis, of the Zarr array
constexpr int checkedRays = 10000;
constexpr double isovalue = 32768.0;

// Eight periods of a gyroid per axis, as uint16.
class Gyroid {
 public:
  explicit Gyroid(int n) : sine_(static_cast<std::size_t>(n)), cosine_(sine_.size()) {
    for (std::size_t i = 0; i < sine_.size(); ++i) {
      const double x = 16.0 * M_PI * static_cast<double>(i) / n;
      sine_[i] = std::sin(x);
      cosine_[i] = std::cos(x);
    }
  }
  int voxels() const { return static_cast<int>(sine_.size()); }
  std::uint16_t at(std::size_t x, std::size_t y, std::size_t z) const {
    const double g = sine_[x] * cosine_[y] + sine_[y] * cosine_[z] + sine_[z] * cosine_[x];
    return static_cast<std::uint16_t>(std::lround(isovalue + 20000.0 / 1.5 * g));
  }
  // x fastest.
  std::vector<std::uint16_t> box(glm::ivec3 low, glm::ivec3 size) const {
    const auto nx = static_cast<std::size_t>(size.x), ny = static_cast<std::size_t>(size.y);
    std::vector<std::uint16_t> out(nx * ny * static_cast<std::size_t>(size.z));
    volume::parallelEach(size.z, [&](int z) {
      std::size_t i = static_cast<std::size_t>(z) * ny * nx;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
          out[i++] = at(static_cast<std::size_t>(low.x + x), static_cast<std::size_t>(low.y + y),
                        static_cast<std::size_t>(low.z + z));
    });
    return out;
  }

 private:
  std::vector<double> sine_, cosine_;
};

void writeVoxels(std::ofstream& file, const std::vector<std::uint16_t>& voxels) {
  file.write(reinterpret_cast<const char*>(voxels.data()), static_cast<std::streamsize>(2 * voxels.size()));
  if (!file.flush()) throw std::runtime_error("the volume could not be written: is TMPDIR full?");
}

fs::path writeRaw(const Gyroid& gyroid, const fs::path& folder) {
  const int n = gyroid.voxels();
  const std::string size = std::to_string(n);
  std::ofstream(folder / "big.mhd") << "ObjectType = Image\nNDims = 3\nDimSize = " + size + " " + size + " " +
                                           size +
                                           "\nElementType = MET_USHORT\nElementSpacing = 1 1 1\n"
                                           "ElementByteOrderMSB = False\nElementDataFile = big.raw\n";
  std::ofstream file(folder / "big.raw", std::ios::binary);
  for (int z = 0; z < n; z += 16) writeVoxels(file, gyroid.box({0, 0, z}, {n, n, std::min(16, n - z)}));
  return folder / "big.mhd";
}

fs::path writeZarr(const Gyroid& gyroid, const fs::path& folder) {
  const int n = gyroid.voxels(), chunks = (n + chunkVoxels - 1) / chunkVoxels;
  const fs::path image = folder / "big.ome.zarr", array = image / "0";
  fs::create_directories(array);
  std::ofstream(image / ".zgroup") << json{{"zarr_format", 2}};
  json axes = json::array();
  for (const char* name : {"z", "y", "x"})
    axes.push_back({{"name", name}, {"type", "space"}, {"unit", "millimeter"}});
  const json scale{{{"type", "scale"}, {"scale", {1.0, 1.0, 1.0}}}};
  const json level{{"path", "0"}, {"coordinateTransformations", scale}};
  std::ofstream(image / ".zattrs") << json{
      {"multiscales",
       json::array({{{"version", "0.4"}, {"axes", axes}, {"datasets", json::array({level})}}})}};
  std::ofstream(array / ".zarray") << json{
      {"zarr_format", 2}, {"shape", {n, n, n}},    {"chunks", {chunkVoxels, chunkVoxels, chunkVoxels}},
      {"dtype", "<u2"},   {"compressor", nullptr}, {"filters", nullptr},
      {"fill_value", 0},  {"order", "C"},          {"dimension_separator", "."}};
  for (int z = 0; z < chunks; ++z)
    for (int y = 0; y < chunks; ++y)
      for (int x = 0; x < chunks; ++x) {
        std::ofstream file(array / (std::to_string(z) + "." + std::to_string(y) + "." + std::to_string(x)),
                           std::ios::binary);
        const glm::ivec3 low = glm::ivec3(x, y, z) * chunkVoxels;
        std::vector<std::uint16_t> chunk =
            gyroid.box(low, glm::min(glm::ivec3(chunkVoxels), glm::ivec3(n) - low));
        if (low.x + chunkVoxels > n || low.y + chunkVoxels > n || low.z + chunkVoxels > n)
          throw std::runtime_error("ISOLUX_BENCH_VOXELS must be a multiple of 128");
        writeVoxels(file, chunk);
      }
  return image;
}

double secondsOf(const std::string& command) {
  const auto begin = std::chrono::steady_clock::now();
  if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

std::string program() {
  return "'" + (fs::read_symlink("/proc/self/exe").parent_path() / "isolux").string() + "'";
}

// As `isolux render` draws it, and what its --stats say.
void drawAndPrint(const fs::path& volume, const fs::path& folder) {
  const std::string name = "'" + volume.string() + "'";
  const double index = secondsOf(program() + " index " + name + " > /dev/null");
  const double picture =
      secondsOf(program() + " render " + name + " --isovalue 32768 --size 512x512 --out '" +
                (folder / "big.png").string() + "' --stats '" + (folder / "big.json").string() +
                "' --set memory.voxels=file --set memory.ram_budget_mb=" + std::to_string(ramBudgetMb) +
                " --set memory.gpu_budget_mb=" + std::to_string(gpuBudgetMb));
  std::ifstream file(folder / "big.json");
  const json stats = json::parse(file), &parts = stats.at("parts"), &bricks = stats.at("bricks");
  const auto mebibytes = [](const json& bytes) { return bytes.get<double>() / (1 << 20); };
  std::printf(" %s: index in %.1f s, picture of 512 x 512 in %.1f s\n", volume.filename().c_str(), index,
              picture);
  std::printf(
      "  %zu bricks uploaded in %zu slots, %zu replaced; of the file %.0f MiB read in %zu parts of %.0f "
      "MiB\n",
      bricks.at("uploaded").get<std::size_t>(), bricks.at("slots").get<std::size_t>(),
      bricks.at("evicted").get<std::size_t>(), mebibytes(parts.at("file_bytes")),
      parts.at("read").get<std::size_t>(), mebibytes(parts.at("bytes")));
  std::printf("  peak of the process %.0f MiB; budgets %d MiB of voxels and %d MiB of graphics memory\n",
              mebibytes(stats.at("peak_bytes")), ramBudgetMb, gpuBudgetMb);
}

struct Check {
  std::atomic<int> hits{0}, agree{0}, rounding{0}, wrong{0};
};

// The first crossing along a ray in voxel coordinates against the texel of Aov::voxel.
void checkRay(const test::TrilinearOracle& oracle, glm::dvec3 eye, glm::dvec3 direction, bool seen,
              glm::dvec3 hit, Check& check) {
  // What float32 leaves of positions so far from the origin.
  const double rounding = 4.0 * std::ldexp(glm::length(eye), -24);
  const auto agrees = [&](glm::dvec3 from) {
    const std::optional<double> t =
        oracle.firstHit(isovalue, {.origin = from, .direction = direction, .tMinimum = 0.0, .tMaximum = 1e9});
    return t.has_value() == seen && (!seen || glm::length(from + *t * direction - hit) < 0.01);
  };
  check.hits += seen;
  if (agrees(eye)) {
    ++check.agree;
    return;
  }
  // A ray that grazes: one as near as rounding has that answer.
  for (std::uint64_t i = 0; i < 64; ++i)
    if (agrees(eye + rounding * (2.0 * test::randomVector(i, 1) - 1.0))) {
      ++check.rounding;
      return;
    }
  ++check.wrong;
}

void checkHits(const render::OffscreenContext& context, const Gyroid& gyroid, const fs::path& volume) {
  scene::Scene wanted;
  wanted.source.path = volume.string();
  wanted.surfaces.front().value = isovalue;
  scene::HostSettings host;
  host.voxels = scene::VoxelPlace::file;
  host.ramBudgetMb = ramBudgetMb;
  host.memory.layout = scene::MemoryLayout::bricks;
  host.memory.gpuBudgetMb = gpuBudgetMb;
  host.executor = scene::Executor::gpu;
  base::Progress progress;
  const VolumePointer prepared = volume::loadVolume(wanted.source, host, progress);
  Frame frame(context.gl(), prepared, wanted, 1, host);
  frame.request.aovs = {render::Aov::hit, render::Aov::voxel};
  frame.request.color = false;
  frame.changed();
  const render::AovImage hits = frame.renderer->readAov(render::Aov::hit),
                         voxels = frame.renderer->readAov(render::Aov::voxel);
  const render::ViewUniforms view(frame.scene.camera, 1.0, prepared->grid().geometry());
  const int n = gyroid.voxels();
  const test::TrilinearOracle oracle(glm::ivec3(n), [&](glm::ivec3 v) {
    return static_cast<double>(gyroid.at(static_cast<std::size_t>(v.x), static_cast<std::size_t>(v.y),
                                         static_cast<std::size_t>(v.z)));
  });
  Check check;
  volume::parallelEach(checkedRays, [&](int i) {
    const glm::dvec3 random = test::randomVector(static_cast<std::uint64_t>(i), 0);
    const glm::ivec2 pixel(glm::dvec2(random) * glm::dvec2(pictureSize));
    const glm::dvec2 ndc =
        (glm::dvec2(pixel) + 0.5) / glm::dvec2(pictureSize) * glm::dvec2(2.0, -2.0) + glm::dvec2(-1.0, 1.0);
    const glm::dvec3 direction = view.forwardVoxel + ndc.x * view.halfExtent.x * view.rightVoxel +
                                 ndc.y * view.halfExtent.y * view.upVoxel;
    const std::size_t at = static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(pictureSize.x) +
                           static_cast<std::size_t>(pixel.x);
    const float* const voxel = &voxels.values[at * static_cast<std::size_t>(voxels.channels)];
    checkRay(oracle, view.eyeVoxel, direction,
             hits.values[at * static_cast<std::size_t>(hits.channels)] > 0.0f, {voxel[0], voxel[1], voxel[2]},
             check);
  });
  std::printf(
      "  of %d rays against the formula in extended precision (%d hits): %d agree within 0.01 voxels, %d "
      "graze within rounding, %d are wrong\n",
      checkedRays, check.hits.load(), check.agree.load(), check.rounding.load(), check.wrong.load());
}

void run() {
  const char* const asked = std::getenv("ISOLUX_BENCH_VOXELS");
  const int n = asked ? std::atoi(asked) : 512;
  const fs::path folder = fs::temp_directory_path() / ("isolux_bench_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %d^3 voxels of uint16, %.1f GB; %s\n", n, 2e-9 * n * n * n,
              context->description().renderer.c_str());
  try {
    const Gyroid gyroid(n);
    for (const auto& write : {writeRaw, writeZarr}) {
      const fs::path volume = write(gyroid, folder);
      drawAndPrint(volume, folder);
      checkHits(*context, gyroid, volume);
      std::fflush(stdout);
      fs::remove(folder / "big.raw");
    }
  } catch (...) {
    fs::remove_all(folder);
    throw;
  }
  fs::remove_all(folder);
}

const Registration registration("large", "volumes that stay in their file: times, what is read, hits", run);

}  // namespace
}  // namespace isolux::bench
