#include "ui/viewport/gl_bridge.h"

#include "render/gl/gl.h"

namespace isolux::ui {

std::shared_ptr<const render::Gl> loadGl(const std::function<void*(const char* name)>& getProcAddress) {
  return render::Gl::load(getProcAddress);
}

std::string describeGl(const render::Gl& gl) {
  return gl.string(GL_RENDERER) + ", OpenGL " + gl.string(GL_VERSION);
}

bool isSoftware(const render::Gl& gl) {
  return gl.software;
}

}  // namespace isolux::ui
