// The mask field of a set of labels as its definition says (volume/labels/mask_field.h,
// slice_mask.h), in double precision,
// voxel by voxel, and what must hold for the surface of any such field: what fast code is judged by.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "volume/grid.h"

namespace isolux::test {

struct PlainMask {
  std::vector<bool> member, thin;
  std::vector<double> u;        // after the guard
  std::vector<bool> undecided;  // whether rounding may decide that the voxel, or one beside it, is thin
};
// Requires smoothing 0 or in [1, 2]: there the parameter of the Gaussian is its deviation.
PlainMask plainMask(const volume::Grid& labels, const std::set<int>& set, double smoothing);

// Says what is wrong with a field whose isosurface 0 is to be the surface of the labels in the set (empty:
// nothing): every voxel has its side, and points of the surface, on three random lines through each cell,
// lie within half a voxel along each axis of a face between a voxel in the set and one that is not.
std::string brokenPromise(const volume::Grid& labels, const std::set<int>& set, const volume::Grid& mask,
                          std::uint64_t seed);

}  // namespace isolux::test
