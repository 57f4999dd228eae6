// Benchmarks that compare: alternatives run in turns within one process, and medians are printed with their
// ratio. Times of different runs, machines or loads are not comparable; ratios of one run are.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace isolux::bench {

struct Section {
  std::string name, meaning;
  std::function<void()> run;
};
// Every section, in the order `isolux_bench` runs them.
std::vector<Section>& sections();

// Registers a section before main().
struct Registration {
  Registration(std::string name, std::string meaning, std::function<void()> run);
};

// Where sections write plots and tables (--out DIR); empty: they only print.
const std::filesystem::path& outputFolder();

// The median milliseconds of each alternative over `rounds` interleaved rounds, after one to warm up.
std::vector<double> medians(const std::vector<std::function<void()>>& alternatives, int rounds);

// "  label   12.3 ms   1.00x" lines, ratios to the first.
void printComparison(const std::vector<std::string>& labels, const std::vector<double>& milliseconds);

}  // namespace isolux::bench
