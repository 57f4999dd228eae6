#include "gi/trace/reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/color.h"
#include "base/error.h"
#include "gi/harmonics/spherical_harmonics.h"
#include "gi/sampling/lamp_sampling.h"
#include "gi/trace/parallel_tasks.h"
#include "volume/field/reconstruct.h"

namespace isolux::gi {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kPointsOfTask = 256;

scene::Scene checked(scene::Scene scene) {
  bool opaque = scene.isosurface.opacity >= 1.0;
  for (const scene::ExtraIsosurface& extra : scene.extraIsosurfaces)
    opaque = opaque && (!extra.shown || extra.opacity >= 1.0);
  if (!opaque)
    throw base::Error(base::ErrorKind::usage, "", "isosurface.opacity",
                      "the reference is of opaque surfaces only: set it to 1");
  // What is stored where is nothing to it: the light is that of the scene.
  scene.look.mode = scene::LookMode::gi;
  if (scene.gi.mode != scene::GiMode::vicinity && scene.gi.mode != scene::GiMode::shadow)
    scene.gi.mode = scene::GiMode::irradiance;
  return scene;
}

// Under its own colours instead of a unit sky's, so that variances are of what is shown.
std::shared_ptr<const LightScene> ownSky(const LightScene& light) {
  auto own = std::make_shared<LightScene>(light);
  if (light.choice.unitSky && light.environment)
    own->environment = std::make_shared<const Environment>(Environment::constant(light.environment->mean()));
  own->choice.unitSky = false;
  return own;
}

std::uint32_t seedOf(std::uint32_t pixel, bool lamps) {
  return 2u * pixel + (lamps ? 1u : 0u);
}

// E of a lamp with nothing in its way; one that the horizon cuts counts whole or not at all, as in pictures.
glm::dvec3 unoccluded(const LampLight& lamp, const glm::dvec3& normal, const glm::dvec3& worldMm) {
  if (lamp.kind == scene::LampKind::directional) {
    const double sine2 = (1.0 - lamp.cosHalfAngle) * (1.0 + lamp.cosHalfAngle);
    const double worth = lamp.cosHalfAngle >= 1.0 ? 1.0 : std::numbers::pi * sine2;
    return lamp.power * (worth * std::max(0.0, glm::dot(normal, lamp.toward)));
  }
  const glm::dvec3 toward = lamp.positionMm - worldMm;
  const double square = std::max(glm::dot(toward, toward), 1e-30);
  const double cosine = std::max(0.0, glm::dot(normal, toward) / std::sqrt(square));
  const double radius2 = lamp.radiusMm * lamp.radiusMm;
  if (lamp.kind == scene::LampKind::point) return lamp.power * (cosine / square);
  return lamp.power * (std::numbers::pi * radius2 * cosine / std::max(square, radius2));
}

}  // namespace

void Reference::Estimate::merge(glm::vec3 roundMean, float roundVariance, std::uint32_t roundCount) {
  const double n = roundCount, all = count + n;
  const double value = static_cast<double>(base::luminance(roundMean));
  const double apart = value - luminance;
  squares += static_cast<double>(roundVariance) * (n - 1.0) + apart * apart * count * n / all;
  luminance += apart * n / all;
  mean += (glm::dvec3(roundMean) - mean) * (n / all);
  count = all;
}

std::size_t Reference::bytesOf(glm::ivec2 size) {
  constexpr std::size_t point = sizeof(LightPoint) + 2 * sizeof(Estimate);
  constexpr std::size_t own = sizeof(int) + sizeof(glm::vec3) + sizeof(std::uint32_t);
  constexpr std::size_t image = 2 * sizeof(glm::vec3) + sizeof(float) + sizeof(std::uint32_t) + 1;
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * (point + own + image);
}

Reference::Reference(std::shared_ptr<const volume::PreparedVolume> volume,
                     std::shared_ptr<const volume::IsosurfaceTracer> tracer,
                     std::shared_ptr<const Environment> environment, const scene::Scene& resolved,
                     const Options& options, base::Progress& progress)
    : held_(base::machineMemory().reserve(bytesOf(options.size), "a path traced picture of this size",
                                          "a smaller one needs less")),
      scene_(checked(resolved)),
      volume_(std::move(volume)),
      size_(options.size),
      threads_(std::max(1, options.threads)),
      hits_(volume_, scene_, options.size, progress) {
  const auto light = makeLightScene(scene_, volume_, std::move(tracer), std::move(environment));
  light_ = makePictureLight(scene_, *light, projectEnvironment(*light->environment, 1));
  background_ = light_.background;
  const auto own = ownSky(*light);
  hasSky_ = !own->environment->isBlack();
  hasLamps_ = !own->lamps.empty();
  tracer_.emplace(own);
  findHits(options, progress);
}

