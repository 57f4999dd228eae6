#include "volume/read/input/spacing_reliability.h"

#include <charconv>

namespace isolux::volume {

std::optional<std::string> spacingDoubt(std::span<const std::string> warnings) {
  for (const std::string& warning : warnings)
    for (const std::string_view doubt : {kSpacingAssumed, kSliceDistanceAssumed, kUnevenSpacing})
      if (warning.find(doubt) != std::string::npos) return warning;
  return std::nullopt;
}

std::optional<double> widestSlicesMm(std::span<const std::string> warnings) {
  constexpr std::string_view before = " to ";  // "uneven (1.081 to 6.999 mm): resampled linearly"
  for (const std::string& warning : warnings) {
    const std::size_t end = warning.find(kSlicesResampled), at = warning.rfind(before, end);
    if (end == std::string::npos || at == std::string::npos) continue;
    double mm = 0.0;
    const char* const number = warning.data() + at + before.size();
    if (std::from_chars(number, warning.data() + end, mm).ec == std::errc()) return mm;
  }
  return std::nullopt;
}

std::vector<std::string> inventedData(std::span<const std::string> warnings) {
  std::vector<std::string> missing, resampled;
  for (const std::string& warning : warnings) {
    if (const std::size_t at = warning.find(kSlicesMissing); at != std::string::npos) {
      const std::size_t number = at + kSlicesMissing.size();
      const std::string count = warning.substr(number, warning.find(' ', number) - number);
      missing.push_back(count + (count == "1" ? " gap interpolated" : " gaps interpolated"));
    }
    if (warning.find(kSlicesResampled) != std::string::npos)
      resampled.emplace_back("uneven slices resampled");
  }
  missing.insert(missing.end(), resampled.begin(), resampled.end());
  return missing;
}

}  // namespace isolux::volume
