// The C++ type of stored voxels.
#pragma once

#include <cassert>
#include <cstdint>

#include "volume/voxels/grid_geometry.h"

namespace isolux::volume {

// Calls f with a value of the C++ type of `type`: int8, uint8, int16, uint16 or float32.
template <class F>
auto withStoredType(VoxelType type, F&& f) {
  switch (type) {
    case VoxelType::int8:
      return f(std::int8_t{});
    case VoxelType::uint8:
      return f(std::uint8_t{});
    case VoxelType::int16:
      return f(std::int16_t{});
    case VoxelType::uint16:
      return f(std::uint16_t{});
    default:
      assert(type == VoxelType::float32);
      return f(float{});
  }
}

}  // namespace isolux::volume
