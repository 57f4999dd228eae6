#include "base/words.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace isolux::base {

namespace {

// Levenshtein distance, one row at a time.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
  constexpr std::size_t longestWord = 200;  // nobody mistypes more; keeps hostile input cheap
  if (word.empty() || word.size() > longestWord) return {};
  std::string best;
  std::size_t bestDistance = 0;
  for (const std::string& candidate : candidates) {
    const std::size_t longer = std::max(word.size(), candidate.size());
    const std::size_t allowed = std::max<std::size_t>(longer / 3, longer > 3 ? 2 : 1);
    const std::size_t distance = editDistance(word, candidate);
    if (distance <= allowed && (best.empty() || distance < bestDistance)) {
      best = candidate;
      bestDistance = distance;
    }
  }
  return best;
}

std::string lowerCase(std::string text) {
  for (char& letter : text)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return text;
}

std::string didYouMean(std::string_view word, std::span<const std::string> candidates,
                       const std::string& otherwise) {
  const std::string suggestion = nearest(word, candidates);
  return suggestion.empty() ? otherwise : ", did you mean " + suggestion + "?";
}

}  // namespace isolux::base
