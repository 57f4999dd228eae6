#include "gi/trace/exposure_meter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "base/color.h"
#include "base/quantiles.h"
#include "gi/trace/path_tracer.h"
#include "gi/trace/primary_hits.h"
#include "scene/rules/automatic.h"
#include "scene/rules/needs.h"

namespace isolux::gi {

namespace {

constexpr int kRaysPerAxis = 40;
constexpr std::uint32_t kPaths = 16;         // of each point
constexpr int kMostBouncesMetered = 3;       // more change little
constexpr double kHighlightPart = 0.98;      // of the points are darker
constexpr double kReflectance = 0.6;         // of the surface that appears as kMiddle
constexpr double kMeasureReflectance = 0.8;  // of colours that stand for numbers, whose map must stay legible

// Luminance of the picture, linear: sRGB 157, 105 and 230 of 255.
constexpr double kMiddle = 0.339, kDarkestMiddle = 0.141, kBrightest = 0.791;
constexpr double kMostOver = 4.0;    // times kBrightest: of a few highlights over a dark surface
constexpr double kMostStops = 40.0;  // the range of picture.exposure

std::vector<LightPoint> pointsSeen(const PathTracer& paths, const PrimaryHits& hits, const volume::Grid& grid,
                                   const base::Progress& progress) {
  std::vector<LightPoint> points;
  std::vector<glm::vec3> voxels;
  for (int y = 0; y < kRaysPerAxis; ++y) {
    progress.throwIfStopped();
    for (int x = 0; x < kRaysPerAxis; ++x) {
      const std::optional<PrimaryHit> hit = hits.at({x, y});
      if (!hit || !hit->outer) continue;
      const PrimaryHits::Surface& surface = hits.surfaces()[static_cast<std::size_t>(hit->surface)];
      LightPoint& point = points.emplace_back();
      point.voxel = glm::vec3(hit->voxel);
      point.isovalue = grid.storedIsovalue(surface.isovalue);
      point.seed = static_cast<std::uint32_t>(2 * (y * kRaysPerAxis + x));
      voxels.push_back(point.voxel);
    }
  }
  std::vector<glm::vec3> gradients(voxels.size());
  paths.light().tracer->gradients(voxels, gradients);
  for (std::size_t i = 0; i < gradients.size(); ++i) points[i].normal = paths.normalOf(gradients[i]);
  return points;
}

std::vector<glm::vec3> irradianceOf(const PathTracer& paths, LightPart part, std::vector<LightPoint> points,
                                    const base::Progress& progress) {
  std::vector<glm::vec3> means(points.size(), glm::vec3(0.0f));
  for (LightPoint& point : points) point.seed += part == LightPart::lamps ? 1 : 0;
  std::uint64_t rays = 0;
  if (!paths.irradiance(part, points, {0, kPaths}, means, {}, rays, progress.token()))
    progress.throwIfStopped();
  return means;
}

bool showsReflectance(const scene::Scene& scene) {
  return !scene::isMeasure(scene.look.mode);
}

}  // namespace

scene::Scene meteredScene(const scene::Scene& resolved) {
  scene::Scene scene;
  scene.isosurface = resolved.isosurface;
  scene.surfaces = resolved.surfaces;
  scene.pieces = resolved.pieces;
  scene.clip = resolved.clip;
  scene.look.mode = showsReflectance(resolved) ? scene::LookMode::gi : scene::LookMode::mean_curvature;
  scene.look.shading = scene::Shading::gi;
  scene.light.environment = resolved.light.environment;
  scene.light.environment.moves = scene.light.environment.visible = false;
  scene.lamps = resolved.lamps;
  scene.gi.mode = resolved.gi.mode;
  if (scene.gi.mode != scene::GiMode::vicinity && scene.gi.mode != scene::GiMode::shadow)
    scene.gi.mode = scene::GiMode::irradiance;
  scene.gi.bounces = std::min(resolved.gi.bounces, kMostBouncesMetered);
  scene.gi.rouletteDepth = resolved.gi.rouletteDepth;
  scene.picture.metering = resolved.picture.metering;
  if (resolved.camera.eye && resolved.picture.metering != scene::Metering::brightness)
    scene.camera = resolved.camera;
  else
    scene.camera.frames = scene::Frames::volume;  // from the front, whatever is framed
  return scene;
}

std::optional<SurfaceBrightness> measureBrightness(
    const scene::Scene& resolved, const std::shared_ptr<const volume::PreparedVolume>& volume,
    std::shared_ptr<const volume::IsosurfaceTracer> tracer, std::shared_ptr<const Environment> environment,
    base::Progress& progress) {
  const scene::Scene scene = scene::resolve(meteredScene(resolved), volume->facts);
  const auto light = makeLightScene(scene, volume, tracer, environment);
  const PathTracer paths(light);
  const PrimaryHits hits(volume, scene, glm::ivec2(kRaysPerAxis), progress);
  const std::vector<LightPoint> points = pointsSeen(paths, hits, volume->grid(), progress);
  if (points.empty()) {
    if (!resolved.camera.eye || resolved.picture.metering == scene::Metering::brightness) return std::nullopt;
    scene::Scene front = resolved;
    front.camera = {};
    return measureBrightness(front, volume, std::move(tracer), std::move(environment), progress);
  }
  const std::vector<glm::vec3> sky = irradianceOf(paths, LightPart::sky, points, progress);
  std::vector<glm::vec3> lamps(sky.size(), glm::vec3(0.0f));
  if (!light->lamps.empty()) lamps = irradianceOf(paths, LightPart::lamps, points, progress);
  const glm::dvec3 skyScale = std::exp2(scene.light.environment.exposure) *
                              (light->choice.unitSky ? light->environment->mean() : glm::dvec3(1.0));
  const auto reflectanceAt = [&](const LightPoint& point) {
    if (!showsReflectance(scene)) return glm::dvec3(kMeasureReflectance);
    if (scene.picture.metering != scene::Metering::brightness) return glm::dvec3(kReflectance);
    return glm::dvec3(light->albedo.at(volume->grid().valueOfStored(static_cast<double>(point.isovalue))));
  };
  std::vector<double> luminances;
  for (std::size_t i = 0; i < sky.size(); ++i) {
    const glm::dvec3 irradiance = skyScale * glm::dvec3(sky[i]) + glm::dvec3(lamps[i]);
    luminances.push_back(base::luminance(reflectanceAt(points[i]) * irradiance) / std::numbers::pi);
  }
  const double highlight = base::quantile(luminances, kHighlightPart);
  return SurfaceBrightness{base::median(std::move(luminances)), highlight};
}

double exposureOf(const SurfaceBrightness& seen) {
  if (!(seen.highlight > 0.0)) return 0.0;
  const double limit = kBrightest / seen.highlight;
  const double middle = std::max(std::min(kMiddle / seen.median, limit), kDarkestMiddle / seen.median);
  return std::clamp(std::log2(std::min(kMostOver * limit, middle)), -kMostStops, kMostStops);
}

}  // namespace isolux::gi
