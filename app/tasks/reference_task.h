// Path traces every pixel of the view on a background thread, without stored light.
//
// The picture becomes better round by round. A round is a whole picture, with what a window shows of it made
// ready, because pictures may have hundreds of millions of pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include <glm/vec2.hpp>

#include "base/task.h"
#include "gi/reference/reference.h"
#include "render/graph/frame.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

using ReferencePointer = std::shared_ptr<const gi::ReferenceImage>;

struct ReferenceRound {
  gi::ReferenceImage image;
  render::ColorImage picture, noise;  // app::screenImage() and noiseImage(), reduced() to previewPixels
  std::optional<double> noisePart;    // noiseOf()
};
using RoundPointer = std::shared_ptr<const ReferenceRound>;
inline constexpr int previewPixels = 1600;  // along the longer side, at most

// Its news: the latest round; null before the first.
using ReferenceTask = base::Task<void, RoundPointer>;
// `resolved` by scene::resolve of that volume; `threads`: scene::HostSettings::threads.
std::unique_ptr<ReferenceTask> referenceTask(std::shared_ptr<const volume::PreparedVolume> volume,
                                             scene::Scene resolved, glm::ivec2 size, std::uint32_t samples,
                                             std::optional<int> threads = {});

// The standard error of each pixel's luminance of E, in parts of the picture's mean, as a brightness: white
// is 10 % or more.
render::ColorImage noiseImage(const gi::ReferenceImage& image);
// Root mean square of the standard error over the pixels hit, in parts of their mean luminance of E; nothing
// before the second sample.
std::optional<double> noiseOf(const gi::ReferenceImage& image);
// Means over squares of the smallest whole size that leaves at most `longest` pixels along either side; the
// squares of the last column and row may be cut off.
render::ColorImage reduced(const render::ColorImage& image, int longest);

}  // namespace isolux::app
