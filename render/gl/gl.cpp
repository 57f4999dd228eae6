#include "render/gl/gl.h"

#include "render/gl/gl_messages.h"
#include "render/gl/program_cache.h"

namespace isolux::render {

namespace {
[[noreturn]] void fail(const std::string& reason) {
  throw base::Error(base::ErrorKind::graphics, "", "OpenGL", reason);
}
}  // namespace

std::shared_ptr<const Gl> Gl::load(const GlLoader& loader) {
  auto gl = std::make_shared<Gl>();
  // The version first: an old context lacks functions, and "GL 3.1" says more than a missing name.
  gl->GetString = reinterpret_cast<PFNGLGETSTRINGPROC>(loader("glGetString"));
  gl->GetIntegerv = reinterpret_cast<PFNGLGETINTEGERVPROC>(loader("glGetIntegerv"));
  if (!gl->GetString || !gl->GetIntegerv || !gl->GetString(GL_VERSION)) fail("no context is current");
  GLint major = 0, minor = 0;
  gl->GetIntegerv(GL_MAJOR_VERSION, &major);
  gl->GetIntegerv(GL_MINOR_VERSION, &minor);
  if (major * 10 + minor < 45)
    fail("version 4.5 core is needed, found " + gl->string(GL_VERSION) + " on " + gl->string(GL_RENDERER));
#define ISOLUX_GL(type, name)                            \
  gl->name = reinterpret_cast<type>(loader("gl" #name)); \
  if (!gl->name) fail("the driver has no gl" #name);
#include "render/gl/gl_functions.inc"
#undef ISOLUX_GL
  static_cast<GlLimits&>(*gl) = askLimits(*gl);
  gl->programs = std::make_shared<ProgramCache>(*gl, programStore());
  listenToGl(*gl);
  return gl;
}

std::string Gl::string(GLenum name) const {
  const GLubyte* text = GetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

void Gl::throwIfLost() const {
  if (GetGraphicsResetStatus() != GL_NO_ERROR) throw ContextLost();
}

}  // namespace isolux::render
