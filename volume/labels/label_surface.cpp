#include "volume/labels/label_surface.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "base/memory_budget.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr int kEmptyVoxels = 4;  // around a label: the spline that judges the sampling reaches 3

// A label by itself: 1 at its voxels, else 0.
struct LoneLabel {
  std::shared_ptr<const Grid> grid;
  bool meetsBorder = false;  // of the volume
};

template <class T>
LoneLabel loneLabel(const Grid& grid, const std::vector<T>& voxels, const LabelExtent& label,
                    base::Progress& progress) {
  const glm::ivec3 first = label.low - kEmptyVoxels, size = label.high - label.low + 1,
                   last = grid.dims() - 1;
  GridGeometry geometry = grid.geometry();
  geometry.dims = size + 2 * kEmptyVoxels;
  geometry.worldFromVoxel = glm::translate(geometry.worldFromVoxel, glm::dvec3(first));
  const auto held = base::machineMemory().reserve(geometry.voxelCount(), "the voxels of a label",
                                                  "a volume with fewer voxels needs less");
  std::vector<std::uint8_t> own;
  resizeStoppably(own, geometry.voxelCount(), progress);
  std::atomic<bool> meetsBorder = false;
  const T stored = static_cast<T>(label.stored);
  parallelSteps(static_cast<std::size_t>(size.z), progress, {}, [&](std::size_t slice) {
    const int z = label.low.z + static_cast<int>(slice);
    for (int y = label.low.y; y <= label.high.y; ++y) {
      const T* const from = voxels.data() + grid.index(label.low.x, y, z);
      std::uint8_t* const to = own.data() + geometry.extent().index(glm::ivec3(label.low.x, y, z) - first);
      for (int x = 0; x < size.x; ++x) to[x] = from[x] == stored ? 1 : 0;
      const bool atBorder = y == 0 || y == last.y || z == 0 || z == last.z;
      if ((atBorder && std::find(to, to + size.x, 1) != to + size.x) || (label.low.x == 0 && to[0] == 1) ||
          (label.high.x == last.x && to[size.x - 1] == 1))
        meetsBorder = true;
    }
  });
  return {std::make_shared<const Grid>(geometry, std::move(own), 1.0, 0.0, progress), meetsBorder};
}

}  // namespace

LabelSurface labelSurface(const Grid& grid, const LabelExtent& label, double smoothing,
                          base::Progress& progress) {
  const LoneLabel lone =
      grid.visit([&](const auto& voxels) { return loneLabel(grid, voxels, label, progress); });
  const std::vector<int> set{1};
  return {makeMask(LabelBlocks(lone.grid, "", progress), set, smoothing, progress), lone.meetsBorder};
}

}  // namespace isolux::volume
