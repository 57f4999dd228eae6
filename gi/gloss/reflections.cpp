#include "gi/gloss/reflections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/color.h"
#include "gi/gloss/stored_irradiance.h"
#include "gi/picture_light.h"
#include "gi/trace/path_wave.h"
#include "scene/rules/needs.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::gi {

namespace {

constexpr float kNever = std::numeric_limits<float>::infinity();
constexpr std::size_t kPointsAtOnce = 512;
constexpr float kMostOfMean = 2.0f;          // a brighter ray would count for all around it
constexpr std::uint32_t kFirstLampPair = 1;  // of a pattern; pair 0 is the direction of the lobe
constexpr std::size_t kLamps = 3;            // scene::kLamps

volume::TraceRay rayFrom(const PathSetup& setup, const GlossPoint& point, glm::vec3 way, float tMaximum) {
  const glm::vec3 offset = setup.offsetMm * point.normal;
  return {point.voxel + setup.voxelsOfMm * offset, setup.voxelsOfMm * way, point.isovalue, tMaximum};
}

// The radiance of a light source times its solid angle, without the cosine at the surface.
struct LampRay {
  volume::TraceRay ray;
  glm::vec3 radiance;  // times the solid angle
  float lobe;          // D of its direction, and of that mirrored at the tangent plane
};

bool aimAt(const PathSetup& setup, const GlossPoint& point, int lamp, glm::vec2 u, LampRay& out) {
  const LampSample sample = setup.lamps.sample(lamp, point.voxel, point.normal, u);
  if (sample.irradiance == glm::vec3(0.0f)) return false;
  const glm::vec3 toward = glm::normalize(sample.toward);
  const float cosine = glm::dot(toward, point.normal);
  if (!(cosine > 1e-4f)) return false;
  const glm::vec3 mirrored = toward - 2.0f * cosine * point.normal;
  out.lobe = lobeDensity(point.exponent, glm::dot(toward, point.mirror)) +
             lobeDensity(point.exponent, glm::dot(mirrored, point.mirror));
  out.radiance = sample.irradiance / cosine;
  const glm::vec3 way = sample.distant ? sample.toward : sample.toward - setup.offsetMm * point.normal;
  out.ray = rayFrom(setup, point, way, sample.distant ? kNever : 1.0f);
  return true;
}

glm::vec3 normalAt(const PathSetup& setup, glm::vec3 gradient, glm::vec3 arriving) {
  const glm::vec3 normal = setup.normalOf(gradient);
  return normal == glm::vec3(0.0f) ? -glm::normalize(arriving) : normal;
}

// The rays of the lobe of some points, and where they meet the surface.
struct LobeRays {
  std::vector<volume::TraceRay> rays;
  std::vector<glm::vec3> directions;  // ω
  std::vector<float> t;
  std::vector<std::size_t> hits;  // of the rays
  std::vector<glm::vec3> voxels, gradients;

  void trace(const PathSetup& setup, std::span<const GlossPoint> points, std::uint32_t samples) {
    rays.clear();
    directions.clear();
    for (const GlossPoint& point : points) {
      const PairPattern pattern(setup.light->sequence, point.seed, 0);
      for (std::uint32_t i = 0; i < samples; ++i) {
        directions.push_back(lobeDirection(point.mirror, point.exponent, pattern(point.sample + i)));
        rays.push_back(rayFrom(setup, point, abovePlane(directions.back(), point.normal), kNever));
      }
    }
    t.resize(rays.size());
    setup.light->tracer->firstEntries(rays, t);
    hits.clear();
    voxels.clear();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (!(t[i] < kNever)) continue;
      hits.push_back(i);
      voxels.push_back(rays[i].origin + t[i] * rays[i].direction);
    }
    gradients.resize(voxels.size());
    setup.light->tracer->gradients(voxels, gradients);
  }
};

// The rays from points to samples of a light source.
struct LampRays {
  std::vector<LampRay> aimed;
  std::vector<std::size_t> of;        // points
  std::vector<std::uint8_t> blocked;  // none without shadows

  // Leaves out directions whose D is `least` of the mirror direction's or less.
  LampRays(const PathSetup& setup, std::span<const GlossPoint> points, int lamp, std::uint32_t samples,
           float least) {
    std::vector<volume::TraceRay> rays;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const PairPattern pattern(setup.light->sequence, points[i].seed,
                                kFirstLampPair + static_cast<std::uint32_t>(lamp));
      for (std::uint32_t k = 0; k < samples; ++k) {
        LampRay ray;
        if (!aimAt(setup, points[i], lamp, pattern(points[i].sample + k), ray)) continue;
        if (!(ray.lobe > least * (points[i].exponent + 1.0f))) continue;
        aimed.push_back(ray);
        of.push_back(i);
        rays.push_back(ray.ray);
      }
    }
    blocked.resize(rays.size());
    if (setup.lamps.hasShadows(lamp)) setup.light->tracer->anyEntries(rays, blocked);
  }
};

