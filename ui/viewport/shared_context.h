// Provides the picture thread with a context that shares objects with the window's.
#pragma once

#include <functional>
#include <memory>

#include "render/gl/gl_context.h"

namespace isolux::ui {

// Returns a function that creates the context, on the thread that calls it. It throws base::Error{graphics}
// if the driver cannot share. Requires Qt's global share context and the window's thread.
std::function<std::unique_ptr<render::OffscreenContext>()> sharedContext();

}  // namespace isolux::ui
