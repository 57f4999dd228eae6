// Colours the surface of a label map by the label of each surface point.
#pragma once

#include "render/passes/frame_state.h"

namespace isolux::render {

// Looks the label of each surface point up (volume::labelAt), on the CPU for both executors. Writes its
// colour, linear RGB, and the label; kNoValue where there is none. Labels are floats: those of 2^24 and more
// are rounded.
Pass labelPass();

}  // namespace isolux::render
