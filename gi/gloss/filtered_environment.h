// Provides an environment filtered by the gloss lobe: what a surface with nothing in the way reflects.
//
// Both functions are maps of one size in the environment's own frame (gi/sampling/environment.h), coarser for
// rougher surfaces: coarse() is the environment's mean in each pixel, filtered() its integral with the lobe
// about the pixel's middle. The size leaves several pixels within a standard deviation of the lobe, at most
// 256 x 128 in all; a smoother surface reflects at 1.4 degrees. Immutable.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "gi/sampling/environment.h"

namespace isolux::gi {

class FilteredEnvironment {
 public:
  FilteredEnvironment(const Environment& environment, float roughness);

  float roughness() const { return roughness_; }
  const Environment& coarse() const { return coarse_; }
  const Environment& filtered() const { return filtered_; }

 private:
  float roughness_;
  Environment coarse_, filtered_;
};

}  // namespace isolux::gi
