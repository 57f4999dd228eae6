// Computes medians and quantiles of numbers. Requires a non-empty list without NaN. Safe from any thread.
#pragma once

#include <span>
#include <vector>

namespace isolux::base {

// Returns the median; of an even count, the mean of the middle two.
double median(std::vector<double> values);
// Returns the quantile `part` in [0, 1] (0 the minimum, 1 the maximum); between two values, the nearer one.
// Reorders `values`.
double quantile(std::span<double> values, double part);
// As quantile(); between two values, the lower or the upper one.
double lowerQuantile(std::span<double> values, double part);
double upperQuantile(std::span<double> values, double part);

}  // namespace isolux::base
