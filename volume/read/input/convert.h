// Turns voxels of any file type into the five types a Grid stores, without loss of meaning.
//
// int8, uint8, int16, uint16, float32 stay as they are. Wider types become the smallest integer type that
// holds every value exactly (with an offset in the intercept where that is what it takes), else float32,
// with slope and intercept chosen so that no value moves by more than one float32 ulp of the data's range
// (range * 2^-23); where one does, a warning says by how much.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

// Voxels in the type of the file; the alternatives stand in the order of VoxelType.
using FileVoxels =
    std::variant<std::vector<std::int8_t>, std::vector<std::uint8_t>, std::vector<std::int16_t>,
                 std::vector<std::uint16_t>, std::vector<std::int32_t>, std::vector<std::uint32_t>,
                 std::vector<std::int64_t>, std::vector<std::uint64_t>, std::vector<float>,
                 std::vector<double>>;

// The same voxels.
inline FileVoxels fileVoxels(VoxelArray&& voxels) {
  return std::visit([](auto&& array) -> FileVoxels { return std::move(array); }, std::move(voxels));
}

// Calls f with a value of the C++ type of `type`.
template <typename F>
auto withType(VoxelType type, F&& f) {
  static constexpr std::variant<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
                                std::uint32_t, std::int64_t, std::uint64_t, float, double>
      zeros[] = {std::int8_t{},   std::uint8_t{}, std::int16_t{},  std::uint16_t{}, std::int32_t{},
                 std::uint32_t{}, std::int64_t{}, std::uint64_t{}, float{},         double{}};
  return std::visit([&](auto zero) { return f(zero); }, zeros[static_cast<int>(type)]);
}

// Returns the integer type of 1, 2, 4 or 8 bytes; none for other sizes.
std::optional<VoxelType> integerType(std::size_t bytes, bool isSigned);

struct StoredVoxels {
  VoxelArray voxels;
  double slope = 1.0, intercept = 0.0;  // file value = slope * stored + intercept
};
StoredVoxels toStored(FileVoxels&& voxels, const base::Progress& progress,
                      std::vector<std::string>& warnings);

}  // namespace isolux::volume
