#include "app/study/light_reference.h"

#include <atomic>
#include <cmath>

#include "base/random.h"
#include "gi/trace/path_tracer.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::app {

namespace {

// A call of the tracer: short, so that a stop is heard, and long enough to fill its lanes.
constexpr std::size_t kPointsAtOnce = 16;

using Means = std::vector<glm::dvec3>;  // [point * kReplicates + replicate]

class Estimator {
 public:
  Estimator(const std::shared_ptr<const gi::LightScene>& light, glm::dvec3 skyScale,
            std::vector<gi::LightPoint> points)
      : tracer_(light),
        skyScale_(skyScale),
        sky_(light->choice.sky != scene::GiMode::off || !light->skyShadows),
        lamps_(light->choice.lamps),
        points_(std::move(points)),
        means_(points_.size() * kReplicates, glm::dvec3(0.0)) {}

  // Takes the replicates from `samples_` to `samples` paths.
  void refine(std::uint32_t samples, base::Progress& progress) {
    const gi::SampleRange range{samples_, samples - samples_};
    volume::parallelRanges(points_.size(), kPointsAtOnce, [&](const volume::Indices<std::size_t>& part) {
      for (std::uint32_t r = 0; r < kReplicates; ++r)
        if (!refine(part.begin(), part.end(), r, range, progress)) return;
    });
    progress.throwIfStopped();
    samples_ = samples;
  }

  std::uint32_t samples() const { return samples_; }

  LightReference reference(std::vector<std::size_t> pixels) const {
    LightReference reference{std::move(pixels), {}, {}, std::uint64_t{samples_} * kReplicates, rays_};
    for (std::size_t i = 0; i < points_.size(); ++i) {
      glm::dvec3 mean(0.0), squares(0.0);
      for (std::uint32_t r = 0; r < kReplicates; ++r) mean += means_[i * kReplicates + r];
      mean /= kReplicates;
      for (std::uint32_t r = 0; r < kReplicates; ++r) {
        const glm::dvec3 apart = means_[i * kReplicates + r] - mean;
        squares += apart * apart;
      }
      reference.irradiance.push_back(mean);
      reference.variance.push_back(squares / static_cast<double>(kReplicates * (kReplicates - 1)));
    }
    return reference;
  }

 private:
  bool refine(std::size_t begin, std::size_t end, std::uint32_t replicate, gi::SampleRange range,
              base::Progress& progress) {
    std::vector<gi::LightPoint> points(points_.begin() + static_cast<std::ptrdiff_t>(begin),
                                       points_.begin() + static_cast<std::ptrdiff_t>(end));
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i].seed = base::hash32((begin + i) * kReplicates + replicate);
    std::vector<glm::vec3> light(points.size());
    std::vector<glm::dvec3> sum(points.size(), glm::dvec3(0.0));
    std::uint64_t rays = 0;
    for (const gi::LightPart part : {gi::LightPart::sky, gi::LightPart::lamps}) {
      if (!(part == gi::LightPart::sky ? sky_ : lamps_)) continue;
      if (!tracer_.irradiance(part, points, range, light, {}, rays, progress.token())) return false;
      const glm::dvec3 scale = part == gi::LightPart::sky ? skyScale_ : glm::dvec3(1.0);
      for (std::size_t i = 0; i < points.size(); ++i) sum[i] += scale * glm::dvec3(light[i]);
    }
    rays_ += rays;
    const double before = range.first, added = range.count;
    for (std::size_t i = 0; i < points.size(); ++i) {
      glm::dvec3& mean = means_[(begin + i) * kReplicates + replicate];
      mean = (before * mean + added * sum[i]) / (before + added);
    }
    return true;
  }

  gi::PathTracer tracer_;
  glm::dvec3 skyScale_;
  bool sky_, lamps_;
  std::vector<gi::LightPoint> points_;
  Means means_;
  std::uint32_t samples_ = 0;
  std::atomic<std::uint64_t> rays_{0};
};

// RMS of the standard errors in parts of the mean; 0 where there is no light.
double relativeNoise(const LightReference& reference) {
  double mean = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < reference.pixels.size(); ++i)
    for (int channel = 0; channel < 3; ++channel) {
      mean += reference.irradiance[i][channel];
      variance += reference.variance[i][channel];
    }
  const double values = 3.0 * static_cast<double>(reference.pixels.size());
  return mean > 0.0 ? std::sqrt(variance / values) / (mean / values) : 0.0;
}

}  // namespace

LightReference lightReferenceAt(const std::shared_ptr<const gi::LightScene>& light, glm::dvec3 skyScale,
                                float isovalue, std::span<const glm::vec3> voxels,
                                std::span<const std::size_t> pixels, const LightReferenceOptions& options,
                                base::Progress& progress) {
  std::vector<glm::vec3> gradients(voxels.size());
  light->tracer->gradients(voxels, gradients);
  const gi::PathTracer normals(light);
  std::vector<gi::LightPoint> points;
  std::vector<std::size_t> pixelsOfPoints;
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const glm::vec3 normal = normals.normalOf(gradients[i]);
    if (normal == glm::vec3(0.0f)) continue;
    points.push_back({voxels[i], isovalue, normal, 0});
    pixelsOfPoints.push_back(pixels[i]);
  }
  Estimator estimator(light, skyScale, std::move(points));
  LightReference reference;
  for (std::uint32_t samples = options.firstSamples;; samples *= 2) {
    estimator.refine(samples, progress);
    reference = estimator.reference(pixelsOfPoints);
    if (samples >= options.mostSamples || relativeNoise(reference) <= options.relativeNoise) return reference;
  }
}

bool canBeJudged(const TrueHit& hit) {
  return hit.hit && hit.fromOutside;
}

LightReference lightReferenceOf(scene::Scene scene,
                                const std::shared_ptr<const volume::PreparedVolume>& volume,
                                const std::vector<TrueHit>& hits, std::size_t count,
                                const LightReferenceOptions& options, base::Progress& progress) {
  scene.gi.mode = scene::GiMode::irradiance;
  scene.light.environment.moves = false;
  scene.gi.sequence = scene::DirectionSequence::sobol_owen;
  const auto environment = gi::loadEnvironment(scene.light.environment);
  const auto light =
      gi::makeLightScene(scene, volume, gi::lightTracerOf(scene, volume, progress), environment);
  const double exposure = std::exp2(scene.light.environment.exposure);
  const glm::dvec3 skyScale = light->choice.unitSky ? exposure * environment->mean() : glm::dvec3(exposure);
  std::vector<bool> isHit;
  for (const TrueHit& hit : hits) isHit.push_back(canBeJudged(hit));
  const std::vector<std::size_t> pixels = chosenPixels(isHit, count);
  std::vector<glm::vec3> voxels;
  for (const std::size_t pixel : pixels) voxels.emplace_back(hits[pixel].voxel);
  const auto isovalue = static_cast<float>(volume->grid().storedOfValue(*scene.surfaces.front().value));
  return lightReferenceAt(light, skyScale, isovalue, voxels, pixels, options, progress);
}

std::vector<std::size_t> chosenPixels(const std::vector<bool>& hit, std::size_t count) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < hit.size(); ++i)
    if (hit[i]) all.push_back(i);
  if (all.size() <= count) return all;
  std::vector<std::size_t> chosen;
  const double part = static_cast<double>(all.size()) / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double place = (static_cast<double>(i) + base::hash32(i) * 0x1p-32) * part;
    chosen.push_back(all[std::min(static_cast<std::size_t>(place), all.size() - 1)]);
  }
  return chosen;
}

}  // namespace isolux::app
