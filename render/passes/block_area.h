// The part of the picture that active blocks lie in, for shaders that cast rays: a rectangle around all of
// them. The processor, which has the hits, knows better.
#pragma once

#include "volume/cast/picture_area.h"

namespace isolux::render {

struct FrameState;

volume::PictureArea blockArea(const FrameState& frame);  // of the rays; where the volume has cells

}  // namespace isolux::render
