// The faces that cuts lay open (clip.cap): where rays meet them, and the colours of the values there.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Of each ray t (mm; -1: none) and value (data units) of the cut face that it meets
// (volume/clip/cut_faces.h), computed on the processor whoever casts the rays. Rays end there; `resolve`
// colours what is behind all that lies in front.
class CutFacesPass : public Pass {
 public:
  CutFacesPass() : Pass("cut faces", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor&) const override { return true; }
};

// The colours of a scene's cut faces.
struct CutFaceColors {
  volume::GreyWindow window;
  std::vector<glm::vec3> row;  // low to high, linear
  glm::vec3 at(float value) const;
};
CutFaceColors cutFaceColors(const scene::Scene& scene, const volume::PreparedVolume& volume);

// uCutFaces, uCutColors and uCutWindow of resolve.frag.glsl, in the units `unit` and `unit` + 1.
void setCutFaces(FrameState& frame, Program& program, int unit);
// Behind the pixels of an image as large as the rays, premultiplied RGBA, bottom row first.
void addCutFaces(const FrameState& frame, std::vector<float>& rgba);

}  // namespace isolux::render
