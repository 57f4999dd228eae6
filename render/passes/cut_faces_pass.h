// Draws caps (clip.cap): finds where rays meet them, and colours them by the values there.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Finds t (mm; -1: none) and the value (data units; of label maps the label's colour, packed) of the cap
// that each ray meets (volume/clip/cut_faces.h). Always runs on the CPU. Rays end at caps; `resolve` colours
// them behind everything in front.
Pass cutFacesPass();

// The colours of a scene's caps.
struct CutFaceColors {
  volume::GreyWindow window;
  std::vector<glm::vec3> row;  // low to high, linear
  bool ofLabels = false;       // values are colours themselves
  glm::vec3 at(float value) const;
};
CutFaceColors cutFaceColors(const scene::Scene& scene, const volume::PreparedVolume& volume);

// Sets uCutFaces, uCutColors and uCutWindow of resolve.frag.glsl, on the units `unit` and `unit` + 1.
void setCutFaces(FrameState& frame, Program& program, int unit);
// Adds the caps behind the pixels of an image as large as the rays, premultiplied RGBA, bottom row first.
void addCutFaces(const FrameState& frame, std::vector<float>& rgba);

}  // namespace isolux::render
