// States the type of a volume's voxels, their number per axis, and where they lie in the world.
//
// Voxel space: sample i is at integer coordinate i; the domain is [0, n-1] per axis; x varies fastest in
// memory. World: millimetres, DICOM/LPS, by worldFromVoxel, which may be oblique, anisotropic, left-handed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace isolux::volume {

// Voxel types of files. Grids store only int8, uint8, int16, uint16 and float32.
enum class VoxelType { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };
std::string_view nameOf(VoxelType type);  // "int16", ...
std::size_t bytesOf(VoxelType type);      // of one voxel

struct GridGeometry {
  glm::ivec3 dims{0};
  glm::dmat4 worldFromVoxel{1.0};  // affine, invertible

  std::size_t voxelCount() const {
    return static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) *
           static_cast<std::size_t>(dims.z);
  }
  glm::dmat4 voxelFromWorld() const;
  glm::dvec3 spacingMm() const;   // lengths of the columns
  glm::dmat3 directions() const;  // unit columns: world direction of each voxel axis
  glm::dvec3 originMm() const;    // world position of voxel (0,0,0)
  bool leftHanded() const;        // negative determinant
  void worldBounds(glm::dvec3& minimumMm, glm::dvec3& maximumMm) const;  // of the domain [0, n-1]^3

  static GridGeometry make(glm::ivec3 dims, glm::dvec3 spacingMm, glm::dvec3 originMm = glm::dvec3(0.0),
                           glm::dmat3 directions = glm::dmat3(1.0));
};

// Voxels as read, in one of the five stored types.
using VoxelArray = std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>,
                                std::vector<std::int16_t>, std::vector<std::uint16_t>, std::vector<float>>;

}  // namespace isolux::volume
