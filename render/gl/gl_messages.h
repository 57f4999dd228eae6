// What the driver has to say about our GL calls (KHR_debug): errors would pass unseen otherwise.
//
// Messages are kept by thread, since a context belongs to one thread and the driver reports within the call
// at fault. GL_OUT_OF_MEMORY, which the objects look for themselves and answer (gl_objects.cpp), is forgotten
// there.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace isolux::render {

struct Gl;

// From now on errors in the current context are kept. Gl::load() calls it.
void listenToGl(const Gl& gl);

// Errors of this thread's GL calls so far, the oldest first; the first sixty-four of them.
const std::vector<std::string>& glErrors();
// How many there were in all.
std::size_t glErrorCount();
void forgetGlErrors();

}  // namespace isolux::render
