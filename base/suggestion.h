// Finds the known word nearest to a mistyped one, for "Did you mean ...?".
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace isolux::base {

// Returns the candidate with the fewest single-letter edits from `word`, or "" if none is near enough. The
// limit is a third of the longer word's letters; two edits are always accepted for words above three letters.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace isolux::base
