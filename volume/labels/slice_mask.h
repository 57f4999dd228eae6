// Makes the mask field of volumes of thick slices, slice by slice: between slices contours are interpolated
// as distances are (Raya & Udupa 1990, "Shape-based interpolation of multidimensional objects").
//
// Slices are thick if one axis has at least 1.5 times the spacing of the other two. In a slice, d is the
// distance from a voxel's centre to the nearest centre on the other side of the set, less half the shorter
// spacing there, mm; negative outside. With D = the distance between slices, at most 16 of the shorter
// spacing,
//   w = d / D, at least -1 and at most 1,   g = Gaussian * w,   u = g - (v + 1/6) / 2 Laplacian(g)
// in the two dimensions of the slice, beyond whose border w repeats the border's; Gaussian, v and m = u times
// a voxel's side are those of mask_field.h. Guard: m is at least e = 0.04, or 0.4 of w at half a voxel where
// that is less. A voxel is thin if m < e / 4, or if it is alone: in the slices before and after, those at its
// place are on the other side, with |w| = 1. A thin voxel and its 8 neighbours in the slice get m = |w| at
// least, of one that is alone m = 1. No slice before the first or after the last: none is alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/labels/label_blocks.h"
#include "volume/voxels/grid_geometry.h"

namespace isolux::volume {

struct ThickSlices {
  int across = 2;                                                             // the axis
  glm::ivec2 within{0, 1};                                                    // the other two
  glm::dvec2 spacingMm{1.0};                                                  // of those
  double rampMm = 1.0;                                                        // D
  double halfMm() const { return 0.5 * std::min(spacingMm.x, spacingMm.y); }  // half a voxel
  glm::ivec2 rampVoxels() const;  // how far w is less than 1 from a border
  // Convert between voxels, or blocks, of the volume and those of a slice.
  glm::ivec2 inSlice(glm::ivec3 voxel) const { return {voxel[within.x], voxel[within.y]}; }
  glm::ivec3 voxel(glm::ivec2 at, int slice) const;
};
// Empty: all axes are more or less alike.
std::optional<ThickSlices> thickSlicesOf(const GridGeometry& geometry);

template <class T>
class SetMembers;

class SliceMask {
 public:
  // Requires smoothing in (0, kMostSmoothing], and that `blocks` live as long.
  SliceMask(const LabelBlocks& blocks, std::span<const int> labels, double smoothing,
            const ThickSlices& slices);

  // Returns how many blocks beyond one with a changed voxel change, on each axis.
  glm::ivec3 reachBlocks() const;
  // Computes at least the blocks that `wanted` names: their `voxels`, and in `thin` how many of theirs in the
  // set are thin. On all cores. Throws Error{interrupted}.
  void run(std::vector<std::int8_t>& voxels, std::vector<std::uint16_t>& thin,
           const std::function<bool(std::size_t)>& wanted, base::Progress& progress) const;

 private:
  struct Tile {
    int layer;            // of blocks
    glm::ivec2 low, end;  // blocks in it, before `end`
  };
  template <class T>
  void runTile(const Tile& tile, const std::vector<T>& stored, const SetMembers<T>& members,
               std::vector<std::int8_t>& voxels, std::vector<std::uint16_t>& thin,
               const base::Progress& progress) const;

  const LabelBlocks& blocks_;
  std::vector<bool> isMember_;
  double smoothing_;
  ThickSlices slices_;
};

}  // namespace isolux::volume
