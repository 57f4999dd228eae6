#include "tests/properties/property_run.h"

#include <chrono>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <random>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/paths.h"

namespace isolux::test {

namespace {

constexpr int kLeastCases = 3, kShrinkTries = 3000;
constexpr const char* kKeptCases = ISOLUX_SOURCE_DIR "/tests/properties/kept_cases.txt";

std::string wrongOf(const Property& property, const PropertyCase& made) {
  try {
    return property(made);
  } catch (const std::exception& error) {
    return std::string("throws: ") + error.what();
  }
}

double secondsOfAll() {
  const char* const text = std::getenv("ISOLUX_PROPERTY_SECONDS");
  return text ? std::strtod(text, nullptr) : 25.0;
}

std::uint64_t seedOfAll() {
  const char* const text = std::getenv("ISOLUX_PROPERTY_SEED");
  if (!text) return 1;
  if (std::string_view(text) != "random") return std::strtoull(text, nullptr, 10);
  std::random_device device;
  return device();
}

std::uint64_t hashOf(const std::string& name) {
  std::uint64_t hash = 0;
  for (const char c : name) hash = base::hash64(hash ^ static_cast<unsigned char>(c));
  return hash;
}

// Of lines "NAME CASE", those of the name.
std::vector<std::string> keptCases(const std::string& name) {
  std::ifstream in(kKeptCases);
  EXPECT_TRUE(in) << kKeptCases;
  std::vector<std::string> kept;
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(name + ' ')) kept.push_back(line.substr(name.size() + 1));
  return kept;
}

}  // namespace

PropertyCase shrunk(const PropertyCase& failing, const Property& property, int tries) {
  PropertyCase simplest = failing;
  for (bool again = true; again;) {
    again = false;
    for (const PropertyCase& next : simplerCases(simplest)) {
      if (tries-- <= 0) return simplest;
      if (wrongOf(property, next).empty()) continue;
      simplest = next;
      again = true;
      break;
    }
  }
  return simplest;
}

void expectHolds(const std::string& name, double share, const Property& property) {
  for (const std::string& kept : keptCases(name)) {
    const std::string wrong = wrongOf(property, parseCase(kept));
    EXPECT_TRUE(wrong.empty()) << "a kept case: " << wrong << '\n' << kept;
  }
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(share * secondsOfAll());
  const std::uint64_t seed = seedOfAll(), own = base::hash64(seed) ^ hashOf(name);
  std::cout << name << ": ISOLUX_PROPERTY_SEED=" << seed << std::endl;
  int cases = 0;
  for (; cases < kLeastCases || Clock::now() < end; ++cases) {
    const PropertyCase made = randomCase(base::counterHash(own, static_cast<std::uint64_t>(cases)));
    const std::string wrong = wrongOf(property, made);
    if (wrong.empty()) continue;
    const PropertyCase simplest = shrunk(made, property, kShrinkTries);
    ADD_FAILURE() << wrongOf(property, simplest) << "\nFor tests/properties/kept_cases.txt:\n"
                  << name << ' ' << textOf(simplest) << "\nFound as case " << cases << " of seed " << seed
                  << ": " << wrong << '\n'
                  << textOf(made);
    return;
  }
  std::cout << name << ": " << cases << " cases" << std::endl;
  ::testing::Test::RecordProperty("cases", cases);
}

}  // namespace isolux::test
