// FLIP: how different two pictures look to somebody who sees them in turns, per pixel from 0 (equal) to 1.
//
// Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference Evaluator for
// Alternating Images (Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020), for pictures of a screen's range:
// colours, seen through the eye's contrast sensitivity, by the HyAB distance in L*a*b* with the Hunt effect;
// edges and points, by derivatives of a Gaussian as wide as the eye's best frequency; and what features
// differ by lifts what colours differ by. Constants are the paper's. Pure functions; any thread; no errors.
#pragma once

#include <vector>

#include "app/image_metrics/compared_picture.h"

namespace isolux::app {

// Of a screen 0.7 m wide with 3840 pixels, seen from 0.7 m: the paper's 67.
inline constexpr double kFlipPixelsPerDegree = 67.0206432765823;

// Of each pixel. Both pictures of one size, with at least one pixel. `pixelsPerDegree` of the visual angle,
// above 0: fewer, and single pixels are seen better.
std::vector<double> flipImage(const ComparedPicture& reference, const ComparedPicture& test,
                              double pixelsPerDegree = kFlipPixelsPerDegree);
// Its mean.
double meanFlip(const ComparedPicture& reference, const ComparedPicture& test,
                double pixelsPerDegree = kFlipPixelsPerDegree);

}  // namespace isolux::app
