#include "gi/ground/ground_shadow.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/color.h"
#include "base/hash.h"
#include "gi/sampling/directions.h"
#include "gi/sampling/lamp_sampling.h"
#include "scene/opacity.h"
#include "scene/shown_surfaces.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/prepared/surface_reach.h"

namespace isolux::gi {

namespace {

constexpr std::uint32_t kSkyRays = 512, kLampRays = 64;  // of each point; of each light source
constexpr float kSkyShare = 0.5f;  // of the sky's rays towards its bright areas, unless it is constant
// Every so many points of a row are traced; between those whose fractions differ by more, the others, too.
constexpr int kCoarsestStep = 4;
constexpr float kAlike = 0.02f;
constexpr std::uint32_t kJitterPair = 0, kGroundSkyPair = 1, kGroundLampPair = 2;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

double coordinateOf(double u) {
  return u / (1.0 + GroundShadow::kCrowding * (1.0 - std::abs(u)));
}

double latticeOf(double coordinate) {
  const double u =
      coordinate * (1.0 + GroundShadow::kCrowding) / (1.0 + GroundShadow::kCrowding * std::abs(coordinate));
  return 0.5 * (u + 1.0) * (GroundShadow::kPoints - 1);
}

glm::dvec2 placeOf(glm::dvec2 lattice) {
  const glm::dvec2 u = 2.0 * lattice / (GroundShadow::kPoints - 1.0) - 1.0;
  return {coordinateOf(u.x), coordinateOf(u.y)};
}

struct Occluder {
  float isovalue, transmittance;  // stored units
};

std::vector<Occluder> occludersOf(const scene::Scene& resolved, const volume::Grid& grid) {
  std::vector<Occluder> list;
  for (const auto& surface : scene::shownSurfaces(resolved))
    if (const double opacity = scene::meanOpacity(surface.opacity, surface.facingOpacity); opacity > 0.0)
      list.push_back({grid.storedIsovalue(surface.value.value()), static_cast<float>(1.0 - opacity)});
  return list;
}

// The box of the shown surfaces, mm from the ground's middle along right, back and up.
using Bounds = volume::Bounds<glm::dvec3>;

// Places the ground under the surfaces. Returns false if there is none.
bool putUnder(GroundShadow& ground, Bounds& bounds, const scene::Scene& resolved,
              const volume::PreparedVolume& volume, base::Progress& progress) {
  const glm::dvec3 up = scene::upOf(volume.facts.axes), back = -scene::frontOf(volume.facts.axes);
  const glm::dvec3 right = glm::cross(back, up);
  const std::array directions{right, -right, back, -back, up, -up};
  const auto reach = volume::surfaceReach(volume, resolved, directions, progress);
  if (!reach) return false;
  const std::vector<double>& far = *reach;
  const double halfWidth = 0.5 * (far[0] + far[1]), halfDepth = 0.5 * (far[2] + far[3]),
               height = far[4] + far[5];
  const double margin = std::max(2.0 * std::max(halfWidth, halfDepth), height);
  if (!(margin > 0.0)) return false;
  ground.up = up;
  ground.middleMm = 0.5 * (far[0] - far[1]) * right + 0.5 * (far[2] - far[3]) * back - far[5] * up;
  ground.rightMm = (halfWidth + margin) * right;
  ground.backMm = (halfDepth + margin) * back;
  // Between the crossings that the reach is measured at, a surface can be farther by less than a voxel.
  const double voxel = volume.grid().geometry().mostSpacingMm();
  bounds = {{-halfWidth - voxel, -halfDepth - voxel, 0.0},
            {halfWidth + voxel, halfDepth + voxel, height + voxel}};
  return true;
}

class GroundTracer {
 public:
  GroundTracer(const GroundShadow& ground, const Bounds& bounds, const scene::Scene& resolved,
               const LightScene& light, base::Progress& progress)
      : ground_(ground),
        low_(bounds.low),
        high_(bounds.high),
        occluders_(occludersOf(resolved, light.volume->grid())),
        fronts_(light.tracer),
        backs_(light.tracer->otherSide(progress)),
        lamps_(light.lamps, light.volume->grid().geometry()),
        voxelFromWorld_(light.volume->grid().geometry().voxelFromWorld()),
        jitter_(light.sequence, 0, kJitterPair) {
    for (int lamp = 0; lamp < lamps_.count(); ++lamp)
      ofLamps_.emplace_back(light.sequence, 0, kGroundLampPair + static_cast<std::uint32_t>(lamp));
    sampleSky(light, std::exp2(resolved.light.environment.exposure));
    skyShadows_ = resolved.light.environment.shadows;
  }

