// A renderer for the thread that makes it, beside the window's own: it casts on the processor, since the
// volume lies on the graphics card once, for the user.
#pragma once

#include <memory>
#include <utility>

#include "gi/picture_light.h"
#include "render/offscreen_renderer.h"

namespace isolux::app {

struct QuietRenderer : render::OffscreenRenderer {
  // light: null where there is none.
  QuietRenderer(std::shared_ptr<const volume::PreparedVolume> volume,
                std::shared_ptr<const gi::PictureLight> light)
      : OffscreenRenderer(render::ContextChoice::automatic, {.executor = scene::Executor::cpu}) {
    (*this)->setVolume(std::move(volume));
    (*this)->setLight(std::move(light));
  }
};

}  // namespace isolux::app
