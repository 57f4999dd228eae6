// Loads a light probe on a background thread, small enough to be shown in a panel; the owner polls.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/error.h"

namespace isolux::ui {

// Equirectangular, row 0 up, linear RGB radiance: means of the probe's pixels.
struct ProbeThumbnail {
  glm::ivec2 size{0};
  std::vector<glm::vec3> pixels;
  double meanLuminance = 0.0;                // over the sphere
  std::size_t badPixels = 0;                 // of the file: not numbers
  glm::vec3 at(glm::dvec3 direction) const;  // in the environment's own axes (gi/environment.h)
};

class ProbeJob {
 public:
  explicit ProbeJob(std::string file);  // starts at once
  ~ProbeJob();                          // waits

  const std::string& file() const { return file_; }
  bool finished() const { return finished_.load(std::memory_order_acquire); }
  // After finished(): the picture, or the error.
  const ProbeThumbnail& thumbnail() const { return thumbnail_; }
  const std::optional<scene::Error>& error() const { return error_; }

 private:
  std::string file_;
  std::atomic<bool> finished_{false};
  ProbeThumbnail thumbnail_;
  std::optional<scene::Error> error_;
  std::thread thread_;
};

}  // namespace isolux::ui