  // Returns the fraction of the light that reaches a point of the lattice.
  float lightAt(glm::ivec2 point) const {
    thread_local Scratch scratch;
    scratch.rays.clear();
    scratch.worths.clear();
    const glm::dvec2 place = placeOf(point);
    float open = 0.0f, missing = 0.0f;  // all light; what is in the way of it
    addSky(place, scratch, open);
    addLamps(point, scratch, open);
    scratch.reaching.assign(scratch.rays.size(), 1.0f);
    for (const Occluder& occluder : occluders_) dim(occluder, scratch);
    for (std::size_t i = 0; i < scratch.rays.size(); ++i)
      missing += scratch.worths[i] * (1.0f - scratch.reaching[i]);
    return open > 0.0f ? 1.0f - missing / open : 1.0f;
  }

 private:
  struct SkySample {
    glm::vec3 inVoxels, ofGround;  // the direction in voxels per mm, and along right, back and up
    float worth;
  };
  struct Scratch {
    std::vector<volume::TraceRay> rays;
    std::vector<float> worths, reaching;
    std::vector<std::uint8_t> blocked, blockedBehind;
    std::vector<std::size_t> passing;
    std::vector<volume::TraceRay> passingRays;
  };

  // The balance heuristic of gi/trace/path_wave.h. The directions are those of every point.
  void sampleSky(const LightScene& light, double scale) {
    Sky sky{light.environment, light.worldFromEnvironment, static_cast<float>(scale)};
    if (light.choice.unitSky)
      sky.environment = std::make_shared<const Environment>(Environment::constant(light.environment->mean()));
    if (sky.environment->isBlack()) return;
    const float share = sky.environment->isConstant() ? 0.0f : kSkyShare;
    const glm::vec3 up(ground_.up);
    const Frame frame = Frame::about(up);
    const glm::mat3 ofGround = glm::transpose(
        glm::mat3(glm::normalize(ground_.rightMm), glm::normalize(ground_.backMm), ground_.up));
    const glm::mat3 inVoxels(voxelFromWorld_);
    const PairPattern pattern(light.sequence, 0, kGroundSkyPair);
    for (std::uint32_t i = 0; i < kSkyRays; ++i) {
      const glm::vec2 u = pattern(i);
      const glm::vec3 toward = u.x < share
                                   ? sky.sample({u.x / share, u.y}).direction
                                   : frame.toWorld(cosineHemisphere({(u.x - share) / (1.0f - share), u.y}));
      const float cosine = glm::dot(toward, up);
      if (!(cosine > 0.0f)) continue;
      const Environment::Sample seen = sky.lookUp(toward);
      const float density = share * seen.pdf + (1.0f - share) * cosine * std::numbers::inv_pi_v<float>;
      sky_.push_back({inVoxels * toward, ofGround * toward,
                      base::luminance(seen.radiance) * cosine / (density * static_cast<float>(kSkyRays))});
    }
  }

  glm::dvec3 voxelOf(glm::dvec2 place) const {
    const glm::dvec3 world = ground_.middleMm + place.x * ground_.rightMm + place.y * ground_.backMm;
    return {voxelFromWorld_ * glm::dvec4(world, 1.0)};
  }

  void addSky(glm::dvec2 place, Scratch& scratch, float& open) const {
    const glm::vec3 voxel(voxelOf(place));
    const glm::vec3 from(place.x * glm::length(ground_.rightMm), place.y * glm::length(ground_.backMm), 0.0);
    for (const SkySample& sample : sky_) {
      open += sample.worth;
      if (!skyShadows_) continue;
      const glm::vec3 a = (low_ - from) / sample.ofGround, b = (high_ - from) / sample.ofGround;
      const glm::vec3 begin = glm::min(a, b), end = glm::max(a, b);
      if (std::max({begin.x, begin.y, 0.0f}) > std::min({end.x, end.y, end.z})) continue;  // past the box
      scratch.rays.push_back({voxel, sample.inVoxels, 0.0f});
      scratch.worths.push_back(sample.worth);
    }
  }

