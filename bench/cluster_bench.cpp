// Strong scaling of a bake over MPI: as many threads in all, in one process or in ranks of one thread.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>
#include <nlohmann/json.hpp>

#include "base/quantiles.h"
#include "bench/bench.h"

namespace isolux::bench {

namespace {

namespace fs = std::filesystem;

// Seconds of the bake itself, from its --stats: without loading and the launcher's own second.
double bakeSeconds(const std::string& launcher, int threads, const fs::path& folder) {
  const fs::path isolux = fs::read_symlink("/proc/self/exe").parent_path() / "isolux";
  fs::remove(folder / "light.vti");
  const std::string command = launcher + " '" + isolux.string() +
                              "' bake phantom:gyroid:128 --set gi.samples=64 --out '" +
                              (folder / "light.vti").string() + "' --stats '" +
                              (folder / "light.json").string() + "' --threads " + std::to_string(threads);
  if (std::system((command + (launcher.empty() ? "" : " 2>/dev/null")).c_str()) != 0)
    throw std::runtime_error("failed: " + command);
  std::ifstream stats(folder / "light.json");
  return nlohmann::json::parse(stats).at("bake").at("seconds").get<double>();
}

void runCluster() {
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 0);
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 0);
  const fs::path folder = fs::temp_directory_path() / ("isolux_bench_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  struct Way {
    std::string label, launcher;
    int threads;  // of a rank
  };
  const std::string mpi = "mpirun --oversubscribe --bind-to none ";
  const std::vector<Way> ways{{"alone, 2 threads", "", 2},
                              {"1 rank of 2 threads", mpi + "-n 1", 2},
                              {"2 ranks of 1 thread", mpi + "-n 2", 1}};
  constexpr int rounds = 3;
  std::vector<std::vector<double>> seconds(ways.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < ways.size(); ++i)
      seconds[i].push_back(bakeSeconds(ways[i].launcher, ways[i].threads, folder));
  std::vector<double> medians;
  for (const auto& list : seconds) medians.push_back(1000.0 * base::median(list));
  std::vector<std::string> labels;
  for (const Way& way : ways) labels.push_back(way.label);
  printComparison(labels, medians);
  std::printf("  2 ranks of 1 thread do %.2f of what 1 rank of 2 threads does\n", medians[1] / medians[2]);
  fs::remove_all(folder);
}

const Registration registration("cluster", "a bake over MPI: ranks of one thread against threads of one rank",
                                runCluster);

}  // namespace

}  // namespace isolux::bench
