// Numbers as text, the same in every locale. Any thread; no errors.
#pragma once

#include <cstdint>
#include <string>

namespace isolux::base {

// For reading: so many significant digits at most, no trailing zeros, an exponent where that is shorter (%g).
std::string shortText(double value, int significant = 6);
// Reads back as the same number: the fewest characters.
std::string shortestText(double value);
// Reads back as the same number in any reader: shortText() where that does, else 17 digits.
std::string exactText(double value);
// 16 hexadecimal digits.
std::string hexText(std::uint64_t value);

}  // namespace isolux::base
