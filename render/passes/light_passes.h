// Stored light to irradiance at surface points: the passes light and irradiance, and what they share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "render/light/light_atlas.h"
#include "render/passes/frame_state.h"

namespace isolux::render {

// The light of the frames on the GPU: what passes, and the renderer, read of frame.light.
class FrameLight {
 public:
  explicit FrameLight(const GlPtr& gl);

  // At the start of a frame: what it stores, by frame.light and the scene. `budgetBytes`: for stored light.
  void prepare(FrameState& frame, std::size_t budgetBytes);
  // As far as passes depend on it.
  LightState state(const FrameState& frame) const;

  void upload(std::size_t limitBytes);
  // What irradiance.frag.glsl reads, and with which defines.
  std::string defines(const FrameState& frame) const;
  void bind(FrameState& frame, Program& program);
  // The environment as a texture for what is seen behind the surface; made where it is new.
  void setBackground(FrameState& frame, Program& program, int unit);

  std::size_t bytes() const;  // on the GPU
  std::size_t atlasBytes() const { return atlas_.bytes(); }
  void report(LightReport& out) const;

 private:
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

// Uploads of stored light that changed since the last frame.
class LightPass : public Pass {
 public:
  LightPass() : Pass("light", "", {}) {}
  void declare(Declaring& d) const override;
  void run(FrameState& frame) override;
  std::optional<std::size_t> bytes(const FrameState& frame) const override;
};

// Stored light, looked up at the surface points; local light where nothing is stored.
class IrradiancePass : public Pass {
 public:
  IrradiancePass() : Pass(pass::irradiance, "irradiance.frag.glsl", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;
};

// 2^stops of a picture lit by stored light.
float exposureOf(const scene::Scene& scene, const gi::PictureLight* light);
void addExposure(Declaring& d);  // the result depends on it

}  // namespace isolux::render
