// Path traces every pixel of the view on a background thread, without stored light; the owner polls.
//
// The picture becomes better round by round: round() is always the newest whole one, with what a window shows
// of it made ready, because pictures may have hundreds of millions of pixels.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>

#include <glm/vec2.hpp>

#include "base/error.h"
#include "base/progress.h"
#include "base/retire.h"
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

class ReferenceJob {
 public:
  // Starts at once. `resolved` by scene::resolve of that volume; `threads`: scene::Machine::threads.
  ReferenceJob(std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene resolved, glm::ivec2 size,
               std::uint32_t samples, std::optional<int> threads = {});
  ~ReferenceJob();  // stops; the end of the work is not waited for (base/retire.h)

  const scene::Scene& resolved() const { return work_->resolved; }
  std::uint32_t samples() const { return work_->samples; }
  base::Progress& progress() { return work_->progress; }
  const base::Progress& progress() const { return work_->progress; }
  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  RoundPointer round() const;  // the latest; null before the first
  // After finished(): what went wrong; stopping is no error.
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    std::shared_ptr<const volume::PreparedVolume> volume;
    scene::Scene resolved;
    glm::ivec2 size{0};
    std::uint32_t samples = 0;
    int threads = 1;
    base::Progress progress;
    std::mutex mutex;
    RoundPointer round;  // guarded by mutex
    std::atomic<bool> finished{false};
    std::optional<base::Error> error;
  };
  static void run(Work& work);
  static void trace(Work& work);

  base::RetiringThread<Work> work_;
};

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
