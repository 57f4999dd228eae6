// Computes sine, cosine, exponential and arc cosine bit-identically on every machine.
//
// Uses only additions, products, quotients and square roots, which IEEE 754 defines exactly. Variants of the
// C library for different processors differ in the last bits. Baked lighting depends on these functions.
//
// The error is within one unit in the last place. Method and coefficients: Sun's fdlibm 5.3 (freely
// distributable with its notice: "Copyright (C) 1993-2004 by Sun Microsystems, Inc. All rights reserved.").
// Requires that the compiler does not fuse sums of products: the build sets -ffp-contract=off.
#pragma once

namespace isolux::base {

double portableSin(double radians);  // requires |radians| <= 1e5, else NaN
double portableCos(double radians);
double portableExp(double x);        // 0 below -708, infinite above 709
double portableAcos(double cosine);  // requires [-1, 1], else NaN

}  // namespace isolux::base
