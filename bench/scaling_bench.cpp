// What a frame costs against the size of the volume: one surface sampled at 64^3 to 512^3 voxels, the same
// picture. Its blocks grow with the square of the edge, its voxels with the cube; a frame should grow no
// faster than the blocks. `--out DIR` writes DIR/scaling.tsv and, by gnuplot, the plot DIR/scaling.svg.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "bench/bench.h"
#include "bench/pass_times.h"
#include "render/gl/gl_context.h"
#include "tests/support/paths.h"

namespace isolux::bench {
namespace {

constexpr int rounds = 7;
constexpr int edges[] = {64, 128, 256, 512};  // voxels

// The exponent p of value ~ edge^p between two sizes.
double growth(double from, double to, int fromEdge, int toEdge) {
  return std::log(to / from) / std::log(static_cast<double>(toEdge) / fromEdge);
}

void print(const std::vector<PassTimes>& times) {
  std::printf("  %5s %10s %8s", "edge", "blocks", "frame");
  for (const auto& [name, milliseconds] : times[0].passes) std::printf(" %8s", name.c_str());
  std::printf("  (ms)   us per block\n");
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::printf("  %5d %10zu %8.2f", edges[i], times[i].activeBlocks, times[i].frame);
    for (const auto& pass : times[i].passes) std::printf(" %8.2f", pass.second);
    std::printf("         %8.2f\n", 1e3 * times[i].frame / static_cast<double>(times[i].activeBlocks));
  }
  const std::size_t last = times.size() - 1;
  for (const std::size_t from : {std::size_t{0}, last - 1})
    std::printf("  from %d to %d: voxels ~ edge^3, blocks ~ edge^%.2f, frame ~ edge^%.2f\n", edges[from],
                edges[last],
                growth(static_cast<double>(times[from].activeBlocks),
                       static_cast<double>(times[last].activeBlocks), edges[from], edges[last]),
                growth(times[from].frame, times[last].frame, edges[from], edges[last]));
}

void plot(const std::vector<PassTimes>& times, const std::filesystem::path& folder) {
  const std::filesystem::path table = folder / "scaling.tsv", picture = folder / "scaling.svg";
  std::ofstream file(table);
  file << "# edge\tactive blocks\tframe ms\n";
  for (std::size_t i = 0; i < times.size(); ++i)
    file << edges[i] << '\t' << times[i].activeBlocks << '\t' << times[i].frame << '\n';
  file.close();
  const std::string command = "gnuplot -c '" ISOLUX_SOURCE_DIR "/bench/scaling.gp' '" + table.string() +
                              "' '" + picture.string() + "'";
  if (std::system(command.c_str()) == 0)
    std::printf("  plot: %s\n", picture.c_str());
  else
    std::printf("  no plot: gnuplot failed or is not installed; the figures are in %s\n", table.c_str());
}

void run() {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf(" %s; gyroid, 512 x 512, every pass of every frame\n", context->description().renderer.c_str());
  std::vector<Frame> frames;
  for (const int edge : edges) {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    frames.emplace_back(context->gl(), load("phantom:gyroid:" + std::to_string(edge)), scene);
  }
  const std::vector<PassTimes> times = passTimes(frames, rounds);
  print(times);
  if (!outputFolder().empty()) plot(times, outputFolder());
}

const Registration registration("scaling", "frame time against the size of the volume", run);

}  // namespace
}  // namespace isolux::bench
