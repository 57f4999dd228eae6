// What a chunked volume says of itself in the words of a header, for volume/read/input/payload.h.
#pragma once

#include <filesystem>

#include "volume/bricks/chunked_volume.h"
#include "volume/read/input/image_header.h"
#include "volume/volume.h"

namespace isolux::volume {

// Of a level of `geometry` whose voxels are of `type`.
inline ImageHeader chunkedHeader(const ChunkedFacts& facts, const GridGeometry& geometry, VoxelType type) {
  ImageHeader header;
  header.format = facts.format;
  header.type = type;
  header.dims = {geometry.dims.x, geometry.dims.y, geometry.dims.z};
  header.components = facts.channels;
  header.timeSteps = facts.times;
  header.worldFromVoxel = geometry.worldFromVoxel;
  header.axes = facts.axes;
  header.unit = facts.unit;
  header.slope = facts.slope;
  header.intercept = facts.intercept;
  header.labels = facts.labels;
  header.warnings = facts.warnings;
  return header;
}

// What a volume is called and which others its file has.
inline void takeNames(Volume& volume, const ChunkedFacts& facts) {
  volume.name = facts.title.empty() ? std::filesystem::path(facts.name).filename().string() : facts.title;
  volume.seriesChoices = facts.choices;
}

}  // namespace isolux::volume
