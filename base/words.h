// Works with words: joins lists of them, and finds the one nearest to a mistyped word.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace isolux::base {

// Returns the candidate with the fewest single-letter edits from `word`, or "" if none is near enough. The
// limit is a third of the longer word's letters; two edits are always accepted for words above three letters.
std::string nearest(std::string_view word, std::span<const std::string> candidates);

// Replaces ASCII capital letters by small ones.
std::string lowerCase(std::string text);

// Returns ", did you mean NEAREST?", or `otherwise` if no candidate is near enough.
std::string didYouMean(std::string_view word, std::span<const std::string> candidates,
                       const std::string& otherwise);

// Returns the items of a range, or textOf(item) of each, with `between` between them. An empty text at the
// beginning is left out.
template <class Range, class TextOf = std::identity>
std::string joined(const Range& range, std::string_view between = ", ", TextOf textOf = {}) {
  std::string all;
  for (const auto& item : range) {
    if (!all.empty()) all += between;
    all += std::invoke(textOf, item);
  }
  return all;
}

}  // namespace isolux::base
