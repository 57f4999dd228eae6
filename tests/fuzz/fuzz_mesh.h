// What the mesh fuzz targets share: triangles become a small distance field, which is prepared.
#pragma once

#include "tests/fuzz/fuzz_support.h"
#include "volume/read/mesh/mesh.h"
#include "volume/read/mesh/mesh_formats.h"

namespace isolux::fuzz {

template <typename Read>
void meshInMemory(const std::uint8_t* data, std::size_t size, Read&& read) {
  const volume::MemoryBytes bytes("input", std::as_bytes(std::span(data, size)));
  volume::ReadOptions options;
  options.budgetBytes = budgetBytes;
  options.meshVoxels = 16;
  base::Progress progress;
  try {
    prepare(volume::distanceVolume(read(bytes, progress), "mesh", "input", options, progress), progress);
  } catch (const base::Error&) {
    return;
  }
}

}  // namespace isolux::fuzz
