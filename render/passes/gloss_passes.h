// Traces what glossy surfaces reflect under global illumination, and sets what the look's shader reads of it
// (resources/shaders/light/gloss.glsl).
//
// Rays are traced on the CPU whatever the executor (gi/gloss/reflections.h), one for each cell of 2 x 2
// pixels, or 4 x 4 in frames of one ray a pixel. A cell's result is the mean over the cells around it that
// show the same surface. Cells are those of the whole image, so tiles agree with it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gi/gloss/reflections.h"
#include "render/gl/image_pool.h"
#include "render/graph/pass.h"
#include "scene/rules/needs.h"

namespace isolux::render {

// Traces reflections at one point of each cell.
Pass reflectionsPass();

// Sets the uniforms of gloss.glsl that are not of the reflections' images.
class GlossUniforms {
 public:
  static void declare(Declaring& d);
  void set(FrameState& frame, Program& program, int unit);

 private:
  Texture environments_;  // squares in the order of GlossLight::environments
  std::vector<std::shared_ptr<const gi::FilteredEnvironment>> of_;
};

// Returns how many pixels beside its own a pixel's gloss depends on.
int reachOfGloss();

}  // namespace isolux::render
