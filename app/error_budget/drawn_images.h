// Deferred images of a picture that is drawn strip by strip: between two strips a stop is heard.
#pragma once

#include <span>
#include <vector>

#include "base/progress.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace isolux::app {

// One for each of `aovs`: row 0 at the top, as render::Renderer::readAov() gives them for the whole picture.
// `size` in pixels. Throws as Renderer::render(), and Error{interrupted}.
std::vector<std::vector<float>> drawnImages(render::Renderer& renderer, const scene::Scene& resolved,
                                            glm::ivec2 size, std::span<const render::Aov> aovs,
                                            base::Progress& progress);

}  // namespace isolux::app
