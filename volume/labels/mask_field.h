// Makes the mask field of a set of labels: an int8 grid whose isosurface 0 is the set's smoothed surface.
//
// chi = 1 at voxels whose label is in the set, else 0; beyond the border it repeats the border's. With the
// Gaussian of standard deviation `smoothing` (voxels, cut off at ceil(3 smoothing) and of sum 1) and its
// variance v per axis,
//   g = Gaussian * chi,   s = g - (v + 1/6) / 2 Laplacian(g),   u = 2 s - 1,   m = u (2 chi - 1).
// The second moment of s and of trilinear interpolation (1/6) together is 0: curved surfaces keep their
// place to the first order. Guard: m is at least 0.04, so every voxel's centre keeps its side. A voxel with m
// < -0.1 is thin: smoothing alone would lose it; it and its 26 neighbours get m = 1. The value is
//   u = m (2 chi - 1), at most 1, in steps of 1/127. smoothing = 0: m = 1, the indicators themselves.
//
// Volumes of thick slices have the field of slice_mask.h instead, unless smoothing = 0.
//
// So the surface crosses the line between two neighbours along an axis exactly if one is in the set, and each
// of its points lies at most half a voxel along each axis from a face between such neighbours
// (docs/explanation/numerics.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/progress.h"
#include "volume/grid.h"
#include "volume/labels/label_blocks.h"

namespace isolux::volume {

inline constexpr double kMostSmoothing = 2.0;  // voxels

struct MaskField {
  std::shared_ptr<const Grid> grid;  // geometry of the labels; values -1 to 1, never 0; no missing voxels
  std::vector<int> labels;           // of the set, ascending
  double smoothing = 0.0;            // voxels
  std::vector<std::uint16_t> thin;   // thin voxels in the set, of each block of LabelBlocks
  // Holds 0 for each block where the field is that which changedMask() was given; empty: it was given none.
  std::vector<std::uint8_t> changed{};

  std::size_t thinVoxels() const;
};

// `labels`: in any order; those that the volume does not have do nothing. Requires smoothing in [0,
// kMostSmoothing]. On all cores; only blocks near borders of the set are computed. Throws Error: interrupted,
// memory.
MaskField makeMask(const LabelBlocks& blocks, std::span<const int> labels, double smoothing,
                   base::Progress& progress);

// The same field as makeMask() gives, computed only near voxels of labels that are in one set and not in the
// other. Requires that `mask` is of the same `blocks`.
MaskField changedMask(const MaskField& mask, const LabelBlocks& blocks, std::span<const int> labels,
                      base::Progress& progress);

}  // namespace isolux::volume
