// A picture with the light it needs, for commands: draws to find what is seen, bakes that, and hands the
// light to the renderer.
#pragma once

#include <optional>

#include "app/light/light_controller.h"
#include "render/renderer.h"

namespace isolux::app {

// The scene whose light a request reads: with deferred irradiance, any look's.
scene::Scene litScene(scene::Scene resolved, const render::FrameRequest& request);

// Bakes what the picture of `resolved`, whose fields are there (completeFields()), shows, as far as gi.extent
// says, and gives it to `renderer`; nothing is baked for pictures that read no light. Throws base::Error,
// also when `progress` is stopped.
void lightPicture(LightController& controller, render::Renderer& renderer, const scene::Scene& resolved,
                  const render::FrameRequest& request,
                  const std::shared_ptr<const volume::PreparedVolume>& volume, base::Progress& progress);

// Returns the exposure for app::carriedScene() of a picture of `resolved`: LightController::viewExposure(),
// if the picture is exposed automatically.
std::optional<double> exposureToCarry(const LightController& controller, const scene::Scene& resolved);

}  // namespace isolux::app
