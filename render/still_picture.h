// Draws an image of any size: in one frame if it is small enough for the GPU and its images for their budget,
// otherwise in tiles that are assembled here.
//
// A tile is a part of the same image: rays, footprints, background, dither and legend are those of the whole.
// Effects that read neighbouring pixels (streaks, suggestive contours) are drawn with a margin around each
// tile.
#pragma once

#include <limits>
#include <vector>

#include "base/progress.h"
#include "render/graph/frame.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace isolux::render {

struct StillPicture {
  FrameReport report;          // of all tiles: times are summed, fractions of pixels averaged
  ColorImage color;            // empty unless the request has colour
  LinearImage linear;          // empty unless the request has it
  std::vector<AovImage> aovs;  // in the order of the request
};

// Returns the tiles of a request, from the bottom row up. One request without a tile means a single frame.
// `imageBudget`: bytes, Renderer::imageBudget().
std::vector<FrameRequest> tilesOf(const scene::Scene& resolved, const FrameRequest& request,
                                  std::size_t imageBudget = std::numeric_limits<std::size_t>::max());

// Draws the image. Throws base::Error as Renderer::render(), Error{memory} if the images do not fit into
// memory, and Error{interrupted} between tiles.
StillPicture drawStill(Renderer& renderer, const scene::Scene& resolved, const FrameRequest& request,
                       base::Progress& progress);

}  // namespace isolux::render
