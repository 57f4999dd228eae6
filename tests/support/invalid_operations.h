// Whether arithmetic met an operation without a result: 0 / 0, infinity - infinity, a root of a negative
// number, NaN as a whole number (IEEE 754's exception "invalid"; a NaN that is only handed on does not
// count). What becomes of such a NaN depends on the order of later comparisons; this sees that there is none.
#pragma once

#include <cfenv>

namespace isolux::test {

// Of the calling thread, from construction on.
class InvalidOperations {
 public:
  InvalidOperations() { std::feclearexcept(FE_INVALID); }
  bool met() const { return std::fetestexcept(FE_INVALID) != 0; }
};

}  // namespace isolux::test
