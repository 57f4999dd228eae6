// Sets the GL state that passes rely on.
#pragma once

namespace isolux::render {

struct Gl;

// Others draw between our frames: every state a pass relies on is set here.
void setKnownState(const Gl& gl);

}  // namespace isolux::render
