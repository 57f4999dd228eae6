#include "app/study/study_results.h"

#include <algorithm>
#include <ctime>
#include <limits>
#include <numeric>

#include "base/quantiles.h"

namespace isolux::app {

TimeSpread spreadOfTimes(std::vector<double> times) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (times.empty()) return {nan, nan, nan};
  const double low = base::lowerQuantile(times, 0.25), high = base::upperQuantile(times, 0.75);
  return {base::median(std::move(times)), low, high};
}

bool sameTime(const TimeSpread& a, const TimeSpread& b) {
  return a.low <= b.high && b.low <= a.high;
}

bool variesTooMuch(const TimeSpread& spread) {
  return spread.high >= 2.0 * spread.low;
}

void setMedians(StudySetting& setting) {
  setting.frameMilliseconds = base::median(setting.frameTimes);
  for (const auto& [name, times] : setting.passTimes) setting.passMilliseconds[name] = base::median(times);
}

double processorMilliseconds() {
  return 1000.0 * static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

namespace {

// The time of the passes that make a panel's error.
double milliseconds(const StudySetting& setting, const Panel& panel) {
  double sum = 0.0;
  for (const char* const pass : panel.passes)
    if (const auto found = setting.passMilliseconds.find(pass); found != setting.passMilliseconds.end())
      sum += found->second;
  return sum;
}

// Of each frame, the passes together.
std::vector<double> passSums(const StudySetting& setting, const Panel& panel) {
  std::vector<double> sums;
  for (const char* const pass : panel.passes) {
    const auto found = setting.passTimes.find(pass);
    if (found == setting.passTimes.end()) continue;
    sums.resize(std::max(sums.size(), found->second.size()), 0.0);
    for (std::size_t i = 0; i < found->second.size(); ++i) sums[i] += found->second[i];
  }
  return sums;
}

// Finds what the panel shows its error against, and the times that it is the median of; bytes have none.
std::pair<double, std::vector<double>> costAndTimes(const QualitySetting& quality,
                                                    const StudySetting& setting, const Panel& panel) {
  if (quality.cost == Cost::passes) return {milliseconds(setting, panel), passSums(setting, panel)};
  if (quality.cost == Cost::frameMilliseconds) return {setting.frameMilliseconds, setting.frameTimes};
  const LightCost& light = setting.light.value();
  if (quality.cost == Cost::bakeSeconds) return {light.bakeSeconds, light.bakeTimes};
  if (quality.cost == Cost::lookupMilliseconds) return {light.lookupMilliseconds, light.lookupTimes};
  return {static_cast<double>(light.gpuBytes) / (1024.0 * 1024.0), {}};
}

}  // namespace

double costOf(const QualitySetting& quality, const StudySetting& setting, const Panel& panel) {
  return costAndTimes(quality, setting, panel).first;
}

TimeSpread costSpread(const QualitySetting& quality, const StudySetting& setting, const Panel& panel) {
  auto [cost, times] = costAndTimes(quality, setting, panel);
  if (times.empty()) return {cost, cost, cost};
  const TimeSpread spread = spreadOfTimes(std::move(times));
  return {cost, std::min(cost, spread.low), std::max(cost, spread.high)};
}

const Errors& judged(const StudySetting& setting) {
  return setting.fieldErrors ? *setting.fieldErrors : setting.errors;
}

const StudySetting* cheapest(const QualityStudy& study, double error) {
  const Panel& panel = panelsOf(study.quality)[0];
  const auto errorOf = [&](const StudySetting& setting) { return panel.error(judged(setting)); };
  const auto spreadOf = [&](const StudySetting& setting) {
    return costSpread(study.quality, setting, panel);
  };
  const StudySetting* least = nullptr;
  for (const StudySetting& setting : study.settings)
    if (errorOf(setting) <= error && (!least || spreadOf(setting).median < spreadOf(*least).median))
      least = &setting;
  if (!least) return nullptr;
  const TimeSpread spread = spreadOf(*least);
  const StudySetting* best = least;
  for (const StudySetting& setting : study.settings)
    if (errorOf(setting) < errorOf(*best) && sameTime(spreadOf(setting), spread)) best = &setting;
  return best;
}

const std::array<double, 3>& errorsToReach(Measure measure) {
  // In the order of Measure.
  static constexpr std::array<std::array<double, 3>, 6> errors{{{0.1, 0.01, 0.001},
                                                                {1.0, 0.1, 0.01},
                                                                {0.5, 0.2, 0.1},
                                                                {0.05, 0.02, 0.01},
                                                                {0.05, 0.02, 0.01},
                                                                {0.1, 0.01, 0.001}}};
  return errors[static_cast<std::size_t>(measure)];
}

double timesAsLong(const std::vector<QualityStudy>& studies) {
  double wall = 0.0, processor = 0.0;
  for (const QualityStudy& study : studies)
    for (const StudySetting& setting : study.settings) {
      if (setting.processorTimes.empty()) continue;
      wall += std::accumulate(setting.frameTimes.begin(), setting.frameTimes.end(), 0.0);
      processor += std::accumulate(setting.processorTimes.begin(), setting.processorTimes.end(), 0.0);
    }
  return processor > 0.0 ? wall / processor : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace isolux::app
