#include "gi/trace/path_wave.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gi/sampling/directions.h"
#include "volume/field/reconstruct.h"

namespace isolux::gi {

namespace {

constexpr float kPiFloat = std::numbers::pi_v<float>;
constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::size_t kTracedAtOnce = 2048;  // rays between looks at the stop token: about a millisecond

// Which numbers of a path's pattern serve what: pair 0 is the first direction.
constexpr std::uint32_t directionPair(std::uint32_t depth) {
  return 2 * depth;
}
constexpr std::uint32_t lampPair(std::uint32_t depth) {
  return 2 * depth + 1;
}
constexpr std::uint32_t firstLampPair(int lamp) {  // all lamps of the first vertex are sampled
  return 0x10000u + static_cast<std::uint32_t>(lamp);
}
constexpr std::uint32_t rouletteDimension(std::uint32_t depth) {
  return 2 * depth;
}
constexpr std::uint32_t choiceDimension(std::uint32_t depth) {
  return 2 * depth + 1;
}

float largest(glm::vec3 v) {
  return std::max({v.x, v.y, v.z});
}

volume::TraceRay rayFrom(const PathSetup& setup, glm::vec3 voxel, glm::vec3 normal, glm::vec3 direction,
                         float isovalue) {
  return {voxel + setup.voxelsOfMm * (setup.offsetMm * normal), setup.voxelsOfMm * direction, isovalue,
          infinity};
}

glm::vec3 finite(glm::vec3 light) {  // radiance near the largest float times pi
  return glm::min(light, glm::vec3(1e37f));
}

}  // namespace

PathSetup::PathSetup(std::shared_ptr<const LightScene> lightScene)
    : light(std::move(lightScene)), lamps(light->lamps, light->volume->grid().geometry()) {
  const volume::Grid& grid = light->volume->grid();
  const glm::dmat3 mmOfVoxels(grid.geometry().worldFromVoxel);
  const glm::dmat3 inverse = glm::inverse(mmOfVoxels);
  voxelsOfMm = glm::mat3(inverse);
  const bool towardLess = (light->inside == scene::Inside::above) == (grid.slope() > 0.0);
  const double shortest = grid.geometry().leastSpacingMm();
  normalOfGradient = glm::mat3(glm::transpose(inverse) * (towardLess ? -shortest : shortest));
  offsetMm = kOffsetVoxels * static_cast<float>(shortest);
  sky.environment = light->environment;
  sky.worldFromEnvironment = light->worldFromEnvironment;
  if (light->choice.unitSky) sky.environment = nullptr;
  share = sky.environment ? static_cast<float>(light->environmentShare) : 0.0f;
  bounces = std::clamp(light->bounces, 0, kMostBounces);
}

glm::vec3 PathSetup::normalOf(glm::vec3 gradient) const {
  const float scale = std::max({std::abs(gradient.x), std::abs(gradient.y), std::abs(gradient.z)});
  if (!(scale > 0.0f) || !std::isfinite(scale)) return glm::vec3(0.0f);
  const glm::vec3 normal = normalOfGradient * (gradient / scale);
  const float length = glm::length(normal);
  return length > 0.0f && std::isfinite(length) ? normal / length : glm::vec3(0.0f);
}

struct PathWave::Job {
  const PathSetup& setup;
  const Range& range;
  Counters& counters;
  const std::stop_token& stop;
  float share;  // of directions drawn from the sky

