// A context whose driver is reset when the test says so.
#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "render/gl/gl.h"
#include "render/gl/gl_context.h"

namespace isolux::test {

class LosingContext final : public render::OffscreenContext {
 public:
  // While true, contexts say that they are lost.
  static inline std::atomic<bool> lost{false};

  explicit LosingContext(std::unique_ptr<render::OffscreenContext> real) : real_(std::move(real)) {
    auto table = std::make_shared<render::Gl>(*real_->gl());
    table->GetGraphicsResetStatus = []() -> GLenum { return lost ? GL_UNKNOWN_CONTEXT_RESET : GL_NO_ERROR; };
    gl_ = std::move(table);
    description_ = real_->description();
  }
  void makeCurrent() override { real_->makeCurrent(); }

 private:
  std::unique_ptr<render::OffscreenContext> real_;
};

}  // namespace isolux::test
