// Formats numbers as text, independently of the locale. Safe from any thread; reports no errors.
#pragma once

#include <cstdint>
#include <string>

namespace isolux::base {

// Returns at most `significant` digits without trailing zeros. Uses an exponent where that is shorter (%g)
// and the number is not from 1 to 1 000 000.
std::string shortText(double value, int significant = 6);
// Returns the shortest text that reads back as the same number.
std::string shortestText(double value);
// Returns a text that reads back as the same number in any reader: shortText() if that suffices, else 17
// digits.
std::string exactText(double value);
// Returns 16 hexadecimal digits.
std::string hexText(std::uint64_t value);

}  // namespace isolux::base