  const LightPoint& pointOf(std::uint32_t path) const { return range.points[path / range.samples.count]; }
  std::uint32_t sampleOf(std::uint32_t path) const {
    return range.samples.first + path % range.samples.count;
  }
  std::uint32_t sampleOf(const Vertex& vertex) const {
    return range.samples.first + (vertex.path - vertex.point * range.samples.count);
  }
  glm::vec2 pair(std::uint32_t path, std::uint32_t number) const {
    return samplePair(setup.light->sequence, pointOf(path).seed, sampleOf(path), number);
  }
  float one(std::uint32_t path, std::uint32_t dimension) const {
    return sampleOne(setup.light->sequence, pointOf(path).seed, sampleOf(path), dimension);
  }
};

void PathWave::start(const Job& job) {
  vertices_.resize(job.range.paths());
  std::uint32_t path = 0;
  for (std::uint32_t i = 0; i < job.range.points.size(); ++i) {
    const LightPoint& point = job.range.points[i];
    for (std::uint32_t sample = 0; sample < job.range.samples.count; ++sample, ++path)
      vertices_[path] = {path, i, point.voxel, point.normal, glm::vec3(1.0f)};
  }
  albedos_.resize(job.range.points.size());
  const volume::Grid& grid = job.setup.light->volume->grid();
  for (std::size_t i = 0; i < albedos_.size(); ++i) {
    const double isovalue = grid.valueOfStored(static_cast<double>(job.range.points[i].isovalue));
    albedos_[i] = glm::clamp(job.setup.light->albedo.at(isovalue), 0.0f, 1.0f);
  }
}

// A direction for every vertex: a shadow ray to the sky, or a departure.
void PathWave::depart(const Job& job, std::uint32_t depth) {
  departures_.clear();
  rays_.clear();
  toSky_.clear();
  skyRays_.clear();
  for (std::size_t first = 0; first < vertices_.size(); first += kBatch)
    departBatch(job, depth, std::span(vertices_).subspan(first, std::min(kBatch, vertices_.size() - first)));
}

void PathWave::departBatch(const Job& job, std::uint32_t depth, std::span<const Vertex> vertices) {
  const float share = job.share, rest = 1.0f - share;
  std::size_t skies = 0, cosines = 0;
  PairPattern pattern;
  std::uint32_t patternOf = ~0u;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vertex& vertex = vertices[i];
    if (vertex.point != patternOf) {
      patternOf = vertex.point;
      pattern = {job.setup.light->sequence, job.range.points[patternOf].seed, directionPair(depth)};
    }
    const glm::vec2 u = pattern(job.sampleOf(vertex));
    // Both are written and one is kept: which one nobody could foretell.
    const std::size_t toSky = u.x < share ? 1 : 0;
    batch_.toSky[skies] = batch_.byCosine[cosines] = static_cast<std::uint32_t>(i);
    batch_.skyPairs.x[skies] = std::min(u.x / share, 1.0f - 0x1p-24f);
    batch_.cosinePairs.x[cosines] = std::min((u.x - share) / rest, 1.0f - 0x1p-24f);
    batch_.skyPairs.y[skies] = batch_.cosinePairs.y[cosines] = u.y;
    batch_.normals.set(cosines, vertex.normal);
    skies += toSky;
    cosines += 1 - toSky;
  }
  aimAtSky(job, vertices, skies);
  aimByCosine(job, vertices, cosines);
}

void PathWave::aimAtSky(const Job& job, std::span<const Vertex> vertices, std::size_t count) {
  if (count == 0) return;
  const PathSetup& setup = job.setup;
  const Sky& sky = setup.sky;
  const float share = job.share;
  sampleBatch(sky.environment->tables(), batch_.skyPairs, count, batch_.sky);
  std::size_t end = skyRays_.size();
  skyRays_.resize(end + count);
  toSky_.resize(end + count);
  for (std::size_t k = 0; k < count; ++k) {
    const Vertex& vertex = vertices[batch_.toSky[k]];
    const glm::vec3 direction = sky.worldFromEnvironment * batch_.sky.direction[k];
    const glm::vec3 radiance = sky.environment->pixels()[batch_.sky.pixel[k]] * sky.scale;
    const float cosine = glm::dot(vertex.normal, direction);
    const float density = share * batch_.sky.pdf[k] + (1.0f - share) * cosine / kPiFloat;
    toSky_[end] = {vertex.path, finite(vertex.throughput * (cosine / density) * radiance)};
    skyRays_[end] =
        rayFrom(setup, vertex.voxel, vertex.normal, direction, job.range.points[vertex.point].isovalue);
    end += cosine > 0.0f ? 1 : 0;  // else the next one takes its place
  }
  skyRays_.resize(end);
  toSky_.resize(end);
}

