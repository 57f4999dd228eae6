// Loads an environment (a light probe, or a built-in light) on a background thread, small enough to be shown
// in a panel; the owner polls.
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/error.h"
#include "base/retire.h"
#include "scene/scene.h"

namespace isolux::app {

// Equirectangular, row 0 up, linear RGB radiance: means of the probe's pixels.
struct ProbeThumbnail {
  glm::ivec2 size{0};
  std::vector<glm::vec3> pixels;
  double meanLuminance = 0.0;                // over the sphere
  std::size_t badPixels = 0;                 // of the file: not numbers
  glm::vec3 at(glm::dvec3 direction) const;  // in the environment's own axes (gi/sampling/environment.h)
};

class ProbeJob {
 public:
  // Starts at once; thrown away, it ends elsewhere (base/retire.h).
  explicit ProbeJob(scene::Environment settings);

  bool finished() const { return work_->finished.load(std::memory_order_acquire); }
  // After finished(): the picture, or the error.
  const ProbeThumbnail& thumbnail() const { return work_->thumbnail; }
  const std::optional<base::Error>& error() const { return work_->error; }

 private:
  struct Work {
    scene::Environment settings;
    std::atomic<bool> finished{false};
    ProbeThumbnail thumbnail;
    std::optional<base::Error> error;
  };
  static void run(Work& work);

  base::RetiringThread<Work> work_;
};

}  // namespace isolux::app
