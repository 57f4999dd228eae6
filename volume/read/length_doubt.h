// Whether lengths in a volume can be trusted: what readers say when they had to guess or make up where voxels
// lie.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace isolux::volume {

// Readers' warnings hold these words where it is so.
inline constexpr std::string_view kSpacingAssumed = "1 mm assumed";
inline constexpr std::string_view kSlicesResampled = "resampled linearly";

// The first of the warnings that casts doubt on lengths.
std::optional<std::string> lengthDoubt(std::span<const std::string> warnings);

}  // namespace isolux::volume