void PathWave::aimByCosine(const Job& job, std::span<const Vertex> vertices, std::size_t count) {
  const PathSetup& setup = job.setup;
  cosineBatch(batch_.cosinePairs, batch_.normals, count, batch_.directions, batch_.cosines);
  const float scale = kPiFloat / (1.0f - job.share);
  for (std::size_t k = 0; k < count; ++k) {
    const Vertex& vertex = vertices[batch_.byCosine[k]];
    const glm::vec3 direction = batch_.directions[k];
    departures_.push_back(
        {vertex.path, vertex.point, direction, vertex.throughput * scale, batch_.cosines[k]});
    rays_.push_back(
        rayFrom(setup, vertex.voxel, vertex.normal, direction, job.range.points[vertex.point].isovalue));
  }
}

bool PathWave::traceFirst(const Job& job) {
  t_.resize(rays_.size());
  for (std::size_t i = 0; i < rays_.size(); i += kTracedAtOnce) {
    if (job.stop.stop_requested()) return false;
    const std::size_t count = std::min(kTracedAtOnce, rays_.size() - i);
    if (job.setup.light->traced) job.setup.light->traced(std::span(rays_).subspan(i, count), false);
    job.setup.light->tracer->firstEntries(std::span(rays_).subspan(i, count),
                                          std::span(t_).subspan(i, count));
  }
  job.counters.rays += rays_.size();
  return true;
}

bool PathWave::traceAny(const Job& job, std::span<const volume::TraceRay> rays) {
  hit_.resize(rays.size());
  for (std::size_t i = 0; i < rays.size(); i += kTracedAtOnce) {
    if (job.stop.stop_requested()) return false;
    const std::size_t count = std::min(kTracedAtOnce, rays.size() - i);
    if (job.setup.light->traced) job.setup.light->traced(rays.subspan(i, count), true);
    job.setup.light->tracer->anyEntries(rays.subspan(i, count), std::span(hit_).subspan(i, count));
  }
  job.counters.rays += rays.size();
  return true;
}

// The departures that hit become the vertices of bounce `depth`, less what is absorbed.
void PathWave::arrive(const Job& job, std::uint32_t depth) {
  const PathSetup& setup = job.setup;
  const bool roulette = depth >= static_cast<std::uint32_t>(std::max(0, setup.light->rouletteDepth));
  vertices_.clear();
  voxels_.clear();
  for (std::size_t i = 0; i < departures_.size(); ++i) {
    if (!(t_[i] < infinity)) continue;
    const Departure& departure = departures_[i];
    const glm::vec3 albedo = albedos_[departure.point];
    const float survival = roulette ? largest(albedo) : 1.0f;
    if (roulette && survival < 1.0f && job.one(departure.path, rouletteDimension(depth)) >= survival)
      continue;
    const glm::vec3 throughput = departure.throughput * albedo / (kPiFloat * survival);
    if (!(largest(throughput) > 0.0f)) continue;
    const glm::vec3 voxel = rays_[i].origin + t_[i] * rays_[i].direction;
    vertices_.push_back({departure.path, departure.point, voxel, departure.direction, throughput});
    voxels_.push_back(voxel);
  }
  gradients_.resize(voxels_.size());
  setup.light->tracer->gradients(voxels_, gradients_);
  const volume::Grid& grid = setup.light->volume->grid();
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const glm::vec3 arriving = vertices_[i].normal;
    glm::vec3 normal = setup.normalOf(gradients_[i]);
    if (!(glm::dot(normal, arriving) < 0.0f)) {
      const glm::dvec3 cell = volume::sampleTrilinear(grid, glm::dvec3(voxels_[i])).gradient / grid.slope();
      normal = setup.normalOf(glm::vec3(cell));
      if (!(glm::dot(normal, arriving) < 0.0f)) normal = -arriving;
    }
    vertices_[i].normal = normal;
  }
}

