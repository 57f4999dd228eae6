// The volume and the keys of the files of light in the corpus.
#pragma once

#include <cstdint>
#include <vector>

#include "volume/grid.h"

namespace isolux::fuzz {

inline constexpr const char* kIrradianceKey =
    R"({"format":2,"content":"irradiance","channels":3,"lattice_scale":1.0})";
inline constexpr const char* kTransferKey =
    R"({"format":2,"content":"transfer","channels":1,"sh_order":2,"lattice_scale":1.0})";
inline constexpr const char* kLampsKey = R"({"format":2,"lattice_scale":1.0,"lamps":[]})";

inline volume::Grid lightGrid() {
  std::vector<std::uint8_t> voxels;
  for (int i = 0; i < 4 * 3 * 5; ++i) voxels.push_back(static_cast<std::uint8_t>(i));
  return volume::Grid(volume::GridGeometry::make({4, 3, 5}, {1.0, 2.0, 0.5}), std::move(voxels));
}

}  // namespace isolux::fuzz
