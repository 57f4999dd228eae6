#include "gi/arithmetic.h"

#include <set>
#include <sstream>
#include <string_view>

#include <hwy/targets.h>

#include "base/words.h"

namespace isolux::gi {

namespace {

constexpr std::int64_t kFused = HWY_AVX2 | HWY_AVX3 | HWY_AVX3_DL | HWY_NEON;

void takeTargets(std::int64_t targets) {
  hwy::SetSupportedTargetsForTest(targets);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
}

// Of gi/sampling/batch.cpp, which takes the best of the machine.
std::string kindOfSampling() {
  return (hwy::SupportedTargets() & kFused) != 0 ? "fma" : "no-fma";
}

std::string kindOfTracing(std::string_view target) {
  if (target == "scalar") return "scalar";
  return target == "SSE4" ? "no-fma" : "fma";
}

}  // namespace

std::string joinedArithmetic(const std::string& a, const std::string& b) {
  std::set<std::string> kinds;
  for (const std::string& one : {a, b}) {
    std::istringstream words(one);
    for (std::string word; std::getline(words >> std::ws, word, ',');) kinds.insert(word);
  }
  return base::joined(kinds);
}

std::string arithmeticOf(const volume::IsosurfaceTracer& tracer) {
  return joinedArithmetic(kindOfTracing(tracer.target()), kindOfSampling());
}

NoFusedArithmetic::NoFusedArithmetic() {
  takeTargets(hwy::SupportedTargets() & ~kFused);
}

NoFusedArithmetic::~NoFusedArithmetic() {
  takeTargets(0);  // all that the machine has
}

}  // namespace isolux::gi
