// Tells apart slices that lie at one position: time steps, echoes, diffusion weightings, kinds of image.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace isolux::volume {

// What a file states of an image beside its position, in the order in which it separates time steps.
inline constexpr std::array<std::string_view, 8> kImageTags{
    "image type",         "b-value",      "gradient direction", "echo time", "temporal position",
    "acquisition number", "trigger time", "acquisition time"};
enum ImageTag : std::size_t {
  kImageType,
  kBValue,
  kGradient,
  kEcho,
  kTemporal,
  kAcquisition,
  kTrigger,
  kTime
};
using ImageTags = std::array<std::string, kImageTags.size()>;  // as in the file; "": not stated

struct TimeSteps {
  std::vector<std::size_t> order;  // time step by time step, each position by position; indices of slices
  std::size_t count = 1;
  bool stated = true;  // false: only the order of the slices tells repeated ones apart
  std::vector<std::string> warnings;
};

// `positions`: the slices at each position, by instance number; one at least. `tags`: of each slice, or
// empty. Steps are complete: one slice from each position. Whatever does not fit into one is left out, with a
// warning.
TimeSteps separateRepeats(const std::vector<std::vector<std::size_t>>& positions,
                          const std::vector<ImageTags>& tags);

}  // namespace isolux::volume
