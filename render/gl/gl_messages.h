// Records the driver's error messages about GL calls (KHR_debug).
//
// Messages are stored per thread, since a context belongs to one thread and the driver reports within the
// faulty call. The objects check for GL_OUT_OF_MEMORY themselves, handle it and remove it from the messages
// (gl_objects.cpp).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace isolux::render {

struct Gl;

// Starts to record errors of the current context. Called by Gl::load().
void listenToGl(const Gl& gl);

// Returns the errors of this thread's GL calls so far, the oldest first, at most sixty-four.
const std::vector<std::string>& glErrors();
// Returns the number of all errors.
std::size_t glErrorCount();
void forgetGlErrors();

}  // namespace isolux::render
