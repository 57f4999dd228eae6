#include "app/light/light_picture.h"

#include <algorithm>

#include <glm/common.hpp>

#include "scene/rules/needs.h"

namespace isolux::app {

scene::Scene litScene(scene::Scene resolved, const render::FrameRequest& request) {
  const bool readsIrradiance = std::ranges::find(request.aovs, render::Aov::irradiance) != request.aovs.end();
  if (readsIrradiance && scene::shadingOf(resolved) != scene::Shading::gi)
    resolved.look.mode = scene::LookMode::gi;
  return resolved;
}

void lightPicture(LightController& controller, render::Renderer& renderer, const scene::Scene& resolved,
                  const render::FrameRequest& request,
                  const std::shared_ptr<const volume::PreparedVolume>& volume, base::Progress& progress) {
  const scene::Scene lit = litScene(resolved, request);
  controller.setScene(lit, volume);
  if (scene::giChoiceOf(lit).wanted) {
    render::FrameRequest surface = request;
    surface.linear = surface.color = false;
    // What lies between the points of this many is near one of them.
    while (std::max(surface.size.x, surface.size.y) * surface.supersampling > 4096) surface.size /= 2;
    surface.size = glm::max(surface.size, glm::ivec2(1));
    surface.hits = render::FrameRequest::Hits::all;  // in the dark one unlit texel's local light glares
    surface.color = scene::isTransparent(resolved);  // what is behind is found where it is shaded
    surface.aovs = std::vector{render::Aov::voxel};
    renderer.render(resolved, surface);
    controller.setVisible(renderer.hitVoxels());
    if (scene::showsGloss(lit)) {  // frames with light report what it reflects, too
      while (!controller.settle(0.1)) progress.throwIfStopped();
      renderer.setLight(controller.light());
      surface.color = true;
      renderer.render(lit, surface);
      controller.setVisible(renderer.hitVoxels());
    }
  }
  if (!controller.finish(progress)) progress.throwIfStopped();
  renderer.setLight(controller.light());
}

std::optional<double> exposureToCarry(const LightController& controller, const scene::Scene& resolved) {
  const bool isAutomatic = scene::usesGi(resolved) && !resolved.picture.exposure;
  return isAutomatic ? controller.viewExposure() : std::nullopt;
}

}  // namespace isolux::app