// Fraction of each light source that the points see, weighted by the lobe.
void addLamps(const PathSetup& setup, std::span<const GlossPoint> points, std::uint32_t samples,
              std::span<Reflection> reflections) {
  for (int lamp = 0; lamp < std::min(setup.lamps.count(), static_cast<int>(kLamps)); ++lamp) {
    if (!setup.lamps.hasShadows(lamp)) continue;
    const LampRays rays(setup, points, lamp, setup.lamps.hasExtent(lamp) ? samples : 1, 1e-6f);
    std::vector<glm::vec2> seen(points.size(), glm::vec2(0.0f));
    for (std::size_t i = 0; i < rays.aimed.size(); ++i)
      seen[rays.of[i]] += rays.aimed[i].lobe * glm::vec2(rays.blocked[i] == 0 ? 1.0f : 0.0f, 1.0f);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (seen[i].y > 0.0f) reflections[i].lamps[lamp] = seen[i].x / seen[i].y;
  }
}

}  // namespace

std::shared_ptr<const FilteredEnvironment> GlossLight::of(float roughness) const {
  const auto found = std::ranges::find(environments, roughness, &FilteredEnvironment::roughness);
  return found == environments.end() ? nullptr : *found;
}

std::shared_ptr<const GlossLight> makeGlossLight(const scene::Scene& resolved,
                                                 std::shared_ptr<const LightScene> light,
                                                 const GlossLight* before) {
  const std::vector<scene::GlossySurface> surfaces = scene::glossySurfaces(resolved);
  if (surfaces.empty()) return nullptr;
  auto gloss = std::make_shared<GlossLight>();
  const bool same = before && before->scene->environment == light->environment;
  for (const scene::GlossySurface& surface : surfaces) {
    const auto roughness = static_cast<float>(surface.roughness);
    if (gloss->of(roughness)) continue;
    auto filtered = same ? before->of(roughness) : nullptr;
    if (!filtered) filtered = std::make_shared<const FilteredEnvironment>(*light->environment, roughness);
    gloss->environments.push_back(std::move(filtered));
  }
  gloss->scene = std::move(light);
  return gloss;
}

bool reflectionsOf(const PictureLight& light, std::span<const GlossPoint> points, std::uint32_t samples,
                   std::span<Reflection> reflections, const std::stop_token& stop) {
  const LightScene& scene = *light.gloss->scene;
  std::fill(reflections.begin(), reflections.end(), Reflection{});
  if (!scene.tracer || points.empty()) return true;
  const PathSetup setup(light.gloss->scene);
  const volume::Grid& grid = scene.volume->grid();
  volume::parallelRanges(points.size(), kPointsAtOnce, [&](const volume::Indices<std::size_t>& range) {
    if (stop.stop_requested()) return;
    const std::span<const GlossPoint> of = points.subspan(range.first, range.size());
    const std::span<Reflection> out = reflections.subspan(range.first, range.size());
    LobeRays lobe;
    lobe.trace(setup, of, samples);
    std::vector<float> most;  // of a ray's luminance
    for (const GlossPoint& point : of)
      most.push_back(kMostOfMean * base::luminance(point.environment->filtered().radiance(
                                       point.mirror * scene.worldFromEnvironment)));
    for (std::size_t i = 0; i < lobe.rays.size(); ++i) {
      const GlossPoint& point = of[i / samples];
      const auto luminanceOf = [&](glm::vec3 direction) {
        const glm::vec3 radiance =
            point.environment->coarse().radiance(direction * scene.worldFromEnvironment);
        return std::min(base::luminance(radiance), most[i / samples]);
      };
      Reflection& reflection = out[i / samples];
      const float open = luminanceOf(lobe.directions[i]);
      reflection.open += open;
      if (lobe.t[i] < kNever && scene.skyShadows) continue;
      const glm::vec3 above = abovePlane(lobe.directions[i], point.normal);
      reflection.visible += above == lobe.directions[i] ? open : luminanceOf(above);
    }
    StoredIrradiance stored(light, setup.lamps);
    for (std::size_t k = 0; k < lobe.hits.size(); ++k) {
      const std::size_t i = lobe.hits[k];
      const glm::vec3 normal =
          normalAt(setup, lobe.gradients[k], abovePlane(lobe.directions[i], of[i / samples].normal));
      const glm::vec3 albedo =
          scene.albedo.at(grid.valueOfStored(static_cast<double>(lobe.rays[i].isovalue)));
      const glm::vec3 reflectance = albedo * std::numbers::inv_pi_v<float>;
      const StoredIrradiance::Lookup lookup = stored.at(lobe.voxels[k], normal);
      Reflection& reflection = out[i / samples];
      reflection.met += 1.0f;
      reflection.hit = lobe.voxels[k];
      reflection.light += lookup.baked * reflectance * lookup.irradiance;
      reflection.baked += lookup.baked;
      if (lookup.baked < 1.0f)
        reflection.unoccluded += reflectance * stored.unoccluded(lobe.voxels[k], normal);
    }
    for (Reflection& reflection : out) {
      if (reflection.met > 0.0f) reflection.unoccluded /= reflection.met;
      reflection.met /= static_cast<float>(samples);
    }
    addLamps(setup, of, samples, out);
  });
  return !stop.stop_requested();
}

