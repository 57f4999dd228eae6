#include "gi/reference/reference.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <mutex>
#include <numbers>
#include <numeric>
#include <system_error>
#include <thread>

#include <glm/geometric.hpp>

#include "base/color.h"
#include "base/error.h"
#include "gi/sampling/gloss_lobe.h"
#include "gi/trace/exposure_meter.h"
#include "scene/opacity.h"
#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"
#include "volume/field/reconstruct.h"

namespace isolux::gi {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kFewestPointsOfTask = 16, kMostPointsOfTask = 256;

// Runs numbered tasks on a few threads of their own, as many as the system creates; the caller waits. Calls
// body(task) for 0 .. count - 1 until one returns false. Returns true if all returned true. An
// exception of a body ends the other threads after their current task and is rethrown here.
template <class Body>
bool runTasks(std::size_t count, int threads, const Body& body) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> going{true};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      while (going.load(std::memory_order_relaxed)) {
        const std::size_t task = next.fetch_add(1, std::memory_order_relaxed);
        if (task >= count) return;
        if (!body(task)) going = false;
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      going = false;
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (int i = 1; i < threads && static_cast<std::size_t>(i) < count; ++i) others.emplace_back(work);
    } catch (const std::system_error&) {
      // If the system creates no more threads, the existing ones do the work.
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return going;
}

scene::Scene checked(scene::Scene scene) {
  if (!std::ranges::all_of(scene::shownSurfaces(scene), scene::isOpaque<scene::Surface>))
    throw base::Error(
        base::ErrorKind::usage, "", "isosurface.opacity",
        "the reference is of opaque surfaces only: set it to 1, and isosurface.facing_opacity, too");
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

// Of a row, those that are asked for; of no pixels, all.
std::vector<std::uint32_t> columnsOf(std::span<const std::uint32_t> pixels, std::size_t row,
                                     std::size_t width) {
  std::vector<std::uint32_t> columns;
  if (pixels.empty()) {
    columns.resize(width);
    std::iota(columns.begin(), columns.end(), 0u);
    return columns;
  }
  const auto first = std::lower_bound(pixels.begin(), pixels.end(), row * width);
  for (auto pixel = first; pixel != pixels.end() && *pixel < (row + 1) * width; ++pixel)
    columns.push_back(static_cast<std::uint32_t>(*pixel - row * width));
  return columns;
}

std::uint32_t seedOf(std::uint32_t pixel, bool lamps) {
  return 2u * pixel + (lamps ? 1u : 0u);
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
  constexpr std::size_t own = sizeof(int) + sizeof(std::uint32_t);
  constexpr std::size_t image = 2 * sizeof(glm::vec3) + sizeof(float) + sizeof(std::uint32_t) + 1;
  return volume::Extent2{size}.count() * (point + own + image);
}

Reference::Reference(std::shared_ptr<const volume::PreparedVolume> volume,
                     std::shared_ptr<const volume::IsosurfaceTracer> tracer,
                     std::shared_ptr<const Environment> environment, const scene::Scene& resolved,
                     const Options& options, base::Progress& progress)
    : held_(base::machineMemory().reserve(bytesOf(options.size), "a path traced image of this size",
                                          "a smaller one needs less")),
      scene_(checked(resolved)),
      volume_(std::move(volume)),
      size_(options.size),
      threads_(std::max(1, options.threads)),
      hits_(volume_, scene_, options.size, progress) {
  const auto light = makeLightScene(scene_, volume_, tracer, environment);
  light_ = makePictureLight(scene_, *light, projectEnvironment(*light->environment, 1));
  // As a picture of this scene is exposed (app/light/light_planner.cpp).
  if (!scene_.picture.exposure && scene_.picture.metering != scene::Metering::lights &&
      light->choice.traced) {
    scene::Scene metered = scene_;
    if (!options.meterView) metered.camera = {};
    if (const auto seen = measureBrightness(metered, volume_, tracer, environment, progress))
      light_.automaticExposure = static_cast<float>(exposureOf(*seen));
  }
  background_ = light_.background;
  ground_ = makeGroundShadow(scene_, *light, nullptr, progress);
  const auto own = ownSky(*light);
  hasSky_ = !own->environment->isBlack();
  hasLamps_ = !own->lamps.empty();
  tracer_.emplace(own);
  findHits(options, progress);
  if (outerPoints_ < points_.size()) innerTracer_.emplace(innerSideOf(*own, progress));
}

void Reference::findHits(const Options& options, base::Progress& progress) {
  const auto width = static_cast<std::size_t>(size_.x), height = static_cast<std::size_t>(size_.y);
  surfaces_.assign(width * height, -1);
  std::vector<RowPoints> rows(height);
  std::atomic<std::size_t> rowsDone{0};
  const bool finished = runTasks(height, options.threads, [&](std::size_t row) {
    const std::vector<std::uint32_t> columns = columnsOf(options.pixels, row, width);
    if (!findHitsOfRow(row, columns, progress, rows[row])) return false;
    const std::size_t done = ++rowsDone;
    progress.report(static_cast<double>(done) / static_cast<double>(height), "finding the surface");
    return true;
  });
  if (!finished) progress.throwIfStopped();
  for (const std::size_t side : {0u, 1u}) {
    const std::size_t first = points_.size();
    for (const RowPoints& row : rows) {
      points_.insert(points_.end(), row.points[side].begin(), row.points[side].end());
      pixelOf_.insert(pixelOf_.end(), row.pixels[side].begin(), row.pixels[side].end());
    }
    if (side == 0) outerPoints_ = points_.size();
    const std::size_t points = points_.size() - first, parts = 8 * static_cast<std::size_t>(threads_);
    const std::size_t pointsOfTask = std::clamp(points / parts, kFewestPointsOfTask, kMostPointsOfTask);
    for (std::size_t at = first; at < points_.size(); at += pointsOfTask)
      tasks_.push_back({at, std::min(pointsOfTask, points_.size() - at), 0});
  }
  findGloss(rows);
  sky_.resize(points_.size());
  lamps_.resize(points_.size());
}

bool Reference::findHitsOfRow(std::size_t row, std::span<const std::uint32_t> wanted,
                              const base::Progress& progress, RowPoints& found) {
  const auto width = static_cast<std::size_t>(size_.x);
  const volume::Grid& grid = volume_->grid();
  std::vector<PrimaryHit> hits;
  std::vector<glm::vec3> voxels;
  std::vector<std::size_t> columns;
  for (const std::uint32_t column : wanted) {
    if (column % 64 == 0 && progress.stopRequested()) return false;
    const auto hit = hits_.at({static_cast<int>(column), static_cast<int>(row)});
    if (!hit) continue;
    hits.push_back(*hit);
    voxels.emplace_back(hit->voxel);
    columns.push_back(column);
  }
  const std::vector<glm::vec3> gradients = gradientsAt(voxels);
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const PrimaryHit& hit = hits[i];
    const std::size_t pixel = row * width + columns[i];
    surfaces_[pixel] = hit.surface;
    LightPoint point;
    point.voxel = voxels[i];
    point.normal = (hit.outer ? 1.0f : -1.0f) * tracer_->normalOf(gradients[i]);
    if (point.normal == glm::vec3(0.0f))  // taken as if it faced the viewer
      point.normal = -hits_.direction({static_cast<int>(columns[i]), static_cast<int>(row)});
    const double value = scene_.hit.field == scene::Field::trilinear
                             ? hits_.surfaces()[static_cast<std::size_t>(hit.surface)].isovalue
                             : volume::sampleTrilinear(grid, hit.voxel).value;
    point.isovalue = grid.storedIsovalue(value);
    const std::size_t side = hit.outer ? 0 : 1;
    found.points[side].push_back(point);
    if (side == 0)
      found.rays.push_back(hits_.direction({static_cast<int>(columns[i]), static_cast<int>(row)}));
    found.pixels[side].push_back(static_cast<std::uint32_t>(pixel));
  }
  return true;
}

void Reference::findGloss(const std::vector<RowPoints>& rows) {
  if (!scene::showsGloss(scene_)) return;
  glossPoints_.reserve(outerPoints_);
  glossShares_.reserve(outerPoints_);
  for (const RowPoints& row : rows)
    for (std::size_t i = 0; i < row.rays.size(); ++i) {
      const LightPoint& point = row.points[0][i];
      const std::uint32_t pixel = row.pixels[0][i];
      const PrimaryHits::Surface& surface = hits_.surfaces()[static_cast<std::size_t>(surfaces_[pixel])];
      const auto specular = static_cast<float>(surface.specular),
                 roughness = static_cast<float>(surface.roughness);
      // As the renderer takes normals that turn away from the viewer.
      glm::vec3 normal = point.normal;
      const glm::vec3 ray = row.rays[i];
      if (const float away = glm::dot(normal, ray); away > 0.0f) {
        normal -= away * ray;
        normal = glm::length(normal) > 0.0f ? glm::normalize(normal) : -ray;
      }
      const float cosine = std::clamp(-glm::dot(normal, ray), 0.0f, 1.0f);
      glossShares_.push_back(specular > 0.0f ? fresnel(specular, roughness, cosine) : 0.0f);
      glossPoints_.push_back({point.voxel, point.isovalue, normal, ray + 2.0f * cosine * normal,
                              glossExponent(roughness), 2 * pixel});
    }
  gloss_.resize(glossPoints_.size());
}

bool Reference::refineGloss(const Task& task, SampleRange range, std::uint64_t& rays,
                            const std::stop_token& stop) {
  std::vector<GlossPoint> points;
  std::vector<std::size_t> of;
  for (std::size_t i = task.first; i < task.first + task.count; ++i) {
    if (!(glossShares_[i] > 0.0f)) continue;
    points.push_back(glossPoints_[i]);
    of.push_back(i);
  }
  std::vector<RadianceSum> sums(points.size());
  const double skyScale = std::exp2(scene_.light.environment.exposure);
  if (!reflectedRadiance(*tracer_, points, range, skyScale, sums, rays, stop)) return false;
  for (std::size_t k = 0; k < of.size(); ++k) gloss_[of[k]] += sums[k];
  return true;
}

// Stored units per voxel.
std::vector<glm::vec3> Reference::gradientsAt(const std::vector<glm::vec3>& voxels) const {
  std::vector<glm::vec3> gradients(voxels.size());
  const volume::Grid& grid = volume_->grid();
  if (const volume::ScaledField* const scaled = hits_.normalField())
    std::transform(voxels.begin(), voxels.end(), gradients.begin(), [&](glm::vec3 voxel) {
      return glm::vec3(volume::sampleScaled(*scaled, grid, glm::dvec3(voxel)).gradient / grid.slope());
    });
  else
    tracer_->light().tracer->gradients(voxels, gradients);
  return gradients;
}

bool Reference::refineTask(Task& task, std::uint32_t samples, std::uint64_t& rays,
                           const std::stop_token& stop) {
  const std::size_t first = task.first, count = task.count;
  const PathTracer& tracer = first < outerPoints_ ? *tracer_ : *innerTracer_;
  const SampleRange range{task.samples, samples - task.samples};
  std::vector<LightPoint> points(points_.begin() + static_cast<std::ptrdiff_t>(first),
                                 points_.begin() + static_cast<std::ptrdiff_t>(first + count));
  std::vector<glm::vec3> skyMeans(count), lampMeans(count);
  std::vector<float> skyVariances(count), lampVariances(count);
  const auto estimate = [&](LightPart part, std::span<glm::vec3> means, std::span<float> variances) {
    for (std::size_t i = 0; i < count; ++i)
      points[i].seed = seedOf(pixelOf_[first + i], part == LightPart::lamps);
    return tracer.irradiance(part, points, range, means, variances, rays, stop);
  };
  // Both before either is kept: a pixel has as many samples of the one light as of the other.
  if (hasSky_ && !estimate(LightPart::sky, skyMeans, skyVariances)) return false;
  if (hasLamps_ && !estimate(LightPart::lamps, lampMeans, lampVariances)) return false;
  if (first < glossPoints_.size() && !refineGloss(task, range, rays, stop)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    sky_[first + i].merge(skyMeans[i], skyVariances[i], range.count);
    lamps_[first + i].merge(lampMeans[i], lampVariances[i], range.count);
  }
  task.samples = samples;
  return true;
}

bool Reference::refineTo(std::uint32_t samples, base::Progress& progress, double from, double to) {
  std::atomic<std::uint64_t> rays{0};
  std::atomic<std::size_t> done{0};
  const double tasks = static_cast<double>(std::max<std::size_t>(1, tasks_.size()));
  const bool finished = runTasks(tasks_.size(), threads_, [&](std::size_t index) {
    Task& task = tasks_[index];
    std::uint64_t raysOfTask = 0;
    if (task.samples < samples && !refineTask(task, samples, raysOfTask, progress.token())) return false;
    rays += raysOfTask;
    progress.report(std::lerp(from, to, static_cast<double>(++done) / tasks), "tracing light");
    return true;
  });
  rays_ += rays;
  return finished;
}

double Reference::exposure() const {
  return scene_.picture.exposure.value_or(static_cast<double>(light_.automaticExposure));
}

ReferenceImage Reference::image() const {
  ReferenceImage image;
  image.size = size_;
  const std::size_t pixels = surfaces_.size();
  image.irradiance.assign(pixels, glm::vec3(nan));
  image.color.assign(pixels, glm::vec3(nan));
  image.variance.assign(pixels, nan);
  image.samples.assign(pixels, 0);
  image.hit.assign(pixels, 0);
  image.rays = rays_;
  image.cappedPaths = tracer_->cappedPaths() + (innerTracer_ ? innerTracer_->cappedPaths() : 0);
  const double skyScale = std::exp2(scene_.light.environment.exposure);
  const auto exposure = static_cast<float>(std::exp2(this->exposure()));
  if (!gloss_.empty()) {
    image.gloss.assign(pixels, glm::vec3(nan));
    image.glossVariance.assign(pixels, nan);
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::uint32_t pixel = pixelOf_[i];
    const double n = sky_[i].count;
    if (n > 0.0) image.irradiance[pixel] = glm::vec3(skyScale * sky_[i].mean + lamps_[i].mean);
    image.samples[pixel] = static_cast<std::uint32_t>(n);
    if (n > 1.0)
      image.variance[pixel] =
          static_cast<float>((skyScale * skyScale * sky_[i].squares + lamps_[i].squares) / (n - 1.0) / n);
    const glm::vec3 tint = i < outerPoints_ ? glm::vec3(1.0f) : glm::vec3(scene_.look.innerTint);
    const glm::vec3 albedo = hits_.surfaces()[static_cast<std::size_t>(surfaces_[pixel])].albedo * tint;
    image.hit[pixel] = 1;
    image.color[pixel] = albedo * image.irradiance[pixel] * (exposure * std::numbers::inv_pi_v<float>);
    if (i >= gloss_.size() || !(glossShares_[i] > 0.0f) || !(n > 0.0)) continue;
    const RadianceSum& sum = gloss_[i];
    image.gloss[pixel] = glm::vec3((skyScale * sum.sky + sum.lamps) / n);
    if (n > 1.0)
      image.glossVariance[pixel] =
          static_cast<float>((sum.squares - sum.luminance * sum.luminance / n) / (n - 1.0) / n);
    image.color[pixel] = glm::mix(image.color[pixel], exposure * image.gloss[pixel], glossShares_[i]);
  }
  if (ground_) image.ground = groundOfPixels();
  if (!background_) return image;
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (image.hit[pixel]) continue;
    const glm::vec3 direction =
        light_.environmentFromWorld * hits_.backgroundDirection(volume::Extent2{size_}.at(pixel));
    image.color[pixel] = background_->radiance(direction) * (light_.backgroundScale * exposure);
    if (ground_) image.color[pixel] *= image.ground[pixel];
  }
  return image;
}

std::vector<float> Reference::groundOfPixels() const {
  std::vector<float> ground(surfaces_.size(), 1.0f);
  const auto places =
      ground_->placesOf(scene::frameOf(scene_.camera), static_cast<double>(size_.x) / size_.y);
  if (!places) return ground;
  for (std::size_t pixel = 0; pixel < ground.size(); ++pixel) {
    const glm::dvec2 at(volume::Extent2{size_}.at(pixel));
    const glm::dvec2 middle((at.x + 0.5) / size_.x, 1.0 - (at.y + 0.5) / size_.y);
    const glm::dvec3 place = *places * glm::dvec3(2.0 * middle - 1.0, 1.0);
    if (surfaces_[pixel] < 0 && place.z > 0.0) ground[pixel] = ground_->at(glm::dvec2(place) / place.z);
  }
  return ground;
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
