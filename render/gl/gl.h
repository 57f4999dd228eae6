// Loads the GL 4.5 core functions that Isolux calls into one table, through a context's own getProcAddress.
//
// Loader libraries (glbinding, GLEW, epoxy) cannot load from OSMesa; this table can be loaded from any
// context.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <GL/glcorearb.h>

#include "base/error.h"
#include "render/gl/gl_limits.h"

namespace isolux::render {

class ProgramCache;

using GlLoader = std::function<void*(const char* name)>;

// The driver was reset: nothing of the context is valid any more, and a new one is needed.
class ContextLost : public base::Error {
 public:
  ContextLost() : Error(base::ErrorKind::graphics, "", "", "the graphics driver was reset") {}
};

struct Gl : GlLimits {
#define ISOLUX_GL(type, name) type name = nullptr;
#include "render/gl/gl_functions.inc"
#undef ISOLUX_GL

  std::shared_ptr<ProgramCache> programs;  // of the context; null: every program is compiled

  // Loads every function, checks the version and records errors (render/gl/gl_messages.h). Requires a current
  // context. Throws base::Error{graphics} naming the first missing function or the version found.
  static std::shared_ptr<const Gl> load(const GlLoader& loader);

  std::string string(GLenum name) const;  // GetString, "" if null

  // Throws ContextLost if the driver was reset since the context was made.
  void throwIfLost() const;
  // Sets every state that passes rely on: others draw between our frames.
  void setKnownState() const;
};

}  // namespace isolux::render
