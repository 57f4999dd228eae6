// The values of a volume on a plane, in double precision, from any of its reconstructions. Any thread; no GL.
#pragma once

#include <vector>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "scene/choices.h"
#include "volume/field/coefficients.h"
#include "volume/slice/slice_plane.h"

namespace isolux::volume {

// What slices are made of. Everything outlives what is given it.
struct SliceField {
  const Grid& grid;
  scene::Field field = scene::Field::trilinear;
  const Coefficients* coefficients = nullptr;  // of cubic_interpolating, which needs them

  // Data units; NaN beyond the domain [0, n-1] (further than kBorderVoxels) and where samples are missing.
  double value(glm::dvec3 voxel) const;
};

inline constexpr double kBorderVoxels = 1e-6;  // what rounding may move a pixel beyond the border

// Values along the normal within half of `mm` on either side, as one; 0: the plane itself. Of the part
// between the volume's first and last corner values are looked up at equal steps of no more than half a voxel
// (voxelAlong()), both ends included. The mean is that of the line through the values (trapezoidal rule).
// What is NaN does not count; where all is, the slab is NaN.
struct Slab {
  double mm = 0.0;
  scene::SlabMode mode = scene::SlabMode::mean;
  bool operator==(const Slab&) const = default;
};
inline constexpr int kMostSlabSteps = 4096;  // more take longer ones

struct SliceValues {
  glm::ivec2 size{0};
  std::vector<float> values;  // row by row from the top
  base::MemoryBudget::Held held{};
};

// Multithreaded. Throws Error: interrupted; memory.
SliceValues sliceValues(const SliceField& field, const SlicePlane& plane, const Slab& slab,
                        base::Progress& progress);

// As sliceValues(), of the voxel nearest to each point of the plane: for labels, which have no values
// between.
SliceValues nearestValues(const Grid& grid, const SlicePlane& plane, base::Progress& progress);

}  // namespace isolux::volume
