#include "tests/properties/property_case.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "base/random.h"
#include "scene/camera.h"

namespace isolux::test {

namespace {

constexpr double kLargest = 1e37;  // coefficients of the interpolating spline are at most 27 times as large
constexpr const char* kTypes[] = {"float32", "int8", "uint8", "int16", "uint16"};

template <class T>
std::vector<T> integersOf(const std::vector<double>& values) {
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (const double v : values)
    if (std::isfinite(v)) least = std::min(least, v), most = std::max(most, v);
  constexpr double low = std::numeric_limits<T>::min(), high = std::numeric_limits<T>::max();
  std::vector<T> integers;
  for (const double v : values)
    integers.push_back(static_cast<T>(std::isfinite(v) && most > least
                                          ? std::lround(low + (high - low) * ((v - least) / (most - least)))
                                          : 0));
  return integers;
}

volume::VoxelArray storedAs(const std::string& type, const std::vector<double>& values) {
  if (type == "int8") return integersOf<std::int8_t>(values);
  if (type == "uint8") return integersOf<std::uint8_t>(values);
  if (type == "int16") return integersOf<std::int16_t>(values);
  if (type == "uint16") return integersOf<std::uint16_t>(values);
  if (type != "float32") throw std::invalid_argument("no type \"" + type + '"');
  return std::vector<float>(values.begin(), values.end());
}

volume::GridGeometry geometryOf(const PropertyCase& c) {
  glm::dmat3 axes(1.0);
  if (c.turn != 0) {
    const auto number = [&](std::uint64_t i) {
      return 2.0 * base::uniformNoise(static_cast<std::uint64_t>(c.turn), i) - 1.0;
    };
    axes = glm::mat3_cast(glm::normalize(glm::dquat(number(0), number(1), number(2), number(3))));
    if (c.turn % 2 != 0) axes[1] = glm::normalize(axes[1] + 0.4 * axes[0] - 0.2 * axes[2]);
  }
  if (c.leftHanded) axes[0] = -axes[0];
  volume::GridGeometry geometry{c.dims, glm::dmat4(1.0)};
  for (int axis = 0; axis < 3; ++axis)
    geometry.worldFromVoxel[axis] = glm::dvec4(c.spacing[axis] * axes[axis], 0.0);
  if (c.turn != 0) geometry.worldFromVoxel[3] = glm::dvec4(-31.0, 12.5, 400.0, 1.0);
  return geometry;
}

double uniformIn(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}
glm::dvec3 pointIn(std::mt19937_64& random, double low, double high) {
  return {uniformIn(random, low, high), uniformIn(random, low, high), uniformIn(random, low, high)};
}
glm::dvec3 roundedTo(const glm::dvec3& v, double steps) {
  return glm::round(v * steps) / steps;
}

void randomCamera(PropertyCase& c, std::mt19937_64& random) {
  c.orthographic = random() % 3 == 0;
  c.fov = std::round(uniformIn(random, 5.0, 100.0));
  c.target = roundedTo(pointIn(random, 0.2, 0.8), 64.0);
  c.up = random() % 2 == 0 ? glm::dvec3(0, 0, 1) : roundedTo(pointIn(random, -1.0, 1.0), 8.0);
  const glm::dvec3 voxel = 1.0 / glm::dvec3(glm::max(c.dims - 1, glm::ivec3(1)));
  const auto axis = static_cast<int>(random() % 3);
  switch (random() % 6) {
    case 0:  // inside
      c.eye = roundedTo(pointIn(random, 0.0, 1.0), 64.0);
      break;
    case 1:  // in a voxel
      c.eye = glm::round(pointIn(random, 0.0, 1.0) / voxel) * voxel;
      break;
    case 2:  // along an axis, through voxels
      c.target = glm::round(c.target / voxel) * voxel;
      c.eye = c.target;
      c.eye[axis] = random() % 2 == 0 ? -1.5 : 2.5;
      break;
    case 3:  // from corner to corner
      c.target = glm::dvec3(1.0);
      c.eye = glm::dvec3(random() % 2 == 0 ? -1.0 : 0.0);
      break;
    case 4:  // far away
      c.eye = c.target + 50.0 * glm::normalize(pointIn(random, -1.0, 1.0) + 1e-3);
      c.fov = 2.0;
      break;
    default:
      c.eye = roundedTo(0.5 + uniformIn(random, 1.2, 3.0) * glm::normalize(pointIn(random, -1.0, 1.0) + 1e-3),
                        64.0);
  }
}

}  // namespace

volume::Grid PropertyCase::grid() const {
  std::vector<double> values;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) {
        const double value = offset + scale * field({x, y, z}, dims);
        values.push_back(std::isfinite(value) ? std::clamp(value, -kLargest, kLargest) : value);
      }
  return {geometryOf(*this), storedAs(type, values), slope, intercept};
}

double PropertyCase::isovalueIn(const volume::Grid& grid) const {
  const auto count = grid.geometry().voxelCount();
  for (std::size_t k = 0; ofVoxel && k < count; ++k) {
    const auto at = static_cast<int>((static_cast<std::size_t>(isovalue) + k) % count);
    const double value = grid.value(at % dims.x, at / dims.x % dims.y, at / (dims.x * dims.y));
    if (!std::isnan(value)) return value;
  }
  return grid.minimum() + (ofVoxel ? 0.5 : isovalue) * (grid.maximum() - grid.minimum());
}

