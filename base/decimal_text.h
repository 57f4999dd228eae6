// Writes and reads decimal numbers with a fixed number of decimals, independently of the locale.
// base/number_text.h has other formats. Safe from any thread; reports no errors.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace isolux::base {

// Returns `value` with `decimals` (0 to 20) digits after the point, as %.*f in the C locale: 0.5 with 2 gives
// "0.50".
std::string fixedText(double value, int decimals);

// Returns the number that the whole of `text` spells; a leading sign is accepted. Returns nullopt if `text`
// is not a number or the number is not finite.
std::optional<double> readNumber(std::string_view text);

// Returns the two whole numbers of "A-B", where '-' is the separator; nullopt for any other text.
std::optional<std::pair<int, int>> readTwoIntegers(std::string_view text, char separator);

}  // namespace isolux::base
