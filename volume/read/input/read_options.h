// States how a file is to be read.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "base/memory_budget.h"
#include "scene/scene.h"
#include "volume/grid.h"
#include "volume/mesh/mesh_distance.h"

namespace isolux::volume {

enum class Endianness { little, big };

// Describes a headerless file.
struct RawDescription {
  glm::ivec3 dims{0};
  VoxelType type = VoxelType::uint8;
  Endianness endianness = Endianness::little;
  glm::dvec3 spacingMm{1.0};
  std::size_t headerBytes = 0;
};
// Parses "WxHxD TYPE [little|big] [spacing sx,sy,sz] [header BYTES]". Throws Error{usage} naming the bad
// word.
RawDescription parseRawDescription(const std::string& text);
std::string toText(const RawDescription& description);

struct ReadOptions {
  std::string raw;     // description text; empty: the file has a header
  std::string series;  // DICOM SeriesInstanceUID; empty: most slices
  int component = 0;   // channel; -1: magnitude
  int timeStep = 0;
  int meshVoxels = 128;           // of a mesh's distance field, along its longest axis
  std::optional<BoxMm> alsoHold;  // a mesh's grid is made large enough for this, too
  // The grid for sources without one of their own: meshes if its voxels are cubes, phantoms without SIZE.
  std::optional<GridGeometry> grid;
  // Limits memory: a larger volume is rejected before anything is allocated.
  std::size_t budgetBytes = base::machineMemory().left();
};
ReadOptions readOptions(const scene::Source& source);

}  // namespace isolux::volume
