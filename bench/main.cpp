#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>

#include <benchmark/benchmark.h>

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

}  // namespace

std::vector<Section>& sections() {
  static std::vector<Section> list;
  return list;
}

Registration::Registration(std::string name, std::string meaning, std::function<void()> run) {
  sections().push_back({std::move(name), std::move(meaning), std::move(run)});
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
  for (auto& list : times) {
    std::nth_element(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2), list.end());
    result.push_back(list[list.size() / 2]);
  }
  return result;
}

void printComparison(const std::vector<std::string>& labels, const std::vector<double>& milliseconds) {
  for (std::size_t i = 0; i < labels.size(); ++i)
    std::printf("  %-44s %9.2f ms  %5.2fx\n", labels[i].c_str(), milliseconds[i],
                milliseconds[i] / milliseconds[0]);
}

}  // namespace isolux::bench

// isolux_bench [SECTION...]: all sections, or those named.
int main(int argc, char** argv) {
  using isolux::bench::sections;
  auto& list = sections();
  list.push_back({"blocks", "block sizes on the CPU: building, finding active ones, tracing",
                  isolux::bench::runGoogleBenchmarks});
  std::sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  for (int i = 1; i < argc; ++i)
    if (std::none_of(list.begin(), list.end(), [&](const auto& s) { return s.name == argv[i]; })) {
      std::fprintf(stderr, "isolux_bench: no section '%s'; sections:\n", argv[i]);
      for (const auto& section : list)
        std::fprintf(stderr, "  %-12s %s\n", section.name.c_str(), section.meaning.c_str());
      return 2;
    }
  for (const auto& section : list) {
    if (argc > 1 &&
        std::none_of(argv + 1, argv + argc, [&](const char* name) { return section.name == name; }))
      continue;
    std::printf("%s: %s\n", section.name.c_str(), section.meaning.c_str());
    section.run();
    std::fflush(stdout);
  }
  return 0;
}