void Reference::findHits(const Options& options, base::Progress& progress) {
  const auto width = static_cast<std::size_t>(size_.x), height = static_cast<std::size_t>(size_.y);
  surfaces_.assign(width * height, -1);
  local_.assign(width * height, glm::vec3(nan));
  const volume::Grid& grid = volume_->grid();
  const glm::dmat4& worldFromVoxel = grid.geometry().worldFromVoxel;
  std::vector<std::vector<LightPoint>> pointsOfRow(height);
  std::vector<std::vector<std::uint32_t>> pixelsOfRow(height);
  std::atomic<std::size_t> rowsDone{0};
  const bool finished = runTasks(height, options.threads, [&](std::size_t row) {
    std::vector<PrimaryHit> found;
    std::vector<glm::vec3> voxels;
    std::vector<std::size_t> columns;
    for (std::size_t column = 0; column < width; ++column) {
      if (column % 64 == 0 && progress.stopRequested()) return false;
      const auto hit = hits_.at({static_cast<int>(column), static_cast<int>(row)});
      if (!hit) continue;
      found.push_back(*hit);
      voxels.emplace_back(hit->voxel);
      columns.push_back(column);
    }
    std::vector<glm::vec3> gradients(voxels.size());
    tracer_->light().tracer->gradients(voxels, gradients);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::size_t pixel = row * width + columns[i];
      const glm::vec3 ray = hits_.direction({static_cast<int>(columns[i]), static_cast<int>(row)});
      glm::vec3 outward = tracer_->normalOf(gradients[i]);
      if (outward == glm::vec3(0.0f)) outward = -ray;  // taken as if it faced the viewer
      surfaces_[pixel] = found[i].surface;
      if (!found[i].outer) {
        glm::vec3 normal = -outward;
        const float away = glm::dot(normal, ray);
        if (away > 0.0f) {  // seen edge on
          const glm::vec3 edge = normal - away * ray;
          const float length = glm::length(edge);
          normal = length > 1e-6f ? edge / length : -ray;
        }
        local_[pixel] = localLight(normal, glm::dvec3(worldFromVoxel * glm::dvec4(found[i].voxel, 1.0)));
        continue;
      }
      LightPoint point;
      point.voxel = voxels[i];
      point.normal = outward;
      const double value = scene_.hit.field == scene::Field::trilinear
                               ? hits_.surfaces()[static_cast<std::size_t>(found[i].surface)].isovalue
                               : volume::sampleTrilinear(grid, found[i].voxel).value;
      point.isovalue = static_cast<float>(grid.storedOfValue(value));
      pointsOfRow[row].push_back(point);
      pixelsOfRow[row].push_back(static_cast<std::uint32_t>(pixel));
    }
    const std::size_t done = ++rowsDone;
    progress.report(static_cast<double>(done) / static_cast<double>(height), "finding the surface");
    return true;
  });
  if (!finished) progress.throwIfStopped();
  for (std::size_t row = 0; row < height; ++row) {
    points_.insert(points_.end(), pointsOfRow[row].begin(), pointsOfRow[row].end());
    pixelOf_.insert(pixelOf_.end(), pixelsOfRow[row].begin(), pixelsOfRow[row].end());
  }
  sky_.resize(points_.size());
  lamps_.resize(points_.size());
  samples_.assign((points_.size() + kPointsOfTask - 1) / kPointsOfTask, 0);
}

glm::vec3 Reference::localLight(glm::vec3 normal, glm::dvec3 worldMm) const {
  float basis[9];
  evaluateSh(3, normal, basis);
  glm::vec3 sky(0.0f);
  for (std::size_t i = 0; i < 9; ++i) sky += light_.irradianceSh[i] * basis[i];
  glm::dvec3 lamps(0.0);
  for (const LampLight& lamp : light_.lampLights) lamps += unoccluded(lamp, glm::dvec3(normal), worldMm);
  return glm::max(sky, glm::vec3(0.0f)) + glm::vec3(lamps);
}

