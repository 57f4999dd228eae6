// Medians and quantiles of a list of numbers that is not empty and holds no NaN. Any thread.
#pragma once

#include <span>
#include <vector>

namespace isolux::base {

// Half way between the middle two of an even number.
double median(std::vector<double> values);
// The value at `part` of the way through the sorted list: 0 the least, 1 the greatest; between two of them
// the nearer one. The list is put into another order.
double quantile(std::span<double> values, double part);
// The same; between two of them the lower one, and the upper one.
double lowerQuantile(std::span<double> values, double part);
double upperQuantile(std::span<double> values, double part);

}  // namespace isolux::base
