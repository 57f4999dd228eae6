// Computes irradiance at surface points from baked lighting: the passes light and irradiance, and their
// shared data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "render/light/light_atlas.h"
#include "render/passes/frame_state.h"

namespace isolux::render {

// The light of the frames on the GPU, as passes and the renderer read it from frame.light.
class FrameLight {
 public:
  explicit FrameLight(const GlPtr& gl);

  // Sets the light to store at the start of a frame, from frame.light and the scene. `budgetBytes`: for baked
  // lighting.
  void prepare(FrameState& frame, std::size_t budgetBytes);
  // Returns the state that passes depend on.
  LightState state(const FrameState& frame) const;

  void upload(std::size_t limitBytes);
  std::string lampDefines(const FrameState& frame) const;  // of local_light.glsl
  // Return the defines and set the inputs of irradiance.frag.glsl.
  std::string defines(const FrameState& frame) const;
  void bind(FrameState& frame, Program& program);
  // Sets the light sources and the sky without anything in their way (local_light.glsl, LAMP_COUNT).
  void setLocalLight(const FrameState& frame, Program& program) const;
  // Sets the light behind transparent surfaces: uBehindOthers, uBehindItself.
  static void setLightThrough(const FrameState& frame, Program& program);
  // Sets the environment as a background texture; creates it if it is new.
  void setBackground(FrameState& frame, Program& program, int unit);
  // Sets the shadow on the ground (ground.glsl) as the frame's camera sees it. Requires that the light has
  // one.
  void setGround(FrameState& frame, Program& program, int unit);

  std::size_t bytes() const;  // on the GPU
  std::size_t atlasBytes() const { return atlas_.bytes(); }
  void report(LightReport& out) const;
  // Returns the texels per voxel of the stored light, 0 on an axis of one texel.
  glm::vec3 texelsPerVoxel() const;

 private:
  void setLattice(const FrameState& frame, Program& program);

  LightAtlas atlas_;
  Buffer factors_;  // of transfer codes
  std::shared_ptr<const gi::PictureLight> factorsOf_;
  Texture background_;
  std::shared_ptr<const gi::Environment> backgroundOf_;
  Texture ground_;
  std::uint64_t groundOf_ = 0;  // GroundShadow::key
  std::uint64_t storage_ = 0;   // changes with the contents of the atlas
  std::uint64_t unfinished_ = 0;
};

// Returns 2^stops, the exposure factor of an image lit by baked lighting.
float exposureOf(const scene::Scene& scene, const gi::PictureLight* light);
void addExposure(Declaring& d);  // declares that the result depends on it

}  // namespace isolux::render
