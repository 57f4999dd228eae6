// A renderer for the thread that makes it, beside the window's own: it casts on the processor, since the
// volume lies on the graphics card once, for the user.
#pragma once

#include <memory>
#include <utility>

#include "gi/picture_light.h"
#include "render/gl/gl_context.h"
#include "render/renderer.h"

namespace isolux::app {

class QuietRenderer {
 public:
  // light: null where there is none.
  QuietRenderer(std::shared_ptr<const volume::PreparedVolume> volume,
                std::shared_ptr<const gi::PictureLight> light)
      : context_(current()), renderer_(context_->gl()) {
    scene::Machine machine;
    machine.executor = scene::Executor::cpu;
    renderer_.setMachine(machine);
    renderer_.setVolume(std::move(volume));
    renderer_.setLight(std::move(light));
  }

  render::Renderer& renderer() { return renderer_; }

 private:
  static std::unique_ptr<render::OffscreenContext> current() {
    auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
    context->makeCurrent();
    return context;
  }

  std::unique_ptr<render::OffscreenContext> context_;
  render::Renderer renderer_;
};

}  // namespace isolux::app
