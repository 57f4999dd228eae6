// Slices of fewer values than pixels, for while something is dragged.
#pragma once

#include "render/graph/frame.h"
#include "volume/slice/slice_plane.h"

namespace isolux::app {

// One pixel for each square of coarse x coarse pixels, at its middle; the last ones may reach beyond the
// picture. coarse >= 1; 1 is the plane itself.
volume::SlicePlane coarsened(const volume::SlicePlane& plane, int coarse);

// A picture of coarsened(plane, coarse) at the plane's size: pixels between the middles of squares are what
// lies linearly between their colours (in sRGB), those beyond the outermost middles are theirs.
render::ColorImage enlarged(render::ColorImage picture, int coarse, glm::ivec2 size);

}  // namespace isolux::app
