#include "volume/voxels/grid_geometry.h"

#include <limits>

#include <glm/common.hpp>
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

}  // namespace isolux::volume
