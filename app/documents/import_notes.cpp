#include "app/documents/import_notes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace isolux::app {

namespace {

// The worst first.
constexpr std::array<std::string_view, 13> kGraveWords{
    "cannot be read", "checksum",    "unreadable",    "are missing", "count as missing",
    "interpolated",   "resampled",   "boundary edge", "one side",    "gantry tilt",
    "assumed",        "not certain", "off the line"};

std::size_t rankOf(const std::string& note) {
  const auto found = std::ranges::find_if(
      kGraveWords, [&](std::string_view word) { return note.find(word) != std::string::npos; });
  return static_cast<std::size_t>(found - kGraveWords.begin());
}

}  // namespace

ImportNotes importNotes(std::span<const std::string> warnings) {
  ImportNotes sorted{{warnings.begin(), warnings.end()}};
  std::ranges::stable_sort(sorted.notes,
                           [](const std::string& a, const std::string& b) { return rankOf(a) < rankOf(b); });
  sorted.grave = static_cast<std::size_t>(std::ranges::count_if(
      sorted.notes, [](const std::string& note) { return rankOf(note) < kGraveWords.size(); }));
  return sorted;
}

}  // namespace isolux::app
