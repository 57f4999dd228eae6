// Whether lengths and voxels of a volume can be trusted: what readers say when they had to guess or make up
// where voxels lie, or voxels themselves.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace isolux::volume {

// Readers' warnings hold these words where it is so.
inline constexpr std::string_view kSpacingAssumed = "1 mm assumed";
inline constexpr std::string_view kSliceDistanceAssumed = "assumed as the distance of slices";
inline constexpr std::string_view kSlicesResampled = "resampled linearly";
inline constexpr std::string_view kUnevenSpacing = "unevenly spaced";
inline constexpr std::string_view kSlicesMissing = "slices are missing in ";  // then how many places

// The first of the warnings that says lengths are a guess: of a file that does not state its spacing.
std::optional<std::string> spacingDoubt(std::span<const std::string> warnings);
// Of slices that are unevenly far apart, and were resampled, the largest distance, mm: where they lie is
// stated, what lies between them is not known.
std::optional<double> widestSlicesMm(std::span<const std::string> warnings);
// What of the voxels was not measured, in a few words each, worst first: "13 gaps interpolated".
std::vector<std::string> inventedData(std::span<const std::string> warnings);

}  // namespace isolux::volume
