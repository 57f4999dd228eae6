// A picture of any size: in one frame where the GPU takes that with ease, otherwise in tiles, put together
// here.
//
// A tile is the same picture, cut out: rays, footprints, background, dither and legend are those of the
// whole. What a pixel reads of its neighbours (streaks, suggestive contours) is drawn with a margin around
// each tile.
#pragma once

#include <vector>

#include "base/progress.h"
#include "render/graph/frame.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace isolux::render {

struct StillPicture {
  FrameReport report;          // of all tiles: times are summed, shares of pixels averaged
  ColorImage color;            // empty unless the request has colour
  LinearImage linear;          // empty unless the request has it
  std::vector<AovImage> aovs;  // in the order of the request
};

// The tiles a request is drawn in, from the bottom row up; one without a tile: a single frame.
std::vector<FrameRequest> tilesOf(const scene::Scene& resolved, const FrameRequest& request);

// Throws base::Error: as Renderer::render(), Error{memory} for images that this machine has no room for, and
// Error{interrupted} between tiles.
StillPicture drawStill(Renderer& renderer, const scene::Scene& resolved, const FrameRequest& request,
                       base::Progress& progress);

}  // namespace isolux::render
