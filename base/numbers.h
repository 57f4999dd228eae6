// Computes round numbers for axes, steps and scale bars. Safe from any thread; reports no errors.
#pragma once

namespace isolux::base {

// Returns the largest of 1, 2, 5 times a power of ten that is at most `value`; 1 unless `value` > 0.
double niceBelow(double value);
// Returns the smallest such number that is at least `value`; 1 unless `value` > 0.
double niceAbove(double value);
// Returns the decimal number nearest to `value` rounded to a multiple of `step`. Requires `step` from
// niceBelow().
double roundedToStep(double value, double step);

}  // namespace isolux::base
