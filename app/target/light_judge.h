// How far the light of a scene's picture is from path tracing: bakes it for what a small picture of the view
// shows, and draws it.
//
// The truth is traced once, of the first scene that is judged: with its bounces, at the exact hits of at most
// kJudgedPixels pixels (app/study/light_truth.h).
#pragma once

#include <memory>
#include <vector>

#include "app/light/light_controller.h"
#include "app/study/light_errors.h"
#include "app/study/surface_truth.h"
#include "render/renderer.h"
#include "scene/machine.h"

namespace isolux::app {

inline constexpr std::size_t kJudgedPixels = 768;

class LightJudge {
 public:
  LightJudge(render::Renderer& renderer, SurfaceTruth& truth,
             std::shared_ptr<const volume::PreparedVolume> volume, const scene::Machine& machine,
             glm::ivec2 size);

  // `scene` resolved and complete, its light stored. Throws Error{interrupted}.
  LightErrors judge(const scene::Scene& scene, base::Progress& progress);

 private:
  void trace(const scene::Scene& scene, base::Progress& progress);

  render::Renderer& renderer_;
  SurfaceTruth& surface_;
  std::shared_ptr<const volume::PreparedVolume> volume_;
  glm::ivec2 size_;
  LightController controller_;
  std::vector<TrueHit> hits_;
  LightTruth truth_;
};

}  // namespace isolux::app
