// A built-in light as a small picture: a white ball that it lights, as who looks at the volume's front sees
// it.
#pragma once

#include "render/graph/frame.h"
#include "scene/choices.h"

namespace isolux::app {

// Square, `pixels` wide, opaque. A few milliseconds. Any thread.
render::ColorImage litBall(scene::BuiltInLight light, int pixels);

}  // namespace isolux::app
