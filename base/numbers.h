// Round numbers for axes, steps and scale bars. Any thread; no errors.
#pragma once

namespace isolux::base {

// The largest of 1, 2, 5 times a power of ten that is not above `value` (> 0; else 1).
double niceBelow(double value);
// The smallest that is not below `value` (> 0; else 1).
double niceAbove(double value);
// `value` rounded to the nearest multiple of `step` (a result of niceBelow), as the nearest decimal number.
double roundedToStep(double value, double step);

}  // namespace isolux::base