bool reflectedRadiance(const PathTracer& paths, std::span<const GlossPoint> points, SampleRange range,
                       double skyScale, std::span<RadianceSum> sums, std::uint64_t& rays,
                       const std::stop_token& stop) {
  const PathSetup& setup = paths.setup();
  const LightScene& scene = *setup.light;
  const volume::Grid& grid = scene.volume->grid();
  LobeRays lobe;
  std::vector<GlossPoint> of(points.begin(), points.end());
  for (std::uint32_t sample = range.first; sample < range.first + range.count; ++sample) {
    if (stop.stop_requested()) return false;
    for (GlossPoint& point : of) point.sample = sample;
    lobe.trace(setup, of, 1);
    rays += lobe.rays.size();
    std::vector<glm::vec3> sky(of.size(), glm::vec3(0.0f)), lamps(of.size(), glm::vec3(0.0f));
    for (std::size_t i = 0; i < of.size(); ++i)
      if ((!(lobe.t[i] < kNever) || !scene.skyShadows) && scene.environment)
        sky[i] = scene.environment->radiance(abovePlane(lobe.directions[i], of[i].normal) *
                                             scene.worldFromEnvironment);
    std::vector<LightPoint> met;
    std::vector<glm::vec3> skyMet(lobe.hits.size()), lampsMet(lobe.hits.size(), glm::vec3(0.0f));
    for (std::size_t k = 0; k < lobe.hits.size(); ++k) {
      const std::size_t i = lobe.hits[k];
      // A pattern of its own for each point; each of its samples meets another point of the surface.
      met.push_back({lobe.voxels[k], of[i].isovalue,
                     normalAt(setup, lobe.gradients[k], abovePlane(lobe.directions[i], of[i].normal)),
                     of[i].seed ^ 0x9e3779b9u});
    }
    const SampleRange one{sample, 1};
    if (!paths.irradiance(LightPart::sky, met, one, skyMet, {}, rays, stop)) return false;
    if (!scene.lamps.empty() && !paths.irradiance(LightPart::lamps, met, one, lampsMet, {}, rays, stop))
      return false;
    for (std::size_t k = 0; k < lobe.hits.size(); ++k) {
      const std::size_t i = lobe.hits[k];
      const glm::vec3 albedo = scene.albedo.at(grid.valueOfStored(static_cast<double>(of[i].isovalue)));
      sky[i] += albedo * skyMet[k] * std::numbers::inv_pi_v<float>;
      lamps[i] = albedo * lampsMet[k] * std::numbers::inv_pi_v<float>;
    }
    for (int lamp = 0; lamp < setup.lamps.count(); ++lamp) {
      const LampRays toLamp(setup, of, lamp, 1, -1.0f);
      if (setup.lamps.hasShadows(lamp)) rays += toLamp.aimed.size();
      for (std::size_t k = 0; k < toLamp.aimed.size(); ++k)
        if (toLamp.blocked[k] == 0) lamps[toLamp.of[k]] += toLamp.aimed[k].radiance * toLamp.aimed[k].lobe;
    }
    for (std::size_t i = 0; i < of.size(); ++i) {
      sums[i].sky += glm::dvec3(sky[i]);
      sums[i].lamps += glm::dvec3(lamps[i]);
      const double luminance = base::luminance(skyScale * glm::dvec3(sky[i]) + glm::dvec3(lamps[i]));
      sums[i].luminance += luminance;
      sums[i].squares += luminance * luminance;
    }
  }
  return true;
}

}  // namespace isolux::gi
