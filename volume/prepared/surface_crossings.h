// Finds where the isosurfaces that a scene shows cross the edges of the grid: points of the trilinear surface
// that cost a comparison each.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "scene/shown_surfaces.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

struct Surface {
  double isovalue;
  std::shared_ptr<const VoxelMask> hidden;  // null: nothing
};
// Those of opacity above 0. `resolved`: scene::resolve of this volume. Throws Error: interrupted; memory, of
// pieces.
inline std::vector<Surface> shownSurfaces(const PreparedVolume& volume, const scene::Scene& resolved,
                                          base::Progress& progress) {
  std::vector<Surface> surfaces;
  for (const scene::Surface& surface : scene::visibleSurfaces(resolved))
    surfaces.push_back({*surface.value, volume.pieces->hidden(resolved.pieces, *surface.value,
                                                              resolved.isosurface.inside, progress)});
  return surfaces;
}

// Which voxels of a block lie at or above a stored isovalue, and which are not missing: a bit for each of a
// row.
class BlockSides {
 public:
  template <class T>
  BlockSides(const std::vector<T>& voxels, const Grid& grid, glm::ivec3 low, glm::ivec3 high, double isovalue)
      : size_(high - low + 1) {
    for (int z = 0; z < size_.z; ++z)
      for (int y = 0; y < size_.y; ++y) {
        const T* const row = voxels.data() + grid.index(low + glm::ivec3(0, y, z));
        unsigned above = 0, known = 0;
        if constexpr (std::is_same_v<T, std::int8_t>)
          if (isovalue == 0.0 && size_.x == kMost) {  // of labels
            rows_[at(y, z)] = {signsOf(row) ^ 0x1ff, 0x1ff};
            continue;
          }
        for (int x = 0; x < size_.x; ++x) {
          above |= static_cast<unsigned>(static_cast<double>(row[x]) >= isovalue) << x;
          if constexpr (std::is_floating_point_v<T>) known |= static_cast<unsigned>(!std::isnan(row[x])) << x;
        }
        if constexpr (std::is_integral_v<T>) known = (1u << size_.x) - 1;
        rows_[at(y, z)] = {above, known};
      }
  }
  // A bit for each voxel of the row whose edge along the axis crosses.
  std::array<unsigned, 3> crossings(int y, int z) const {
    const auto [above, known] = rows_[at(y, z)];
    const auto with = [&](bool exists, int besideY, int besideZ) {
      if (!exists) return 0u;
      const Row& other = rows_[at(besideY, besideZ)];
      return (above ^ other.above) & known & other.known;
    };
    return {(above ^ above >> 1) & known & known >> 1, with(y + 1 < size_.y, y + 1, z),
            with(z + 1 < size_.z, y, z + 1)};
  }

 private:
  static constexpr int kMost = 9;  // voxels on an axis: blocks have 8 cells at most
  struct Row {
    unsigned above, known;
  };
  // Bit x: row[x] is negative. Bytes' signs are gathered by a product: bit 8 x becomes bit 56 + x.
  static unsigned signsOf(const std::int8_t* row) {
    std::uint64_t bytes = 0;
    for (int x = 0; x < 8; ++x) bytes |= std::uint64_t{static_cast<std::uint8_t>(row[x])} << (8 * x);
    const std::uint64_t eight = ((bytes >> 7 & 0x0101010101010101u) * 0x0102040810204080u) >> 56;
    return static_cast<unsigned>(eight) | static_cast<unsigned>(row[8] < 0) << 8;
  }
  static std::size_t at(int y, int z) { return static_cast<std::size_t>(z * kMost + y); }
  glm::ivec3 size_;
  std::array<Row, std::size_t{kMost} * kMost> rows_;
};

// Calls each(first voxel of the edge, crossing in voxel coordinates) for the crossings on the edges of the
// voxels of a block. A whole grid.
// isWanted(): asked in turn of each crossing that is not hidden, before its place is computed.
template <class IsWanted, class Each>
void eachCrossing(const PreparedVolume& volume, const Surface& surface, scene::Inside inside,
                  std::size_t block, const IsWanted& isWanted, const Each& each) {
  const Grid& grid = volume.grid();
  const glm::ivec3 low = Extent3{volume.blocks->dims()}.at(block) * volume.blocks->blockCells();
  const glm::ivec3 high = glm::min(low + volume.blocks->blockCells(), grid.dims() - 1);
  const double isovalue = grid.storedOfValue(surface.isovalue);
  const bool insideIsPositive = (inside == scene::Inside::above) == (grid.slope() > 0.0);
  const auto look = [&](const auto& stored) {
    const auto at = [&](glm::ivec3 v) { return static_cast<double>(stored[grid.index(v)]) - isovalue; };
    const BlockSides sides(stored, grid, low, high, isovalue);
    const auto onEdge = [&](glm::ivec3 begin, int axis) {
      if (!surface.hidden && !isWanted()) return;
      const double f = at(begin);
      glm::ivec3 end = begin;
      ++end[axis];
      const glm::ivec3 within = (f >= 0.0) == insideIsPositive ? begin : end;
      if (surface.hidden && (surface.hidden->at(within) || !isWanted())) return;
      glm::dvec3 point(begin);
      point[axis] += f / (f - at(end));
      each(begin, point);
    };
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y) {
        const std::array<unsigned, 3> axes = sides.crossings(y - low.y, z - low.z);
        for (unsigned left = axes[0] | axes[1] | axes[2]; left != 0; left &= left - 1) {
          const int x = std::countr_zero(left);
          for (const int axis : {0, 1, 2})
            if ((axes[static_cast<std::size_t>(axis)] >> x & 1) != 0) onEdge({low.x + x, y, z}, axis);
        }
      }
  };
  grid.visit(look);
}

template <class Each>
void eachCrossing(const PreparedVolume& volume, const Surface& surface, scene::Inside inside,
                  std::size_t block, const Each& each) {
  eachCrossing(
      volume, surface, inside, block, [] { return true; }, each);
}

}  // namespace isolux::volume
