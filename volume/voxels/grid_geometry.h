// States the type of a volume's voxels, their number per axis, and where they lie in the world.
//
// Voxel space: sample i is at integer coordinate i; the domain is [0, n-1] per axis; x varies fastest in
// memory. World: millimetres, DICOM/LPS, by worldFromVoxel, which may be oblique, anisotropic, left-handed.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "volume/voxels/bounds.h"
#include "volume/voxels/extent.h"

namespace isolux::volume {

// Voxel types of files. Grids store only int8, uint8, int16, uint16 and float32.
enum class VoxelType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
std::string_view nameOf(VoxelType type);  // "int16", ...
std::size_t bytesOf(VoxelType type);      // of one voxel

struct GridGeometry {
  glm::ivec3 dims{0};
  glm::dmat4 worldFromVoxel{1.0};  // affine, invertible

  Extent3 extent() const { return {dims}; }
  std::size_t voxelCount() const { return extent().count(); }
  glm::dmat4 voxelFromWorld() const;
  glm::dvec3 spacingMm() const;  // lengths of the columns
  double leastSpacingMm() const;
  double mostSpacingMm() const;
  double voxelMm3() const;        // volume of a voxel
  double voxelMm() const;         // edge of the cube of that volume
  glm::dmat3 directions() const;  // unit columns: world direction of each voxel axis
  glm::dvec3 originMm() const;    // world position of voxel (0,0,0)
  bool leftHanded() const;        // negative determinant
  glm::dvec3 worldOf(const glm::dvec3& voxel) const {
    return glm::dvec3(worldFromVoxel * glm::dvec4(voxel, 1.0));
  }
  glm::dvec3 voxelOf(const glm::dvec3& worldMm) const {
    return glm::dvec3(voxelFromWorld() * glm::dvec4(worldMm, 1.0));
  }
  // Returns whether the point is in the domain [0, n-1]^3, or at most `slack` voxels outside.
  bool holds(const glm::dvec3& voxel, double slack = 0.0) const;
  // Returns the cell that a point is in, or the nearest one; its lower corner.
  glm::ivec3 cellOf(const glm::dvec3& voxel) const;
  // Return the world positions of the corners of a box of voxels, or of the domain, in the order of
  // cornerStep().
  std::array<glm::dvec3, 8> corners(const glm::dvec3& low, const glm::dvec3& high) const;
  std::array<glm::dvec3, 8> corners() const { return corners(glm::dvec3(0.0), glm::dvec3(dims - 1)); }
  Bounds<glm::dvec3> worldBounds() const;        // of the domain, mm
  bool sameAs(const GridGeometry& other) const;  // voxels lie in the same places, to a millionth of one

  static GridGeometry make(glm::ivec3 dims, glm::dvec3 spacingMm, glm::dvec3 originMm = glm::dvec3(0.0),
                           glm::dmat3 directions = glm::dmat3(1.0));
};

// Voxels as read, in one of the five stored types.
using VoxelArray = std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>,
                                std::vector<std::int16_t>, std::vector<std::uint16_t>, std::vector<float>>;

}  // namespace isolux::volume
