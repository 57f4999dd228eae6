// What float values are brought to before float arithmetic: (value - offset) * 2^-exponent.
#pragma once

namespace isolux::volume {

struct ValueScaling {
  float offset = 0.0f;
  int exponent = 0;
};

// The power of two by which the largest magnitude becomes about 1, or, where it is beyond 2^40, at most 2^40;
// clamped to what float has.
int exponentOf(double least, double most);
// The same with an offset where subtracting it rounds nothing: every value within a factor of two of it.
ValueScaling scalingOf(double least, double most);

}  // namespace isolux::volume