bool Reference::refineTask(std::size_t task, std::uint32_t samples, std::uint64_t& rays,
                           const std::stop_token& stop) {
  const std::size_t first = task * kPointsOfTask, count = std::min(kPointsOfTask, points_.size() - first);
  const SampleRange range{samples_[task], samples - samples_[task]};
  std::vector<LightPoint> points(points_.begin() + static_cast<std::ptrdiff_t>(first),
                                 points_.begin() + static_cast<std::ptrdiff_t>(first + count));
  std::vector<glm::vec3> skyMeans(count), lampMeans(count);
  std::vector<float> skyVariances(count), lampVariances(count);
  const auto estimate = [&](LightPart part, std::span<glm::vec3> means, std::span<float> variances) {
    for (std::size_t i = 0; i < count; ++i)
      points[i].seed = seedOf(pixelOf_[first + i], part == LightPart::lamps);
    return tracer_->irradiance(part, points, range, means, variances, rays, stop);
  };
  // Both before either is kept: a pixel has as many samples of the one light as of the other.
  if (hasSky_ && !estimate(LightPart::sky, skyMeans, skyVariances)) return false;
  if (hasLamps_ && !estimate(LightPart::lamps, lampMeans, lampVariances)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    sky_[first + i].merge(skyMeans[i], skyVariances[i], range.count);
    lamps_[first + i].merge(lampMeans[i], lampVariances[i], range.count);
  }
  samples_[task] = samples;
  return true;
}

bool Reference::refineTo(std::uint32_t samples, base::Progress& progress, double from, double to) {
  std::atomic<std::uint64_t> rays{0};
  std::atomic<std::size_t> done{0};
  const double tasks = static_cast<double>(std::max<std::size_t>(1, samples_.size()));
  const bool finished = runTasks(samples_.size(), threads_, [&](std::size_t task) {
    std::uint64_t raysOfTask = 0;
    if (samples_[task] < samples && !refineTask(task, samples, raysOfTask, progress.token())) return false;
    rays += raysOfTask;
    progress.report(std::lerp(from, to, static_cast<double>(++done) / tasks), "tracing light");
    return true;
  });
  rays_ += rays;
  return finished;
}

ReferenceImage Reference::image() const {
  ReferenceImage image;
  image.size = size_;
  const std::size_t pixels = surfaces_.size();
  image.irradiance = local_;
  image.color.assign(pixels, glm::vec3(nan));
  image.variance.assign(pixels, nan);
  image.samples.assign(pixels, 0);
  image.hit.assign(pixels, 0);
  image.rays = rays_;
  image.cappedPaths = tracer_->cappedPaths();
  const double skyScale = std::exp2(scene_.light.environment.exposure);
  const double stops = scene_.picture.exposure.value_or(static_cast<double>(light_.automaticExposure));
  const auto exposure = static_cast<float>(std::exp2(stops));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::uint32_t pixel = pixelOf_[i];
    const double n = sky_[i].count;
    if (n > 0.0) image.irradiance[pixel] = glm::vec3(skyScale * sky_[i].mean + lamps_[i].mean);
    image.samples[pixel] = static_cast<std::uint32_t>(n);
    if (n > 1.0)
      image.variance[pixel] =
          static_cast<float>((skyScale * skyScale * sky_[i].squares + lamps_[i].squares) / (n - 1.0) / n);
  }
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (surfaces_[pixel] >= 0) {
      const bool inner = !std::isnan(local_[pixel].x);
      if (inner) image.variance[pixel] = 0.0f;
      image.hit[pixel] = 1;
      const glm::vec3 albedo = hits_.surfaces()[static_cast<std::size_t>(surfaces_[pixel])].albedo;
      image.color[pixel] = albedo * image.irradiance[pixel] * (exposure * std::numbers::inv_pi_v<float>);
    } else if (background_) {
      const glm::ivec2 at(static_cast<int>(pixel) % size_.x, static_cast<int>(pixel) / size_.x);
      const glm::vec3 direction = light_.environmentFromWorld * hits_.backgroundDirection(at);
      image.color[pixel] = background_->radiance(direction) * (light_.backgroundScale * exposure);
    }
  }
  return image;
}

std::vector<std::uint32_t> referenceRounds(std::uint32_t samples) {
  constexpr std::uint32_t longest = 64;
  std::vector<std::uint32_t> rounds;
  for (std::uint32_t end = 1; end < samples; end = end < longest ? 4 * end : end + longest)
    rounds.push_back(end);
  if (samples > 0) rounds.push_back(samples);
  return rounds;
}

}  // namespace isolux::gi
