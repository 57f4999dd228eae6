#include "gi/trace/path_tracer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "base/color.h"
#include "gi/harmonics/spherical_harmonics.h"
#include "gi/trace/path_wave.h"

namespace isolux::gi {

namespace {

// Mean and sum of squares of one point's estimates, added in the order of their samples.
struct PointSum {
  glm::dvec3 sum{0.0};
  double count = 0.0, mean = 0.0, squares = 0.0;  // of luminance (Welford 1962)

  void add(glm::vec3 light) {
    sum += glm::dvec3(light);
    const double value = static_cast<double>(base::luminance(light));
    count += 1.0;
    const double apart = value - mean;
    mean += apart / count;
    squares += apart * (value - mean);
  }
};

// Calls wave(points' first, points' count, samples) for all paths, in waves of at most kWavePaths; a point's
// samples come in their order.
template <class Wave>
bool inWaves(std::size_t points, SampleRange range, const Wave& wave) {
  if (range.count == 0) return true;
  const auto most = static_cast<std::uint32_t>(kWavePaths);
  const std::size_t pointsAtOnce = std::max<std::size_t>(1, kWavePaths / range.count);
  for (std::size_t first = 0; first < points; first += pointsAtOnce) {
    const std::size_t count = std::min(pointsAtOnce, points - first);
    for (std::uint32_t done = 0; done < range.count; done += most)
      if (!wave(first, count, SampleRange{range.first + done, std::min(most, range.count - done)}))
        return false;
  }
  return true;
}

// Waves keep their memory: a call of a few milliseconds must not ask the system for megabytes.
struct Scratch {
  PathWave wave;
  std::vector<glm::vec3> light;
  std::vector<Escape> escapes;
};
Scratch& scratchOfThread() {
  thread_local Scratch scratch;
  return scratch;
}

}  // namespace

PathTracer::PathTracer(std::shared_ptr<const LightScene> light)
    : setup_(std::make_shared<const PathSetup>(std::move(light))),
      capped_(std::make_shared<std::atomic<std::uint64_t>>(0)) {}

glm::vec3 PathTracer::normalOf(glm::vec3 gradient) const {
  return setup_->normalOf(gradient);
}

const LightScene& PathTracer::light() const {
  return *setup_->light;
}

template <class Each>
bool PathTracer::forEachEstimate(LightPart part, std::span<const LightPoint> points, SampleRange range,
                                 std::uint64_t& rays, const std::stop_token& stop, const Each& each) const {
  const PathSetup& setup = *setup_;
  Scratch& scratch = scratchOfThread();
  PathWave::Counters counters;
  std::vector<glm::vec3> direct(points.size(), glm::vec3(0.0f));
  bool varies = true;  // from sample to sample
  if (part == LightPart::lamps) {
    for (std::size_t first = 0; first < points.size(); first += kWavePaths) {
      const std::size_t count = std::min(kWavePaths, points.size() - first);
      if (!scratch.wave.directLight(setup, points.subspan(first, count),
                                    std::span(direct).subspan(first, count), counters, stop))
        return false;
    }
    varies = setup.lamps.count() > 0 && setup.bounces > 0;
    for (int lamp = 0; lamp < setup.lamps.count(); ++lamp) varies = varies || setup.lamps.hasExtent(lamp);
  } else {
    varies = setup.light->choice.unitSky || (setup.sky.environment && !setup.sky.environment->isBlack());
  }
  const auto wave = [&](std::size_t first, std::size_t count, SampleRange samples) {
    const PathWave::Range paths{points.subspan(first, count), samples};
    scratch.light.resize(paths.paths());
    const bool finished = part == LightPart::sky
                              ? scratch.wave.skyLight(setup, paths, scratch.light, counters, stop)
                              : scratch.wave.lampLight(setup, paths, scratch.light, counters, stop);
    if (!finished) return false;
    const glm::vec3* light = scratch.light.data();
    for (std::size_t point = first; point < first + count; ++point)
      for (std::uint32_t sample = 0; sample < samples.count; ++sample) each(point, direct[point], *light++);
    return true;
  };
  if (varies) {
    if (!inWaves(points.size(), range, wave)) return false;
  } else {
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::uint32_t sample = 0; sample < range.count; ++sample) each(i, direct[i], glm::vec3(0.0f));
  }
  rays += counters.rays;
  capped_->fetch_add(counters.capped, std::memory_order_relaxed);
  return true;
}

bool PathTracer::irradiance(LightPart part, std::span<const LightPoint> points, SampleRange range,
                            std::span<glm::vec3> means, std::span<float> variances, std::uint64_t& rays,
                            const std::stop_token& stop) const {
  assert(means.size() == points.size() && (variances.empty() || variances.size() == points.size()));
  std::vector<PointSum> sums(points.size());
  std::vector<glm::vec3> constant(points.size(), glm::vec3(0.0f));
  const auto add = [&](std::size_t point, glm::vec3 direct, glm::vec3 light) {
    constant[point] = direct;
    sums[point].add(light);
  };
  if (!forEachEstimate(part, points, range, rays, stop, add)) return false;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointSum& sum = sums[i];
    means[i] = constant[i];
    if (sum.count > 0.0) means[i] += glm::vec3(sum.sum / sum.count);
    if (!variances.empty())
      variances[i] = sum.count > 1.0 ? static_cast<float>(sum.squares / (sum.count - 1.0)) : 0.0f;
  }
  return true;
}

bool PathTracer::addIrradiance(LightPart part, std::span<const LightPoint> points, SampleRange range,
                               int channels, std::span<double> sums, std::uint64_t& rays,
                               const std::stop_token& stop) const {
  assert(sums.size() == points.size() * static_cast<std::size_t>(channels));
  const auto add = [&](std::size_t point, glm::vec3 direct, glm::vec3 light) {
    double* const sum = sums.data() + point * static_cast<std::size_t>(channels);
    for (int c = 0; c < channels; ++c)
      sum[c] += static_cast<double>(direct[c]) + static_cast<double>(light[c]);
  };
  return forEachEstimate(part, points, range, rays, stop, add);
}

bool PathTracer::addTransfer(std::span<const LightPoint> points, SampleRange range, std::span<double> sums,
                             std::uint64_t& rays, const std::stop_token& stop) const {
  const PathSetup& setup = *setup_;
  const int order = setup.light->shOrder, channels = setup.light->choice.channels;
  const auto terms = static_cast<std::size_t>(shTerms(order));
  const std::size_t components = terms * static_cast<std::size_t>(channels);
  assert(sums.size() == points.size() * components);
  Scratch& scratch = scratchOfThread();
  PathWave::Counters counters;
  const auto wave = [&](std::size_t first, std::size_t count, SampleRange samples) {
    const PathWave::Range paths{points.subspan(first, count), samples};
    if (!scratch.wave.escapes(setup, paths, scratch.escapes, counters, stop)) return false;
    float basis[shTerms(maxShOrder)];
    for (const Escape& escape : scratch.escapes) {
      if (escape.throughput == glm::vec3(0.0f)) continue;
      evaluateSh(order, escape.direction, basis);
      double* const sum = sums.data() + (first + escape.path / samples.count) * components;
      for (int channel = 0; channel < channels; ++channel)
        for (std::size_t i = 0; i < terms; ++i)
          sum[static_cast<std::size_t>(channel) * terms + i] +=
              static_cast<double>(escape.throughput[channel] * basis[i]);
    }
    return true;
  };
  if (!inWaves(points.size(), range, wave)) return false;
  rays += counters.rays;
  capped_->fetch_add(counters.capped, std::memory_order_relaxed);
  return true;
}

}  // namespace isolux::gi