  // The mean over the square around the point: a hard shadow has a smooth edge.
  void addLamps(glm::ivec2 point, Scratch& scratch, float& open) const {
    const glm::vec3 up(ground_.up);
    const glm::mat3 inVoxels(voxelFromWorld_);
    for (std::size_t lamp = 0; lamp < ofLamps_.size(); ++lamp)
      for (std::uint32_t i = 0; i < kLampRays; ++i) {
        const glm::vec3 voxel(voxelOf(placeOf(glm::dvec2(point) + glm::dvec2(jitter_(i)) - 0.5)));
        const LampSample sample = lamps_.sample(static_cast<int>(lamp), voxel, up, ofLamps_[lamp](i));
        const float worth = base::luminance(sample.irradiance) / static_cast<float>(kLampRays);
        if (!(worth > 0.0f)) continue;
        open += worth;
        if (!lamps_.hasShadows(static_cast<int>(lamp))) continue;
        scratch.rays.push_back({voxel, inVoxels * sample.toward, 0.0f, sample.distant ? kInfinity : 1.0f});
        scratch.worths.push_back(worth);
      }
  }

  void dim(const Occluder& occluder, Scratch& scratch) const {
    for (volume::TraceRay& ray : scratch.rays) ray.isovalue = occluder.isovalue;
    scratch.blocked.resize(scratch.rays.size());
    fronts_->anyEntries(scratch.rays, scratch.blocked);
    // Rays that begin inside, or come in where the volume ends, meet back faces only.
    scratch.passing.clear();
    scratch.passingRays.clear();
    for (std::size_t i = 0; i < scratch.rays.size(); ++i) {
      if (scratch.blocked[i] != 0) continue;
      scratch.passing.push_back(i);
      scratch.passingRays.push_back(scratch.rays[i]);
    }
    scratch.blockedBehind.resize(scratch.passing.size());
    backs_->anyEntries(scratch.passingRays, scratch.blockedBehind);
    for (std::size_t k = 0; k < scratch.passing.size(); ++k)
      if (scratch.blockedBehind[k] != 0) scratch.blocked[scratch.passing[k]] = 1;
    for (std::size_t i = 0; i < scratch.rays.size(); ++i)
      if (scratch.blocked[i] != 0) scratch.reaching[i] *= occluder.transmittance;
  }

