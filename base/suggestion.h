// "Did you mean ...?": the known word nearest to a mistyped one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace isolux::base {

// The candidate with the fewest single-letter edits from `word`; empty when none is near enough to be meant
// (more edits than a third of the longer word, but two are always allowed for words above three letters).
std::string nearest(std::string_view word, std::span<const std::string> candidates);

}  // namespace isolux::base
