// Computes the minimum and maximum of every block of cells (min-max blocks), which bound where an isosurface
// can be.
//
// A cell is the cube between 8 neighbouring voxels; an axis of n voxels has n-1 cells (none if n < 2). Block
// b covers cells [b*B, (b+1)*B) and so voxels [b*B, (b+1)*B] per axis. Values are stored units (floats
// represent 16-bit integers exactly). Missing voxels do not count; a block of only missing voxels has min >
// max. Hadwiger et al. 2005 sec. 3.1.
//
// For a cubic field, the bounds are those of the B-spline coefficients that the block's cells use; they bound
// the field by the spline's convex hull property. Cells [b*B, (b+1)*B) use the coefficients [b*B-1,
// (b+1)*B+1]; those beyond the border repeat the border's and add nothing. Where samples are missing, the
// bounds are still valid for the cells that contain a surface (volume/hit/exact_cubic_hit.h): with the
// smoothing spline those have no missing coefficient, with the interpolating one missing samples have been
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

// Cells per axis of the min-max blocks; docs/records/2026-11-benchmarks.md has the measurements behind it.
inline constexpr int kBlockCells = 8;

// Returns for blocks of kBlockCells cells whether they reach into one of some blocks of as many voxels, which
// count from voxel 0, x fastest: a byte each, not 0. `voxels`: of the volume.
std::vector<std::uint8_t> cellBlocksIn(std::span<const std::uint8_t> ofVoxels, glm::ivec3 voxels);

class MinMaxBlocks {
 public:
  // Requires `blockCells` 4 or 8. Multithreaded; throws Error{interrupted}.
  MinMaxBlocks(const Grid& grid, int blockCells, base::Progress& progress);

  // The same where those of a grid are known that differs at most in the blocks whose byte is not 0.
  MinMaxBlocks(const MinMaxBlocks& before, const Grid& grid, std::span<const std::uint8_t> changed,
               base::Progress& progress);

  // Makes empty blocks (minimum > maximum everywhere) for `voxels` that are then added slab by slab.
  MinMaxBlocks(glm::ivec3 voxels, int blockCells);
  // Sets the blocks of the layers from `layer` on, from the slices layer * blockCells ... in `slab`, which is
  // as wide and as high as the volume. A layer of which only the first slices are given is unchanged; the
  // volume's last layer uses the slices that exist. Multithreaded; throws Error{interrupted}.
  template <class T>
  void setLayers(int layer, std::span<const T> slab, glm::ivec3 voxels, base::Progress& progress);
  void set(std::size_t block, float minimum, float maximum) {
    minimum_[block] = minimum;
    maximum_[block] = maximum;
  }

  // Returns bounds of the cubic B-spline with these coefficients (one per voxel of `grid`:
  // interpolatingCoefficients()), or, if they are null, of that whose coefficients are the samples. Bounds
  // are in stored units; given coefficients count without their offset.
  static MinMaxBlocks ofCubic(const Grid& grid, const Coefficients* coefficients, int blockCells,
                              base::Progress& progress);

  int blockCells() const { return blockCells_; }
  glm::ivec3 dims() const { return dims_; }  // in blocks; any axis 0 if the grid has no cells
  std::size_t count() const { return minimum_.size(); }
  std::size_t index(glm::ivec3 block) const { return Extent3{dims_}.index(block); }
  float minimum(std::size_t block) const { return minimum_[block]; }
  float maximum(std::size_t block) const { return maximum_[block]; }

  // Returns whether the block can contain a crossing of the `stored` isovalue: min < iso <= max or min <= iso
  // < max, i.e. neither all voxels on one side nor a constant block.
  bool active(std::size_t block, float storedIsovalue) const {
    return minimum_[block] <= storedIsovalue && storedIsovalue <= maximum_[block] &&
           minimum_[block] < maximum_[block];
  }
  // Sets one byte per block, 1 if active; x fastest. Returns the number of active blocks.
  std::size_t activeBlocks(float storedIsovalue, std::vector<std::uint8_t>& flags) const;

 private:
  // `apron`: voxels beyond its own that a block's bounds cover on every side.
  template <class T>
  void fill(const std::vector<T>& voxels, const Grid& grid, int apron, base::Progress& progress,
            std::span<const std::uint8_t> changed = {});

  int blockCells_;
  glm::ivec3 dims_{0};
  std::vector<float> minimum_, maximum_;
};

}  // namespace isolux::volume