// Calls lit(i) for the rays to the sky, escaped(list) for the departures that nothing is in the way of, at
// most kBatch at once; without shadows, for all.
template <class Lit, class Escaped>
bool PathWave::follow(const Job& job, const Lit& lit, const Escaped& escaped) {
  start(job);
  const auto end = static_cast<std::uint32_t>(job.setup.bounces);
  const bool shadows = job.setup.light->skyShadows;
  for (std::uint32_t depth = 0; !vertices_.empty(); ++depth) {
    const bool last = depth == end;
    depart(job, depth);
    if (!toSky_.empty()) {
      if (shadows && !traceAny(job, skyRays_)) return false;
      for (std::size_t i = 0; i < toSky_.size(); ++i)
        if (!shadows || hit_[i] == 0) lit(i);
    }
    if (last ? shadows && !traceAny(job, rays_) : !traceFirst(job)) return false;
    std::uint32_t out[kBatch];
    std::size_t waiting = 0, all = 0;
    for (std::uint32_t i = 0; i < departures_.size(); ++i) {
      out[waiting] = i;
      waiting += (!shadows || (last ? hit_[i] == 0 : !(t_[i] < infinity))) ? 1 : 0;
      if (waiting < kBatch) continue;
      escaped(std::span<const std::uint32_t>(out, waiting));
      all += std::exchange(waiting, 0);
    }
    escaped(std::span<const std::uint32_t>(out, waiting));
    all += waiting;
    if (depth == kMostBounces) job.counters.capped += departures_.size() - (shadows ? all : 0);
    if (last) break;
    arrive(job, depth + 1);
  }
  return true;
}

bool PathWave::skyLight(const PathSetup& setup, const Range& range, std::span<glm::vec3> light,
                        Counters& counters, const std::stop_token& stop) {
  std::fill(light.begin(), light.end(), glm::vec3(0.0f));
  const auto lit = [&](std::size_t i) { light[toSky_[i].path] += toSky_[i].worth; };
  const Sky& sky = setup.sky;
  const auto escaped = [&](std::span<const std::uint32_t> list) {
    if (!sky.environment) {
      for (const std::uint32_t i : list) light[departures_[i].path] += finite(departures_[i].throughput);
      return;
    }
    for (std::size_t k = 0; k < list.size(); ++k)
      batch_.sky.direction.set(k, departures_[list[k]].direction * sky.worldFromEnvironment);
    lookUpBatch(sky.environment->tables(), list.size(), batch_.sky);
    for (std::size_t k = 0; k < list.size(); ++k) {
      const Departure& departure = departures_[list[k]];
      const glm::vec3 radiance = sky.environment->pixels()[batch_.sky.pixel[k]] * sky.scale;
      const float byCosine = (1.0f - setup.share) * departure.cosine / kPiFloat;
      const float weight = byCosine / (byCosine + setup.share * batch_.sky.pdf[k]);
      light[departure.path] +=
          finite(departure.throughput * (setup.share > 0.0f ? radiance * weight : radiance));
    }
  };
  return follow({setup, range, counters, stop, setup.share}, lit, escaped);
}

bool PathWave::escapes(const PathSetup& setup, const Range& range, std::vector<Escape>& escapes,
                       Counters& counters, const std::stop_token& stop) {
  const bool atMostOne = setup.light->skyShadows;  // of a path
  escapes.assign(atMostOne ? range.paths() : 0, Escape{});
  const auto escaped = [&](std::span<const std::uint32_t> list) {
    for (const std::uint32_t i : list) {
      const Escape escape{departures_[i].path, departures_[i].throughput, departures_[i].direction};
      if (atMostOne)
        escapes[escape.path] = escape;
      else
        escapes.push_back(escape);
    }
  };
  if (!follow(
          {setup, range, counters, stop, 0.0f}, [](std::size_t) {}, escaped))
    return false;
  if (!atMostOne)
    std::stable_sort(escapes.begin(), escapes.end(),
                     [](const Escape& a, const Escape& b) { return a.path < b.path; });
  return true;
}

