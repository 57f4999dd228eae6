// Puts the legend of a scene into its finished picture.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// The colours of look.mode's measure, as the shaders look them up: a row of samples, or a square.
struct MeasureColors {
  glm::ivec2 size{0};
  std::vector<glm::vec3> texels;
};
MeasureColors measureColors(const scene::Look& look);

// Blends the legend into the lower right corner of `picture`; nothing where it would cover most of the
// picture.
void drawLegendOver(FrameState& frame, const Target& picture, glm::dvec2 range);

}  // namespace isolux::render
