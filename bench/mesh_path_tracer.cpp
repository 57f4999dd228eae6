#include "bench/mesh_path_tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/random.h"
#include "volume/field/reconstruct.h"

namespace isolux::bench {

namespace {

constexpr double pi = std::numbers::pi;

double weightOf(glm::vec3 radiance) {
  return (static_cast<double>(radiance.r) + radiance.g + radiance.b) / 3.0;
}

// A column and a row of the probe, as gi/sampling/environment.h says where its pixels look.
struct ProbePixel {
  int column, row;
};

ProbePixel probePixelOf(const gi::Environment& probe, glm::dvec3 d) {
  const double polar = std::acos(std::clamp(d.z, -1.0, 1.0)) / pi;
  const double turn = std::atan2(d.x, d.y) / (2.0 * pi) + 0.5;
  return {std::clamp(static_cast<int>(turn * probe.width()), 0, probe.width() - 1),
          std::clamp(static_cast<int>(polar * probe.height()), 0, probe.height() - 1)};
}

}  // namespace

struct MeshPathTracer::Hit {
  glm::dvec3 voxel, normal;
};

struct MeshPathTracer::Random {
  std::uint64_t seed, counter = 0;
  double operator()() { return base::uniformNoise(seed, counter++); }
};

MeshPathTracer::MeshPathTracer(std::shared_ptr<const gi::LightScene> light, Triangles mesh, double isovalue)
    : light_(std::move(light)),
      mesh_(std::move(mesh)),
      albedo_(light_->albedo.at(isovalue)),
      worldFromEnvironment_(light_->worldFromEnvironment),
      embree_(mesh_, RTC_SCENE_FLAG_ROBUST) {
  const glm::dmat3 worldFromVoxel(light_->volume->grid().geometry().worldFromVoxel);
  voxelFromWorld_ = glm::inverse(worldFromVoxel);
  offset_ = 0.1 * std::min({glm::length(worldFromVoxel[0]), glm::length(worldFromVoxel[1]),
                            glm::length(worldFromVoxel[2])});
  normals_.reserve(mesh_.points.size());
  for (const glm::vec3& point : mesh_.points) normals_.push_back(normalAt(point));
  const gi::Environment& probe = *light_->environment;
  double sum = 0.0;
  for (int row = 0; row < probe.height(); ++row)
    for (int column = 0; column < probe.width(); ++column) {
      const auto pixel = static_cast<std::size_t>(row) * probe.width() + column;
      sum += weightOf(probe.pixels()[pixel]) * probe.solidAngle(row);
      below_.push_back(sum);
    }
}

glm::dvec3 MeshPathTracer::normalAt(glm::dvec3 voxel) const {
  const glm::dvec3 gradient =
      glm::transpose(voxelFromWorld_) * volume::sampleCubic(light_->volume->grid(), voxel).gradient;
  const double sign = light_->inside == scene::Inside::above ? -1.0 : 1.0;
  const double length = glm::length(gradient);
  return length > 0.0 ? sign / length * gradient : glm::dvec3(0.0, 0.0, 1.0);
}

// The first triangle that is met from outside.
bool MeshPathTracer::firstEntry(glm::dvec3 voxel, glm::dvec3 worldDirection, Hit& hit) const {
  const glm::dvec3 direction = glm::normalize(voxelFromWorld_ * worldDirection);
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(voxel.x), query.ray.org_y = static_cast<float>(voxel.y),
  query.ray.org_z = static_cast<float>(voxel.z);
  query.ray.dir_x = static_cast<float>(direction.x), query.ray.dir_y = static_cast<float>(direction.y),
  query.ray.dir_z = static_cast<float>(direction.z);
  query.ray.mask = ~0u;
  for (float from = 0.0f;; from = query.ray.tfar + 1e-4f) {
    query.ray.tnear = from;
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    embree_.intersect(query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    const std::uint32_t* const corner = &mesh_.corners[3 * static_cast<std::size_t>(query.hit.primID)];
    const double u = query.hit.u, v = query.hit.v;
    const glm::dvec3 normal =
        (1.0 - u - v) * normals_[corner[0]] + u * normals_[corner[1]] + v * normals_[corner[2]];
    // The triangle's own side, turned as its corners' normals are.
    const glm::dvec3 own =
        glm::cross(glm::dvec3(mesh_.points[corner[1]]) - glm::dvec3(mesh_.points[corner[0]]),
                   glm::dvec3(mesh_.points[corner[2]]) - glm::dvec3(mesh_.points[corner[0]]));
    const glm::dvec3 outward = glm::transpose(glm::inverse(voxelFromWorld_)) * normal;
    const double facing = glm::dot(own, direction) * (glm::dot(own, outward) < 0.0 ? -1.0 : 1.0);
    if (facing >= 0.0 || !(glm::length(normal) > 0.0)) continue;
    hit.voxel = voxel + static_cast<double>(query.ray.tfar) * direction;
    hit.normal = glm::normalize(normal);
    return true;
  }
}

// One path's estimate of E.
glm::dvec3 MeshPathTracer::direct(glm::dvec3 voxel, glm::dvec3 normal, Random& random, bool bounces) const {
  const gi::Environment& probe = *light_->environment;
  const glm::dvec3 start = voxel + voxelFromWorld_ * (offset_ * normal);
  glm::dvec3 direction;
  const bool fromProbe = random() < 0.5;
  const double a = random(), b = random(), c = random();
  if (fromProbe) {
    const auto pixel = static_cast<std::size_t>(
        std::lower_bound(below_.begin(), below_.end(), c * below_.back()) - below_.begin());
    const double row = static_cast<double>(pixel / probe.width()),
                 column = static_cast<double>(pixel % probe.width());
    const double top = std::cos(pi * row / probe.height()),
                 bottom = std::cos(pi * (row + 1.0) / probe.height());
    const double z = top + a * (bottom - top), sine = std::sqrt(std::max(0.0, 1.0 - z * z));
    const double turn = 2.0 * pi * ((column + b) / probe.width() - 0.5);
    direction = worldFromEnvironment_ * glm::dvec3(sine * std::sin(turn), sine * std::cos(turn), z);
  } else {
    const double z = 2.0 * a - 1.0, sine = std::sqrt(1.0 - z * z), turn = 2.0 * pi * b;
    direction = glm::normalize(normal + glm::dvec3(sine * std::cos(turn), sine * std::sin(turn), z));
  }
  const double cosine = glm::dot(direction, normal);
  if (!(cosine > 0.0)) return glm::dvec3(0.0);
  const ProbePixel seen = probePixelOf(probe, glm::transpose(worldFromEnvironment_) * direction);
  const glm::vec3 radiance = probe.pixels()[static_cast<std::size_t>(seen.row) * probe.width() +
                                            static_cast<std::size_t>(seen.column)];
  const double density = 0.5 * cosine / pi + 0.5 * weightOf(radiance) / below_.back();
  Hit hit;
  if (!firstEntry(start, direction, hit)) return glm::dvec3(radiance) * (cosine / density);
  if (!bounces) return glm::dvec3(0.0);
  return albedo_ / pi * direct(hit.voxel, hit.normal, random, false) * (cosine / density);
}

MeshPathTracer::Estimate MeshPathTracer::irradiance(glm::dvec3 voxel, std::uint64_t seed, int paths) const {
  const glm::dvec3 normal = normalAt(voxel);
  Random random{seed};
  glm::dvec3 sum(0.0), squares(0.0);
  for (int i = 0; i < paths; ++i) {
    const glm::dvec3 e = direct(voxel, normal, random, light_->bounces > 0);
    sum += e;
    squares += e * e;
  }
  const double n = paths;
  const glm::dvec3 mean = sum / n;
  return {mean, glm::max(squares / n - mean * mean, glm::dvec3(0.0)) / (n - 1.0)};
}

}  // namespace isolux::bench
