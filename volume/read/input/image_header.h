// What any header says about a volume, in one shape; and the checks every format shares.
//
// Data order in the payload: component (fastest), x, y, z, time, slow component. Geometry in mm, LPS.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/world_axes.h"
#include "volume/grid.h"
#include "volume/labels/label_table.h"
#include "volume/read/input/read_options.h"

namespace isolux::volume {

enum class Encoding { raw, zlib /* zlib, gzip, zstd or bzip2, told apart by content */, ascii };

// What a format calls a voxel type.
struct TypeName {
  std::string_view name;
  VoxelType type;
};
// Returns the type of that name, in upper or lower case.
std::optional<VoxelType> typeNamed(std::span<const TypeName> names, std::string_view name);

// Where the voxels are and how they are written.
struct Payload {
  std::vector<std::string> files;     // beside the header, equal shares in order; empty: the header's file
  std::uint64_t offset = 0;           // bytes before the data, before decoding
  bool fromEnd = false;               // raw only: the data are the last bytes of the file
  std::uint64_t lineSkip = 0;         // lines to skip behind `offset`
  std::uint64_t skipBytes = 0;        // bytes to skip behind those
  std::uint64_t skipDecoded = 0;      // bytes to skip after decoding (a header inside a gzip stream)
  std::uint64_t compressedBytes = 0;  // 0: up to the end of the file
  bool moreMayFollow = false;         // other things may stand behind the voxels: no warning
  Encoding encoding = Encoding::raw;
  Endianness endianness = Endianness::little;
};

struct ImageHeader {
  std::string format;
  VoxelType type = VoxelType::uint8;
  std::array<std::int64_t, 3> dims{1, 1, 1};
  std::int64_t components = 1;      // interleaved with the voxels
  std::int64_t slowComponents = 1;  // one volume after the other
  std::int64_t timeSteps = 1;
  glm::dmat4 worldFromVoxel{1.0};
  scene::WorldAxes axes =
      scene::WorldAxes::zUp;            // anatomical: worldFromVoxel leads to LPS by the file's own word
  double slope = 1.0, intercept = 0.0;  // 0 or not finite: none
  std::string unit;
  std::optional<double> isovalue;            // to show first, if the file states it
  std::shared_ptr<const LabelTable> labels;  // of all layers; null: nothing is stated of labels
  Payload payload;
  std::vector<std::string> warnings;

  // After checkDims(): exact, no overflow.
  GridGeometry geometry() const { return {glm::ivec3(dims[0], dims[1], dims[2]), worldFromVoxel}; }
  std::uint64_t voxels() const;
  std::uint64_t elements() const;  // voxels * components * slow components * time steps
};

// Throws Error{input} at `place` unless each axis is 1..65535 and the size in bytes of everything claimed
// fits 62 bits.
void checkDims(const ImageHeader& header, const std::string& file, const std::string& place);

// A warning of VTK's formats.
inline constexpr const char* kValuesOfCells =
    "the file has values of cells, not of points; each is taken at its cell's centre";

// Builds worldFromVoxel. Documented defaults, each with a warning: spacing 0 or not finite -> 1 mm;
// directions not finite or singular -> identity; origin not finite -> 0. Refused: |spacing| outside
// 1e-9..1e9 mm, |origin| above 1e12 mm.
glm::dmat4 checkedGeometry(glm::dmat3 directions, glm::dvec3 spacingMm, glm::dvec3 originMm,
                           const std::string& file, std::vector<std::string>& warnings);

// True where checkedGeometry() keeps the directions: unit columns span space (|det| of a frame with 0.06
// degrees between two axes is 1e-3).
bool usableDirections(glm::dmat3 directions);

// True for an affine matrix with finite entries whose linear part is safely invertible.
bool usableAffine(const glm::dmat4& worldFromVoxel);

}  // namespace isolux::volume
