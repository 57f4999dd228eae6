// Whether the values of a CT can be what they are said to be.
#pragma once

#include "volume/statistics/histogram.h"

namespace isolux::volume {

// True when values said to be Hounsfield units are those plus 1024 (or 1000), as scanners store them before
// the rescale: air, at least 5 % of the voxels, at 0 instead of -1000; soft tissue, at least 5 % again, round
// 1050; in between less than there; `minimum`, the least value, not below 0. Empty counts: false.
bool looksOffsetBy1024(const Histogram& histogram, double minimum);

}  // namespace isolux::volume
