// Loads an environment (a light probe, or a built-in light) on a background thread, small enough to be shown
// in a panel.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/task.h"
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

using ProbeTask = base::Task<ProbeThumbnail>;
std::unique_ptr<ProbeTask> probeTask(scene::Environment environment);

}  // namespace isolux::app
