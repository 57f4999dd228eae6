// Lists the renderer's passes.
#pragma once

#include "render/graph/pass.h"

namespace isolux::render {

// Returns the passes in the order in which they run: each after those whose images it reads.
PassList makePasses();

}  // namespace isolux::render
