// Coefficients of the B-splines that are not a grid's samples themselves; of the tri-cubic one that passes
// through the samples (the field cubic_interpolating).
#pragma once

#include <cassert>
#include <vector>

#include "base/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

// A coefficient is offset + values[Grid::index(x, y, z)], stored units. What is the same in all of them
// stands apart: of values like 1e6 + small, float32 would keep nothing of what their derivatives are made of.
// A spline's weights sum to 1, so its value is the offset more than that of `values`, its derivatives the
// same.
struct Coefficients {
  // The middle of the range of the samples where they lie further from 0 than they spread, else 0: then there
  // is little to gain, and what float32 has most digits for stays at 0, where distance fields have their
  // surface.
  double offset = 0.0;
  std::vector<float> values;
  float least = 0.0f, most = 0.0f;  // of values
  base::MemoryBudget::Held held{};
  bool empty() const { return values.empty(); }
};

// Calls visit(numbers) with the coefficients of a spline: those given, one for each voxel, or the samples
// where they are null.
template <class Visit>
auto visitSpline(const Grid& grid, const Coefficients* coefficients, const Visit& visit) {
  assert(!coefficients || coefficients->values.size() == grid.geometry().voxelCount());
  return coefficients ? visit(coefficients->values) : grid.visit(visit);
}

// What makers begin and end with: the samples, missing ones NaN, less the offset; least and most.
Coefficients samplesApart(const Grid& grid, base::Progress& progress, base::ProgressRange share);
void findRange(Coefficients& coefficients, base::Progress& progress);

// The recursive prefilter per axis. The boundary is a mirror half a voxel beyond the border samples
// (c[-1] = c[0]): what clamped lookups see, so that the border samples are interpolated too. Missing voxels
// are filled first (fill_missing.h). Multithreaded, float result, double arithmetic, time proportional to the
// voxels. With `progress` it reports how far it is and throws Error{interrupted}. Throws
// Error{memory} before anything is made.
Coefficients interpolatingCoefficients(const Grid& grid, base::Progress& progress);

}  // namespace isolux::volume
