// How far a picture is from another, and whether that can be the driver's doing.
#pragma once

#include "render/graph/frame.h"

namespace isolux::test {

// In steps of 8 bits; of a pixel, the channel that differs most.
struct PictureDifference {
  double mean = 0.0;     // over all channels of all pixels
  double visible = 0.0;  // part of the pixels that differ by more than kVisibleSteps
  int largest = 0;
};
constexpr int kVisibleSteps = 8;

// Both of one size.
PictureDifference differenceOf(const render::ColorImage& a, const render::ColorImage& b);

// Whether another driver, compiler or processor may make that of the same arithmetic: at most 0.05 in the
// mean, and 0.5 % of the pixels visibly, since where a ray just meets or just misses they may disagree by
// much. llvmpipe without SSE and fused operations is 0.0005 in the mean from llvmpipe with AVX-512, and 0.002
// % of the pixels. A graphics card whose arithmetic were off by 1e-5 would flip the rounding of a channel in
// a thousand and a few silhouettes: 0.003.
bool mayBeRounding(const PictureDifference& difference);

// Grey where both agree, brighter and darker by eight times the difference.
render::ColorImage amplifiedDifference(const render::ColorImage& a, const render::ColorImage& b);

}  // namespace isolux::test
