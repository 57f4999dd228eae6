#include "render/gl/gl_messages.h"

#include "render/gl/gl.h"

namespace isolux::render {

namespace {

constexpr std::size_t kMostKept = 64;

struct Errors {
  std::vector<std::string> texts;
  std::size_t count = 0;
};

Errors& errorsOfThread() {
  thread_local Errors errors;
  return errors;
}

void APIENTRY keep(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                   const void*) {
  if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
  Errors& errors = errorsOfThread();
  if (++errors.count > kMostKept) return;
  errors.texts.emplace_back(
      text, length < 0 ? std::char_traits<char>::length(text) : static_cast<std::size_t>(length));
}

}  // namespace

void listenToGl(const Gl& gl) {
  gl.Enable(GL_DEBUG_OUTPUT);
  gl.Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
  gl.DebugMessageCallback(keep, nullptr);
  gl.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
  gl.DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
  gl.DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_HIGH, 0, nullptr, GL_TRUE);
}

const std::vector<std::string>& glErrors() {
  return errorsOfThread().texts;
}

std::size_t glErrorCount() {
  return errorsOfThread().count;
}

void forgetGlErrors() {
  errorsOfThread() = {};
}

}  // namespace isolux::render