// Samples a lamp from the vertex: adds its light, or a shadow ray to where it shines and what that is worth.
void PathWave::aim(const Job& job, const Vertex& vertex, int lamp, glm::vec2 u, glm::vec3 throughput,
                   std::span<glm::vec3> light) {
  const PathSetup& setup = job.setup;
  const LampSample sample = setup.lamps.sample(lamp, vertex.voxel, vertex.normal, u);
  const glm::vec3 worth = finite(throughput * sample.irradiance);
  if (!(largest(worth) > 0.0f)) return;
  if (!setup.lamps.hasShadows(lamp)) {
    light[vertex.path] += worth;
    return;
  }
  const glm::vec3 offset = setup.offsetMm * vertex.normal;
  const glm::vec3 toward = sample.distant ? sample.toward : sample.toward - offset;
  departures_.push_back({vertex.path, vertex.point, toward, worth, 0.0f});
  rays_.push_back({vertex.voxel + setup.voxelsOfMm * offset, setup.voxelsOfMm * toward,
                   job.pointOf(vertex.path).isovalue, sample.distant ? infinity : 1.0f});
}

// Traces the shadow rays that are aimed.
bool PathWave::lightUp(const Job& job, std::span<glm::vec3> light) {
  if (!traceAny(job, rays_)) return false;
  for (std::size_t i = 0; i < departures_.size(); ++i)
    if (hit_[i] == 0) light[departures_[i].path] += departures_[i].throughput;
  departures_.clear();
  rays_.clear();
  return true;
}

// The light of the lamps that have an extent, or of those that have none, at the points themselves.
bool PathWave::lightPoints(const Job& job, bool extended, std::span<glm::vec3> light) {
  const LampSampler& lamps = job.setup.lamps;
  std::fill(light.begin(), light.end(), glm::vec3(0.0f));
  start(job);
  departures_.clear();
  rays_.clear();
  for (int lamp = 0; lamp < lamps.count(); ++lamp) {
    if (lamps.hasExtent(lamp) != extended) continue;
    for (const Vertex& vertex : vertices_)
      aim(job, vertex, lamp, extended ? job.pair(vertex.path, firstLampPair(lamp)) : glm::vec2(0.5f),
          glm::vec3(1.0f), light);
    if (!lightUp(job, light)) return false;
  }
  return true;
}

bool PathWave::directLight(const PathSetup& setup, std::span<const LightPoint> points,
                           std::span<glm::vec3> light, Counters& counters, const std::stop_token& stop) {
  const Range range{points, {0, 1}};
  return lightPoints({setup, range, counters, stop, 0.0f}, false, light);
}

bool PathWave::lampLight(const PathSetup& setup, const Range& range, std::span<glm::vec3> light,
                         Counters& counters, const std::stop_token& stop) {
  const Job job{setup, range, counters, stop, 0.0f};
  const LampSampler& lamps = setup.lamps;
  if (!lightPoints(job, true, light)) return false;
  const auto end = static_cast<std::uint32_t>(setup.bounces);
  for (std::uint32_t depth = 1; depth <= end && !vertices_.empty(); ++depth) {
    depart(job, depth - 1);
    if (!traceFirst(job)) return false;
    arrive(job, depth);
    departures_.clear();
    rays_.clear();
    for (const Vertex& vertex : vertices_) {
      float probability = 1.0f;
      const float u = lamps.count() > 1 ? job.one(vertex.path, choiceDimension(depth)) : 0.5f;
      const int lamp = lamps.choose(vertex.voxel, vertex.normal, u, probability);
      if (lamp < 0) continue;
      const glm::vec2 pair = lamps.hasExtent(lamp) ? job.pair(vertex.path, lampPair(depth)) : glm::vec2(0.5f);
      aim(job, vertex, lamp, pair, vertex.throughput / probability, light);
    }
    if (!lightUp(job, light)) return false;
    if (depth == kMostBounces) counters.capped += vertices_.size();
  }
  return true;
}

}  // namespace isolux::gi
