// A volume in a file, of which parts are read when they are asked for: what is drawn of volumes larger than
// memory.
//
// Level 0 is the volume itself; coarser levels, where the file has them, hold means of what is below. All
// levels lie in one world. Voxels are stored numbers, in the machine's byte order; missing ones are NaN
// (float32 only).
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include "scene/world_axes.h"
#include "volume/voxels/grid_geometry.h"

namespace isolux::volume {

struct LabelTable;

struct ChunkedLevel {
  GridGeometry geometry;
  // Voxels that the file keeps together; a part of whole chunks is read without waste.
  glm::ivec3 chunkDims{0};
  bool cheapParts = false;  // any rows are

  // What is kept together is a box, not rows.
  bool keepsBoxes() const {
    constexpr int least = 8;  // per axis: thinner chunks are rows
    const glm::ivec3 dims = geometry.dims;
    return glm::all(glm::greaterThanEqual(glm::min(chunkDims, dims), glm::min(glm::ivec3(least), dims)));
  }
};

// The largest part of a box that is whole rows, or whole slices, and has at most so many voxels; at least a
// row.
inline glm::ivec3 wholeRows(glm::ivec3 box, std::size_t most) {
  const auto row = static_cast<std::size_t>(box.x), slice = row * static_cast<std::size_t>(box.y);
  const auto fit = [most](std::size_t voxels, int n) {
    return static_cast<int>(std::clamp<std::size_t>(most / voxels, 1, static_cast<std::size_t>(n)));
  };
  return {box.x, fit(row, box.y), fit(slice, box.z)};
}

// Which volume of a file that has several.
struct VolumePart {
  int time = 0, channel = 0;
};

// What the file says of itself.
struct ChunkedFacts {
  std::string name;    // of the file, for messages
  std::string title;   // what the volume is called where that is not the file's name
  std::string format;  // "NRRD", "OME-Zarr 0.4", ...
  std::string unit;    // of values; "" where it says none
  scene::WorldAxes axes = scene::WorldAxes::zUp;
  VoxelType storedType = VoxelType::uint8;  // int8, uint8, int16, uint16 or float32
  std::size_t wholeVoxelBytes = 0;          // of a voxel while all are read; 0: those of the stored type
  double slope = 1.0, intercept = 0.0;      // value = slope * stored + intercept; finite, slope not 0
  std::vector<ChunkedLevel> levels;         // at least one, the finest first
  int times = 1, channels = 1;
  std::vector<std::string>
      choices;  // "SERIES<TAB>what it is" of all volumes of the file; empty where there is one
  std::vector<std::string> warnings;         // one line each
  std::shared_ptr<const LabelTable> labels;  // as Volume::labelTable, of all layers
};

class ChunkedVolume {
 public:
  virtual ~ChunkedVolume() = default;

  virtual const ChunkedFacts& facts() const = 0;

  // Voxels low .. low + size - 1 of a level, which must lie in it, x fastest, into `voxels`, which has
  // bytesOf(storedType) bytes for each. Any number of threads may read at a time. Returns the bytes read from
  // the file. Throws base::Error{input} naming file and chunk: cut off, vanished, damaged, packed in another
  // way.
  virtual std::size_t read(VolumePart part, std::size_t level, glm::ivec3 low, glm::ivec3 size,
                           std::span<std::byte> voxels) const = 0;
};

}  // namespace isolux::volume
