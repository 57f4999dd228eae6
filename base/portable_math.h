// Sine, cosine, exponential and arc cosine that are the same bit by bit on every machine: of additions,
// products, quotients and square roots alone, which IEEE 754 rounds in one way. Those of the C library have
// variants for processors, whose last bits differ: what stored light depends on is computed by these.
//
// Within one unit in the last place of the true value. Method and coefficients: Sun's fdlibm 5.3 (freely
// distributable with its notice: "Copyright (C) 1993-2004 by Sun Microsystems, Inc. All rights reserved.").
// Not for sums of products that a compiler may fuse: the build says -ffp-contract=off.
#pragma once

namespace isolux::base {

double portableSin(double radians);  // |radians| at most 1e5; NaN beyond
double portableCos(double radians);
double portableExp(double x);        // 0 below -708, infinite above 709
double portableAcos(double cosine);  // in [-1, 1], else NaN

}  // namespace isolux::base