  const GroundShadow& ground_;
  glm::vec3 low_, high_;  // Bounds
  std::vector<Occluder> occluders_;
  std::shared_ptr<const volume::IsosurfaceTracer> fronts_, backs_;
  LampSampler lamps_;
  glm::dmat4 voxelFromWorld_;
  PairPattern jitter_;
  std::vector<PairPattern> ofLamps_;
  std::vector<SkySample> sky_;
  bool skyShadows_ = true;
};

// Traces the points in steps of `step`, or interpolates between those of twice the step.
void refine(GroundShadow& ground, const GroundTracer& tracer, int step, base::Progress& progress) {
  constexpr int last = GroundShadow::kPoints - 1;
  const auto lightAt = [&](int x, int y) -> float& {
    return ground.light[static_cast<std::size_t>(y * GroundShadow::kPoints + x)];
  };
  volume::parallelSteps(static_cast<std::size_t>(last / step + 1), progress, {}, [&](std::size_t row) {
    const int y = static_cast<int>(row) * step, up = y % (2 * step);
    for (int x = 0; x <= last; x += step) {
      const int right = x % (2 * step);
      if (step < kCoarsestStep) {
        if (up == 0 && right == 0) continue;
        const std::array around{lightAt(x - right, y - up), lightAt(x + right, y - up),
                                lightAt(x - right, y + up), lightAt(x + right, y + up)};
        const auto [least, most] = std::minmax_element(around.begin(), around.end());
        if (*most - *least <= kAlike) {
          lightAt(x, y) = 0.25f * (around[0] + around[1] + around[2] + around[3]);
          continue;
        }
      }
      if (glm::length(placeOf(glm::ivec2(x, y))) < 1.0) lightAt(x, y) = tracer.lightAt({x, y});
    }
  });
}

void fadeOut(GroundShadow& ground) {
  std::size_t i = 0;
  for (int y = 0; y < GroundShadow::kPoints; ++y)
    for (int x = 0; x < GroundShadow::kPoints; ++x, ++i) {
      const double apart = glm::length(placeOf(glm::ivec2(x, y)));
      const auto fading = static_cast<float>(glm::smoothstep(GroundShadow::kFadesFrom, 1.0, apart));
      ground.light[i] = glm::mix(ground.light[i], 1.0f, fading);
    }
}

}  // namespace

float GroundShadow::at(glm::dvec2 place) const {
  if (!(std::max(std::abs(place.x), std::abs(place.y)) < 1.0)) return 1.0f;
  const glm::dvec2 lattice(latticeOf(place.x), latticeOf(place.y));
  const glm::ivec2 low = glm::min(glm::ivec2(lattice), glm::ivec2(kPoints - 2));
  const glm::vec2 part(lattice - glm::dvec2(low));
  const float* const first = light.data() + low.y * kPoints + low.x;
  return glm::mix(glm::mix(first[0], first[1], part.x), glm::mix(first[kPoints], first[kPoints + 1], part.x),
                  part.y);
}

std::optional<glm::dmat3> GroundShadow::placesOf(const scene::CameraFrame& camera, double aspect) const {
  const glm::dmat3 ofWorld =
      glm::transpose(glm::dmat3(rightMm / glm::dot(rightMm, rightMm), backMm / glm::dot(backMm, backMm), up));
  const glm::dvec3 eye = ofWorld * (camera.eye - middleMm), forward = ofWorld * -camera.back;
  const glm::dvec3 right = ofWorld * (camera.halfHeight * aspect * camera.right),
                   above = ofWorld * (camera.halfHeight * camera.up);
  // Of the ray o + t d, both linear in (x, y, 1): the place is (o.z d - o d.z) / -d.z.
  const auto column = [](glm::dvec3 o, glm::dvec3 d, double w) {
    return glm::dvec3(glm::dvec2(o.z * d - o * d.z), w);
  };
  if (camera.projection == scene::Projection::orthographic) {
    if (!(forward.z < 0.0)) return std::nullopt;
    return glm::dmat3(column(right, forward, 0.0), column(above, forward, 0.0),
                      column(eye, forward, -forward.z));
  }
  if (!(eye.z > 0.0)) return std::nullopt;
  return glm::dmat3(column(eye, right, -right.z), column(eye, above, -above.z),
                    column(eye, forward, -forward.z));
}

std::uint64_t groundKey(const scene::Scene& resolved, const LightScene& light) {
  if (!resolved.gi.ground || !light.choice.wanted) return 0;
  base::Hasher hash;
  const auto add = [&](const auto& vector) {
    for (int i = 0; i < vector.length(); ++i) hash.add(vector[i]);
  };
  const volume::Grid& grid = light.volume->grid();
  hash.add(grid.hash()).add(light.inside).add(light.sequence);
  for (const Occluder& occluder : occludersOf(resolved, grid))
    hash.add(occluder.isovalue).add(occluder.transmittance);
  hash.add(volume::keyOf(light.tracer->hidden())).add(light.tracer->cut().key());
  hash.add(light.choice.unitSky).add(light.environment->hash());
  hash.add(resolved.light.environment.exposure).add(resolved.light.environment.shadows);
  for (int column = 0; column < 3; ++column) add(light.worldFromEnvironment[column]);
  for (const LampLight& lamp : light.lamps) {
    hash.add(lamp.kind).add(lamp.radiusMm).add(lamp.cosHalfAngle).add(lamp.shadows);
    add(lamp.positionMm);
    add(lamp.toward);
    add(lamp.power);
  }
  return std::max<std::uint64_t>(hash, 1);
}

std::shared_ptr<const GroundShadow> makeGroundShadow(const scene::Scene& resolved, const LightScene& light,
                                                     const std::shared_ptr<const GroundShadow>& before,
                                                     base::Progress& progress) {
  const std::uint64_t key = groundKey(resolved, light);
  if (key == 0) return nullptr;
  if (before && before->key == key) return before;
  auto ground = std::make_shared<GroundShadow>();
  ground->key = key;
  Bounds bounds;
  if (!putUnder(*ground, bounds, resolved, *light.volume, progress)) return nullptr;
  constexpr auto points = static_cast<std::size_t>(GroundShadow::kPoints);
  ground->light.assign(points * points, 1.0f);
  const GroundTracer tracer(*ground, bounds, resolved, light, progress);
  for (int step = kCoarsestStep; step > 0; step /= 2) refine(*ground, tracer, step, progress);
  fadeOut(*ground);
  return ground;
}

}  // namespace isolux::gi
