// A renderer with an OpenGL context of its own, for the thread that makes it.
#pragma once

#include <memory>

#include "render/gl/gl_context.h"
#include "render/renderer.h"

namespace isolux::render {

class OffscreenRenderer {
 public:
  // Throws as OffscreenContext::create().
  explicit OffscreenRenderer(ContextChoice choice, const scene::HostSettings& host = {})
      : context_(OffscreenContext::create(choice)), renderer_(context_->gl()) {
    renderer_.setHostSettings(host);
  }
  Renderer& operator*() { return renderer_; }
  Renderer* operator->() { return &renderer_; }
  const OffscreenContext& context() const { return *context_; }

 private:
  std::unique_ptr<OffscreenContext> context_;
  Renderer renderer_;
};

}  // namespace isolux::render
