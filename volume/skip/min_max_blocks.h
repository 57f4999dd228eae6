// Minimum and maximum of every block of cells: what says where an isosurface can and cannot be.
//
// A cell is the cube between 8 neighbouring voxels; an axis of n voxels has n-1 cells (none if n < 2). Block
// b covers cells [b*B, (b+1)*B) and so voxels [b*B, (b+1)*B] per axis. Values are stored units (floats hold
// 16-bit integers exactly); missing voxels do not count; a block with only missing voxels holds min > max.
// Hadwiger et al. 2005 sec. 3.1.
//
// The same for a cubic field: the bounds are those of the B-spline coefficients that the block's cells touch,
// which hold the field by the spline's convex hull property. Cells [b*B, (b+1)*B) touch the coefficients
// [b*B-1, (b+1)*B+1]; those beyond the border repeat the border's and add nothing. Where samples are missing
// the bounds are still valid for the cells that hold a surface (volume/hit/exact_cubic_hit.h): for the
// smoothing spline those have no missing coefficient, for the interpolating one missing samples have been
// filled.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"

namespace isolux::volume {

class MinMaxBlocks {
 public:
  // blockCells: 4 or 8. Multithreaded; throws Error{interrupted}.
  MinMaxBlocks(const Grid& grid, int blockCells, base::Progress& progress);

  // Made a slab after the other: for `voxels` of which nothing is known yet (minimum > maximum everywhere).
  MinMaxBlocks(glm::ivec3 voxels, int blockCells);
  // Blocks of the layers from `layer` on, of the slices layer * blockCells ... in `slab`, which is as wide
  // and as high as the volume. A layer of which only the first slices are given is left as it was; the
  // volume's last layer takes what there is. Multithreaded; throws Error{interrupted}.
  template <class T>
  void setLayers(int layer, std::span<const T> slab, glm::ivec3 voxels, base::Progress& progress);
  void set(std::size_t block, float minimum, float maximum) {
    minimum_[block] = minimum;
    maximum_[block] = maximum;
  }

  // Bounds of the cubic B-spline whose coefficients are the samples themselves, or those given (one per
  // voxel of `grid`: interpolatingCoefficients()): stored units, of those without their offset.
  static MinMaxBlocks ofCubic(const Grid& grid, int blockCells, base::Progress& progress);
  static MinMaxBlocks ofCubic(const Coefficients& coefficients, const Grid& grid, int blockCells,
                              base::Progress& progress);

  int blockCells() const { return blockCells_; }
  glm::ivec3 dims() const { return dims_; }  // in blocks; any axis 0 when the grid has no cells
  std::size_t count() const { return minimum_.size(); }
  std::size_t index(glm::ivec3 b) const {
    return (static_cast<std::size_t>(b.z) * static_cast<std::size_t>(dims_.y) +
            static_cast<std::size_t>(b.y)) *
               static_cast<std::size_t>(dims_.x) +
           static_cast<std::size_t>(b.x);
  }
  float minimum(std::size_t block) const { return minimum_[block]; }
  float maximum(std::size_t block) const { return maximum_[block]; }

  // The block can hold a crossing of `stored` isovalue: min < iso <= max or min <= iso < max, i.e. neither
  // all voxels on one side nor a constant block.
  bool active(std::size_t block, float storedIsovalue) const {
    return minimum_[block] <= storedIsovalue && storedIsovalue <= maximum_[block] &&
           minimum_[block] < maximum_[block];
  }
  // One byte per block, 1 where active; x fastest. Returns the number of active blocks.
  std::size_t activeBlocks(float storedIsovalue, std::vector<std::uint8_t>& flags) const;

 private:
  // `apron`: voxels beyond its own that a block's bounds cover on every side.
  template <class T>
  void fill(const std::vector<T>& voxels, const Grid& grid, int apron, base::Progress& progress);

  int blockCells_;
  glm::ivec3 dims_{0};
  std::vector<float> minimum_, maximum_;
};

}  // namespace isolux::volume
