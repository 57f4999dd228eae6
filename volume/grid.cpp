#include "volume/grid.h"

#include <cassert>
#include <cmath>
#include <cstring>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace isolux::volume {

std::string_view nameOf(VoxelType type) {
  constexpr std::string_view names[] = {"int8",   "uint8", "int16",  "uint16",  "int32",
                                        "uint32", "int64", "uint64", "float32", "float64"};
  return names[static_cast<int>(type)];
}

std::size_t bytesOf(VoxelType type) {
  constexpr std::size_t bytes[] = {1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
  return bytes[static_cast<int>(type)];
}

glm::dmat4 GridGeometry::voxelFromWorld() const {
  return glm::inverse(worldFromVoxel);
}

glm::dvec3 GridGeometry::spacingMm() const {
  const glm::dmat3 linear(worldFromVoxel);
  return {glm::length(linear[0]), glm::length(linear[1]), glm::length(linear[2])};
}

glm::dmat3 GridGeometry::directions() const {
  glm::dmat3 linear(worldFromVoxel);
  for (int axis = 0; axis < 3; ++axis) linear[axis] = glm::normalize(linear[axis]);
  return linear;
}

glm::dvec3 GridGeometry::originMm() const {
  return glm::dvec3(worldFromVoxel[3]);
}

bool GridGeometry::leftHanded() const {
  return glm::determinant(glm::dmat3(worldFromVoxel)) < 0.0;
}

void GridGeometry::worldBounds(glm::dvec3& minimumMm, glm::dvec3& maximumMm) const {
  minimumMm = glm::dvec3(std::numeric_limits<double>::infinity());
  maximumMm = -minimumMm;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec4 voxel((corner & 1) ? dims.x - 1 : 0, (corner & 2) ? dims.y - 1 : 0,
                           (corner & 4) ? dims.z - 1 : 0, 1.0);
    const glm::dvec3 world(worldFromVoxel * voxel);
    minimumMm = glm::min(minimumMm, world);
    maximumMm = glm::max(maximumMm, world);
  }
}

GridGeometry GridGeometry::make(glm::ivec3 dims, glm::dvec3 spacingMm, glm::dvec3 originMm,
                                glm::dmat3 directions) {
  GridGeometry geometry;
  geometry.dims = dims;
  for (int axis = 0; axis < 3; ++axis)
    geometry.worldFromVoxel[axis] = glm::dvec4(directions[axis] * spacingMm[axis], 0.0);
  geometry.worldFromVoxel[3] = glm::dvec4(originMm, 1.0);
  return geometry;
}

namespace {

std::uint64_t fnv1a(const void* data, std::size_t bytes, std::uint64_t hash) {
  constexpr std::uint64_t prime = 0x100000001b3ull;
  const auto* at = static_cast<const unsigned char*>(data);
  for (; bytes >= 8; at += 8, bytes -= 8) {
    std::uint64_t word;
    std::memcpy(&word, at, 8);
    hash = (hash ^ word) * prime;
    hash ^= hash >> 32;
  }
  for (; bytes > 0; ++at, --bytes) hash = (hash ^ *at) * prime;
  return hash;
}

}  // namespace

Grid::Grid(GridGeometry geometry, VoxelArray voxels, double slope, double intercept)
    : geometry_(geometry), voxels_(std::move(voxels)), slope_(slope), intercept_(intercept) {
  assert(std::isfinite(slope) && slope != 0.0 && std::isfinite(intercept));
  double low = std::numeric_limits<double>::infinity(), high = -low;
  std::visit(
      [&](auto& array) {
        assert(array.size() == geometry_.voxelCount());
        using T = typename std::decay_t<decltype(array)>::value_type;
        T least = std::numeric_limits<T>::max(), most = std::numeric_limits<T>::lowest();
        for (T& v : array) {
          if constexpr (std::is_same_v<T, float>) {
            if (!std::isfinite(v)) {
              v = std::numeric_limits<float>::quiet_NaN();
              ++missing_;
              continue;
            }
          }
          least = v < least ? v : least;
          most = v > most ? v : most;
        }
        if (missing_ < array.size()) {
          low = static_cast<double>(least);
          high = static_cast<double>(most);
        }
      },
      voxels_);
  if (low <= high) {
    minimum_ = valueOfStored(slope_ > 0 ? low : high);
    maximum_ = valueOfStored(slope_ > 0 ? high : low);
  }
  hash_ = fnv1a(&geometry_.dims, sizeof geometry_.dims, 0xcbf29ce484222325ull);
  hash_ = fnv1a(&geometry_.worldFromVoxel, sizeof geometry_.worldFromVoxel, hash_);
  const double numbers[] = {slope_, intercept_, static_cast<double>(voxels_.index())};
  hash_ = fnv1a(numbers, sizeof numbers, hash_);
  std::visit([&](const auto& array) { hash_ = fnv1a(array.data(), array.size() * sizeof array[0], hash_); },
             voxels_);
  held_ = scene::machineMemory().count(bytes());
}

VoxelType Grid::storedType() const {
  constexpr VoxelType types[] = {VoxelType::int8, VoxelType::uint8, VoxelType::int16, VoxelType::uint16,
                                 VoxelType::float32};
  return types[voxels_.index()];
}

double Grid::stored(int x, int y, int z) const {
  const std::size_t i = index(x, y, z);
  return std::visit([i](const auto& array) { return static_cast<double>(array[i]); }, voxels_);
}

std::size_t Grid::bytes() const {
  return geometry_.voxelCount() * bytesOf(storedType());
}

}  // namespace isolux::volume
