// Which values slices and cut faces show from black to white. Any thread.
#pragma once

#include "scene/scene.h"
#include "volume/statistics/histogram.h"

namespace isolux::volume {

// Values up to level − width / 2 are black, from level + width / 2 on white; between them grey grows evenly.
struct GreyWindow {
  double level = 0.0, width = 1.0;  // data units; width >= 0
  // 0 for black to 1 for white; a width of 0 is a threshold. NaN stays NaN.
  double greyOf(double value) const;
  bool operator==(const GreyWindow&) const = default;
};

// From the 1st to the 99th percentile of the values, even within a bin of the histogram; where these are in
// one bin, the whole range; where that is one value, a width of 1 about it.
GreyWindow greyWindow(const Histogram& histogram);
// The same where slice.level or slice.width is automatic.
GreyWindow greyWindow(const scene::Slice& slice, const Histogram& histogram);

}  // namespace isolux::volume
