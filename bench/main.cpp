#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>

#include <benchmark/benchmark.h>

#include "base/quantiles.h"
#include "bench/bench.h"

namespace isolux::bench {

namespace {

// The Google Benchmarks (block_size_bench.cpp), alternatives in random turns, medians.
void runGoogleBenchmarks() {
  std::string arguments[] = {"isolux_bench", "--benchmark_enable_random_interleaving=true",
                             "--benchmark_repetitions=5", "--benchmark_report_aggregates_only=true"};
  char* pointers[] = {arguments[0].data(), arguments[1].data(), arguments[2].data(), arguments[3].data(),
                      nullptr};
  int count = 4;
  benchmark::Initialize(&count, pointers);
  benchmark::RunSpecifiedBenchmarks();
}

std::filesystem::path& folderForPlots() {
  static std::filesystem::path folder;
  return folder;
}

}  // namespace

std::vector<Section>& sections() {
  static std::vector<Section> list;
  return list;
}

Registration::Registration(std::string name, std::string meaning, std::function<void()> run) {
  sections().push_back({std::move(name), std::move(meaning), std::move(run)});
}

const std::filesystem::path& outputFolder() {
  return folderForPlots();
}

std::vector<double> medians(const std::vector<std::function<void()>>& alternatives, int rounds) {
  std::vector<std::vector<double>> times(alternatives.size());
  for (int round = -1; round < rounds; ++round)
    for (std::size_t i = 0; i < alternatives.size(); ++i) {
      const auto begin = std::chrono::steady_clock::now();
      alternatives[i]();
      const double elapsed =
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
      if (round >= 0) times[i].push_back(elapsed);
    }
  std::vector<double> result;
  for (const auto& list : times) result.push_back(base::median(list));
  return result;
}

void printComparison(const std::vector<std::string>& labels, const std::vector<double>& milliseconds) {
  for (std::size_t i = 0; i < labels.size(); ++i)
    std::printf("  %-44s %9.2f ms  %5.2fx\n", labels[i].c_str(), milliseconds[i],
                milliseconds[i] / milliseconds[0]);
}

// The sections named by the arguments, all if none is. Throws std::invalid_argument.
std::vector<Section> chosen(const std::vector<std::string>& names) {
  std::vector<Section> all = sections();
  all.push_back(
      {"blocks", "block sizes on the CPU: building, finding active ones, tracing", runGoogleBenchmarks});
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  if (names.empty()) return all;
  std::vector<Section> list;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const Section& s) { return s.name == name; });
    if (found == all.end()) {
      std::string known;
      for (const Section& section : all) known += "\n  " + section.name + ": " + section.meaning;
      throw std::invalid_argument("no section '" + name + "'; sections:" + known);
    }
    list.push_back(*found);
  }
  return list;
}

void runAll(std::vector<std::string> arguments) {
  if (const auto out = std::find(arguments.begin(), arguments.end(), "--out"); out != arguments.end()) {
    if (out + 1 == arguments.end()) throw std::invalid_argument("--out needs a folder");
    folderForPlots() = *(out + 1);
    std::filesystem::create_directories(folderForPlots());
    arguments.erase(out, out + 2);
  }
  for (const Section& section : chosen(arguments)) {
    std::printf("%s: %s\n", section.name.c_str(), section.meaning.c_str());
    section.run();
    std::fflush(stdout);
  }
}

}  // namespace isolux::bench

// isolux_bench [--out DIR] [SECTION...]: all sections, or those named.
int main(int argc, char** argv) {
  try {
    isolux::bench::runAll({argv + 1, argv + argc});
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "isolux_bench: %s\n", error.what());
    return 2;
  }
}
