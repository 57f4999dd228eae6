// Decimal numbers with a fixed number of decimals, and their reading: the same in every locale. Other forms
// are in base/number_text.h. Any thread; no errors.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace isolux::base {

// "0.50" of 0.5 and 2 `decimals` (0 to 20), as %.*f in the C locale.
std::string fixedText(double value, int decimals);

// The number that is all of `text`, which may begin with a sign; nothing where it is none, or is not finite.
std::optional<double> readNumber(std::string_view text);

}  // namespace isolux::base