scene::Camera PropertyCase::camera(const volume::GridGeometry& geometry) const {
  const auto world = [&](const glm::dvec3& part) {
    return glm::dvec3(geometry.worldFromVoxel *
                      glm::dvec4(part * glm::dvec3(glm::max(dims - 1, glm::ivec3(1))), 1.0));
  };
  scene::Camera camera;
  camera.eye = world(eye);
  camera.target = world(target);
  camera.up = up;
  camera.fov = fov;
  camera.projection = orthographic ? scene::Projection::orthographic : scene::Projection::perspective;
  return camera;
}

PropertyCase randomCase(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  PropertyCase c;
  c.seed = random() % 1000000;
  c.field = randomTerm(random, static_cast<int>(random() % 4));
  constexpr double offsets[] = {0.0, 0.0, 0.0, 1.0, 1e6, -1e6, 65504.0};
  constexpr double scales[] = {1.0, 1.0, 1.0, 16.0, 1e-3, 1e-40, 1e-37, 1e-30, 1e30, 1e37};
  c.scale = scales[random() % std::size(scales)];
  if (c.scale >= 1e-3 && c.scale <= 16.0) c.offset = offsets[random() % std::size(offsets)];
  c.type = kTypes[random() % 2 == 0 ? 0 : random() % std::size(kTypes)];
  const int most = random() % 8 == 0 ? 24 : 12;
  for (int axis = 0; axis < 3; ++axis)
    c.dims[axis] = 2 + static_cast<int>(random() % static_cast<unsigned>(most - 1));
  // Intercepts would leave nothing of values that are much smaller.
  if (c.scale >= 1.0 && c.scale <= 16.0 && random() % 2 == 0) {
    constexpr double slopes[] = {-1.0, 0.5, -0.001, 2.3, 4096.0};
    c.slope = slopes[random() % std::size(slopes)];
    c.intercept = random() % 2 == 0 ? 0.0 : -1024.0;
  }
  if (random() % 2 == 0) {
    constexpr double lengths[] = {0.4, 0.7, 1.0, 1.3, 5.0};
    for (int axis = 0; axis < 3; ++axis) c.spacing[axis] = lengths[random() % std::size(lengths)];
    c.turn = static_cast<int>(random() % 1000);
    c.leftHanded = random() % 2 == 0;
  }
  c.ofVoxel = random() % 3 == 0;
  c.isovalue = c.ofVoxel ? static_cast<double>(random() % 14000)
                         : std::round(uniformIn(random, 0.0, 1.0) * 64.0) / 64.0;
  randomCamera(c, random);
  c.picture = glm::ivec2(8 + random() % 25, 8 + random() % 17);
  return c;
}

volume::PictureRays raysOf(const scene::Camera& camera, const volume::GridGeometry& geometry,
                           glm::ivec2 picture) {
  const scene::CameraFrame frame = scene::frameOf(camera);
  const glm::dvec3 forward = -frame.back;
  double nearest = HUGE_VAL, farthest = -HUGE_VAL;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 voxel =
        glm::dvec3(geometry.dims - 1) * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2);
    const double depth =
        glm::dot(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0)) - frame.eye, forward);
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const double extent = farthest - nearest, before = nearest - 0.01 * extent;
  volume::PictureRays rays;
  rays.orthographic = frame.projection == scene::Projection::orthographic;
  const bool far = nearest > 8.0 * extent;
  const double start = far ? before : rays.orthographic ? std::min(0.0, before) : 0.0;
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  const glm::dmat3 linear(voxelFromWorld);
  rays.eye = glm::dvec3(voxelFromWorld * glm::dvec4(frame.eye + start * forward, 1.0));
  rays.right = linear * frame.right;
  rays.up = linear * frame.up;
  rays.forward = linear * forward;
  rays.halfExtent = {static_cast<float>(frame.halfHeight * picture.x / picture.y),
                     static_cast<float>(frame.halfHeight)};
  rays.startDepth = rays.orthographic ? 0.0f : static_cast<float>(start);
  rays.picture = picture;
  return rays;
}

volume::Ray rayThrough(const volume::PictureRays& rays, glm::dvec2 fragment) {
  const glm::dvec2 plane = (fragment / glm::dvec2(rays.picture) * 2.0 - 1.0) * glm::dvec2(rays.halfExtent);
  const glm::dvec3 offset = plane.x * glm::dvec3(rays.right) + plane.y * glm::dvec3(rays.up);
  volume::Ray ray;
  ray.origin =
      glm::dvec3(rays.eye) + (rays.orthographic ? 1.0 : static_cast<double>(rays.startDepth)) * offset;
  ray.direction = rays.orthographic
                      ? glm::dvec3(rays.forward)
                      : (glm::dvec3(rays.forward) + offset) / std::sqrt(1.0 + glm::dot(plane, plane));
  return ray;
}

double roundingOf(const volume::PictureRays& rays, glm::ivec3 dims, double t) {
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const auto size = [&](const glm::vec3& v) { return static_cast<double>(std::fabs(v[axis])); };
    const double offset = static_cast<double>(rays.halfExtent.x) * size(rays.right) +
                          static_cast<double>(rays.halfExtent.y) * size(rays.up);
    const double along =
        rays.orthographic ? t * size(rays.forward) + offset
                          : t * (size(rays.forward) + offset) + static_cast<double>(rays.startDepth) * offset;
    largest = std::max(largest, size(rays.eye) + along + dims[axis]);
  }
  return 10.0 * 0x1p-24 * largest;
}

}  // namespace isolux::test
