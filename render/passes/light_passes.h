// Stored light to irradiance at surface points: light (uploads) and irradiance
// (render/graph/pass_declarations.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "render/light/light_atlas.h"
#include "render/passes/frame_state.h"

namespace isolux::render {

class LightPasses {
 public:
  explicit LightPasses(const GlPtr& gl);

  // At the start of a frame: what it stores, by frame.light and the scene. `budgetBytes`: for stored light.
  void prepare(FrameState& frame, std::size_t budgetBytes);
  // As far as passes depend on it.
  LightState state(const FrameState& frame) const;

  void light(FrameState& frame);       // uploads
  void irradiance(FrameState& frame);  // of the frame's layer
  // The environment as a texture for what is seen behind the surface; made where it is new.
  void setBackground(FrameState& frame, Program& program, int unit);

  std::size_t bytes() const;  // on the GPU
  std::size_t atlasBytes() const { return atlas_.bytes(); }
  void report(LightReport& out) const;

 private:
  std::string definesOf(const FrameState& frame) const;
  void setLocalLight(const FrameState& frame, Program& program) const;
  void setLattice(const FrameState& frame, Program& program);

  LightAtlas atlas_;
  Buffer factors_;  // of transfer codes
  std::shared_ptr<const gi::PictureLight> factorsOf_;
  Texture background_;
  std::shared_ptr<const gi::Environment> backgroundOf_;
  std::uint64_t storage_ = 0;  // changes with what the atlas holds
  std::uint64_t unfinished_ = 0;
};

// 2^stops of a picture lit by stored light.
float exposureOf(const scene::Scene& scene, const gi::PictureLight* light);

}  // namespace isolux::render
