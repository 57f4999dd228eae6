#include "volume/voxels/grid_geometry.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

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

double GridGeometry::leastSpacingMm() const {
  const glm::dvec3 spacing = spacingMm();
  return std::min({spacing.x, spacing.y, spacing.z});
}

double GridGeometry::mostSpacingMm() const {
  const glm::dvec3 spacing = spacingMm();
  return std::max({spacing.x, spacing.y, spacing.z});
}

double GridGeometry::voxelMm3() const {
  return std::abs(glm::determinant(glm::dmat3(worldFromVoxel)));
}

double GridGeometry::voxelMm() const {
  return std::cbrt(voxelMm3());
}

bool GridGeometry::leftHanded() const {
  return glm::determinant(glm::dmat3(worldFromVoxel)) < 0.0;
}

bool GridGeometry::holds(const glm::dvec3& voxel, double slack) const {
  for (int axis = 0; axis < 3; ++axis)
    if (!(voxel[axis] >= -slack && voxel[axis] <= dims[axis] - 1 + slack)) return false;  // NaN too
  return true;
}

glm::ivec3 GridGeometry::cellOf(const glm::dvec3& voxel) const {
  return glm::clamp(glm::ivec3(glm::floor(voxel)), glm::ivec3(0), glm::max(dims - 2, glm::ivec3(0)));
}

std::array<glm::dvec3, 8> GridGeometry::corners(const glm::dvec3& low, const glm::dvec3& high) const {
  std::array<glm::dvec3, 8> corners;
  for (std::size_t i = 0; i < 8; ++i) corners[i] = worldOf(glm::mix(low, high, glm::bvec3(cornerStep(i))));
  return corners;
}

Bounds<glm::dvec3> GridGeometry::worldBounds() const {
  Bounds<glm::dvec3> bounds;
  for (const glm::dvec3& corner : corners()) bounds.add(corner);
  return bounds;
}

bool GridGeometry::sameAs(const GridGeometry& other) const {
  const double tolerance = 1e-6 * leastSpacingMm();
  return dims == other.dims &&
         std::ranges::equal(corners(), other.corners(),
                            [&](const auto& a, const auto& b) { return !(glm::length(a - b) > tolerance); });
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
