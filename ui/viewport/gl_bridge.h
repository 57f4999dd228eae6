// Loads the renderer's GL table from the current Qt context. On its own because Qt's GL headers and the
// renderer's do not belong into one translation unit.
#pragma once

#include <functional>
#include <memory>
#include <string>

namespace isolux::render {
struct Gl;
}

namespace isolux::ui {

// Throws base::Error{graphics}.
std::shared_ptr<const render::Gl> loadGl(const std::function<void*(const char* name)>& getProcAddress);
// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5 (Core Profile) Mesa 22.3.6".
std::string describeGl(const render::Gl& gl);
bool isSoftware(const render::Gl& gl);  // a CPU rasteriser

}  // namespace isolux::ui
