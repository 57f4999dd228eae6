// The area of a trilinear isosurface by counting where lines at random meet it (Cauchy-Crofton): an oracle
// that shares nothing with the quadrature but the exact hits.
#pragma once

#include <cstddef>

#include "volume/grid.h"

namespace isolux::test {

struct LineArea {
  double areaMm2 = 0.0, deviationMm2 = 0.0;  // standard deviation of the estimate
};

// Parallel to every direction alike, through a disc about the volume: the mean number of crossings is area /
// (2 times the disc's). The same lines each time.
LineArea areaByLines(const volume::Grid& grid, double isovalue, std::size_t lines);

}  // namespace isolux::test
